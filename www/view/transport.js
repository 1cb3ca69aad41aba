/**
 * The animation bar: play and pause, step, scrub, frame number and time, and the strip of statuses.
 *
 * @typedef {import('../store.js').Store} Store
 * @typedef {import('../player.js').Player} Player
 */
import { short } from '../format.js';
import { byId, setText } from '../dom.js';
import { drawStrip } from './strip.js';
import { frameSentence } from './words.js';

/** @param {Store} store @param {Player} player */
export function createTransport(store, player) {
  /** @type {HTMLInputElement} */
  const scrub = byId('scrub');
  const play = byId('play');
  /** @type {SVGSVGElement} */
  const strip = byId('strip');

  const toggle = () => (player.paused ? player.play() : player.pause());
  /** @param {number} frames */
  const step = (frames) => {
    player.pause();
    player.frame += frames;
  };

  play.addEventListener('click', toggle);
  byId('step-back').addEventListener('click', () => step(-1));
  byId('step-forward').addEventListener('click', () => step(1));
  byId('to-start').addEventListener('click', () => step(-Infinity));
  scrub.addEventListener('input', () => {
    player.pause();
    player.frame = Number(scrub.value);
  });
  document.addEventListener('keydown', (event) => {
    const target = /** @type {Element | null} */ (event.target);
    if (event.key !== ' ' || event.ctrlKey || target?.closest('input:not([type=range]), select, button, summary, textarea, [role=tab]')) return;
    event.preventDefault();
    toggle();
  });

  function showPlayhead() {
    const { motion, document } = store.result;
    if (!motion) return;
    const { frame, playing } = store.view;
    scrub.value = String(frame);
    scrub.setAttribute('aria-valuetext', frameSentence(store));
    play.setAttribute('aria-label', playing ? 'Pause' : 'Play');
    play.classList.toggle('playing', playing);
    const timed = document?.motion.key_frames[0]?.time != null;
    setText(byId('frame-number'), `${frame + 1} / ${motion.frames}`);
    setText(byId('frame-time'), `t = ${motion.time[frame].toFixed(timed ? 2 : 3)}${timed ? ' s' : ''}`);
  }

  store.subscribe('view', showPlayhead);
  store.subscribe('result', () => {
    const { motion } = store.result;
    if (!motion) return;
    if (scrub.max !== String(motion.frames - 1)) scrub.max = String(motion.frames - 1);
    drawStrip(strip, motion);
    strip.setAttribute('aria-label', `Gap at every frame, at most ${short(Math.sqrt(2 * Math.max(...motion.metric)))}`);
    showPlayhead();
  });
}

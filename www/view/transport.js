/**
 * The animation bar: play and pause, step, what happens at the end, speed, frame number and time, and the track.
 *
 * @typedef {import('../store.js').Store} Store
 * @typedef {import('../player.js').Player} Player
 */
import { byId, setText } from '../dom.js';
import { isTimed } from '../playhead.js';
import { createFrameField } from './frame-field.js';
import { createTrack } from './track.js';

/** What takes keys itself. */
const TAKES_KEYS = 'input:not([type=range]), select, button, summary, textarea, [role=tab]';
const TAKES_TEXT = 'input:not([type=range], [type=checkbox]), select, textarea';

/** @param {Store} store @param {Player} player */
export function createTransport(store, player) {
  const play = byId('play');
  /** @type {HTMLSelectElement} */
  const loop = byId('loop');
  /** @type {HTMLSelectElement} */
  const speed = byId('speed');

  const toggle = () => (player.paused ? player.play() : player.pause());
  /** @param {number} frame */
  const goTo = (frame) => {
    player.pause();
    player.frame = frame;
  };
  const step = (/** @type {number} */ frames) => goTo(player.frame + frames);

  createTrack(store, goTo);
  createFrameField(store, goTo);
  play.addEventListener('click', toggle);
  byId('step-back').addEventListener('click', () => step(-1));
  byId('step-forward').addEventListener('click', () => step(1));
  byId('to-start').addEventListener('click', () => step(-Infinity));
  byId('to-end').addEventListener('click', () => step(Infinity));
  byId('back-to-motion').addEventListener('click', () => {
    step(0);
    play.focus();
  });
  loop.addEventListener('change', () => {
    player.loop = /** @type {import('../playhead.js').Loop} */ (loop.value);
  });
  speed.addEventListener('change', () => {
    player.playbackRate = Number(speed.value);
  });

  document.addEventListener('keydown', (event) => {
    const target = /** @type {Element | null} */ (event.target);
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === ' ' && !target?.closest(TAKES_KEYS)) {
      event.preventDefault();
      toggle();
    }
    // Only beside the animation: single letters everywhere would be in the way of people who speak to their browser.
    const steps = { ',': -1, '.': 1 }[event.key];
    if (steps && target?.closest('.transport, #charts') && !target.closest(TAKES_TEXT)) step(steps);
  });

  function show() {
    const { motion, document } = store.result;
    if (!motion) return;
    const { frame, playing, posture } = store.view;
    play.setAttribute('aria-label', playing ? 'Pause' : 'Play');
    play.classList.toggle('playing', playing);
    loop.value = store.view.loop;
    speed.value = String(store.view.speed);
    byId('by-hand').hidden = posture === null;
    setText(byId('by-hand-text'), posture?.note ?? 'Moved by hand.');
    const timed = isTimed(document);
    setText(byId('frame-number'), `${frame + 1} / ${motion.frames}`);
    setText(byId('frame-time'), `t = ${motion.time[frame].toFixed(timed ? 2 : 3)}${timed ? ' s' : ''}`);
    byId('frame-time').title = timed ? 'Time' : 'From 0 to 1: the key frames name no times';
  }
  store.subscribe('view', show);
  store.subscribe('result', show);
}

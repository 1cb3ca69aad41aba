/**
 * The animation bar: play and pause, step, what happens at the end, speed, frame number and time, and the track.
 */
import { setText, targetOf } from '../ui/dom.js';
import { isTimed } from '../core/playhead.js';
import { keyTip, onKeys } from '../ui/keys.js';
import { createFrameField } from './frame-field.js';
import { createTrack } from './track.js';

/** What takes keys itself. */
const TAKES_KEYS = 'input:not([type=range]), select, button, summary, textarea, [role=tab]';
const TAKES_TEXT = 'input:not([type=range], [type=checkbox]), select, textarea';

/** @param {Pick<import('../element/workbench.js').App, 'find' | 'store' | 'player' | 'keys' | 'signal'>} app */
export function createTransport(app) {
  const { find, store, player, keys, signal } = app;
  const play = find('play');
  /** @type {HTMLSelectElement} */
  const loop = find('loop');
  /** @type {HTMLSelectElement} */
  const speed = find('speed');

  const toggle = () => (player.paused ? player.play() : player.pause());
  /** @param {number} frame */
  const goTo = (frame) => {
    player.pause();
    player.frame = frame;
  };
  const step = (/** @type {number} */ frames) => goTo(player.frame + frames);

  createTrack(app, goTo);
  createFrameField(app, goTo);
  play.addEventListener('click', toggle);
  find('step-back').addEventListener('click', () => step(-1));
  find('step-forward').addEventListener('click', () => step(1));
  find('to-start').addEventListener('click', () => step(-Infinity));
  find('to-end').addEventListener('click', () => step(Infinity));
  find('back-to-motion').addEventListener('click', () => {
    step(0);
    play.focus();
  });
  loop.addEventListener('change', () => {
    player.loop = /** @type {import('../core/playhead.js').Loop} */ (loop.value);
  });
  speed.addEventListener('change', () => {
    player.playbackRate = Number(speed.value);
  });

  onKeys(
    keys,
    {
      play(event) {
        if (targetOf(event)?.closest(TAKES_KEYS)) return false;
        toggle();
      },
      // Only beside the animation: single letters everywhere would be in the way of people who speak to their browser.
      step(event, at) {
        const target = targetOf(event);
        if (!target?.closest('.transport, #charts') || target.closest(TAKES_TEXT)) return false;
        step(at ? 1 : -1);
      },
    },
    { signal },
  );
  keyTip(find('to-start'), 'To the first frame', 'ends');
  keyTip(find('step-back'), 'One frame back', 'step');
  keyTip(play, 'Play or pause', 'play');
  keyTip(find('step-forward'), 'One frame on', 'step', 1);
  keyTip(find('to-end'), 'To the last frame', 'ends', 1);

  let shown = '';
  function show() {
    const { motion, doc } = store.result;
    if (!motion) return;
    const { frame, playing, posture, loop: end, speed: factor } = store.view;
    // A hand tells the view much that is not shown here.
    const now = JSON.stringify([frame, motion.goal_frames, motion.time[frame], isTimed(doc), playing, posture && (posture.note ?? ''), end, factor]);
    if (now === shown) return;
    shown = now;
    play.setAttribute('aria-label', playing ? 'Pause' : 'Play');
    play.classList.toggle('playing', playing);
    loop.value = end;
    showSpeed();
    find('by-hand').hidden = posture === null;
    setText(find('by-hand-text'), posture?.note ?? 'Moved by hand.');
    const timed = isTimed(doc);
    setText(find('frame-number'), `${frame + 1} / ${motion.goal_frames}`);
    setText(find('frame-time'), `t = ${motion.time[frame].toFixed(timed ? 2 : 3).replace('-', '−')}${timed ? ' s' : ''}`);
    find('frame-time').title = timed ? 'Time' : 'From 0 to 1: the key frames name no times';
  }
  /** A speed that is none of those offered is offered too. */
  function showSpeed() {
    const value = String(store.view.speed);
    if (![...speed.options].some((option) => option.value === value)) speed.add(new Option(`${value}×`, value));
    speed.value = value;
  }
  store.subscribe('view', show);
  store.subscribe('result', show);
  show();
}

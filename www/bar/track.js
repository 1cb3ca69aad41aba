/**
 * The track of the animation bar: strip, key frames, playhead and slider as one control, by pointer, touch and keyboard.
 * The slider itself is not drawn; it has the focus, the keys and the words.
 */
import { atRest } from '../core/at-rest.js';
import { keyFramesOf } from '../core/key-frames.js';
import { drivesJoints, told } from '../core/driven.js';
import { angle, length } from '../core/format.js';
import { setText } from '../ui/dom.js';
import { onKeys } from '../ui/keys.js';
import { html, nothing, render } from '../ui/render.js';
import { allTimes, keyFrameFrames } from '../core/playhead.js';
import { keyFrameIn } from '../core/row-window.js';
import { spreadOver } from '../core/spread.js';
import { drawStrip } from './strip.js';
import { countStatuses, frameSentence, partSentence, largestGaps, statusName, statusWords } from '../core/status-words.js';

const PAGE = 10;
/** Least share of the track beside a key frame in which its name is written. */
const ROOM = 0.12;

/** At most so many key frames have a tick, evenly spread. */
const TICKS = 61;

/** @param {Pick<import('../element/workbench.js').App, 'find' | 'store'>} app @param {(frame: number) => void} goTo */
export function createTrack({ find, store }, goTo) {
  const track = find('track');
  const lane = find('lane');
  const ticks = find('ticks');
  const playhead = find('strip-playhead');
  const tip = find('strip-tip');
  /** @type {HTMLInputElement} */
  const scrub = find('scrub');
  /** @type {SVGSVGElement} */
  const strip = find('strip');
  /** The motion that stands in it. @type {import('../core/types.js').Motion | null} */
  let taken = null;
  /** Of each key frame of that. @type {number[]} */
  let keys = [];

  /** The last frame of the goal motion: so far goes the track. */
  const last = () => Math.max(1, (store.result.motion?.goal_frames ?? 1) - 1);
  const share = (/** @type {number} */ frame) => `${(100 * frame) / last()}%`;

  /** @param {import('../core/types.js').Motion} motion */
  function most(motion) {
    const { shift, turn } = largestGaps(motion);
    return `at most ${length(shift.value, store.result.doc?.length_unit)} and ${angle(turn.value)}`;
  }

  /** @param {PointerEvent} event */
  function frameUnder(event) {
    const tick = /** @type {HTMLElement | null} */ (/** @type {Element} */ (event.target).closest('.tick'));
    if (tick && event.type === 'pointerdown') return Number(tick.dataset.frame);
    const { left, width } = lane.getBoundingClientRect();
    return Math.round(Math.min(1, Math.max(0, (event.clientX - left) / width)) * last());
  }

  /** @param {number} frame */
  function tell(frame) {
    const { motion, doc } = store.result;
    if (!motion || frame >= motion.frames) return;
    const { sign, word } = statusWords(statusName(motion, frame));
    const more = drivesJoints(motion) ? told.words.drivenWords(motion, doc, frame) : `gap ${length(motion.translation_gap[frame], doc?.length_unit)}, ${angle(motion.rotation_gap[frame])}`;
    setText(tip, `frame ${frame + 1}: ${sign} ${word.toLowerCase()}, ${more}`);
    tip.hidden = false;
    const at = (frame / last()) * lane.clientWidth + lane.offsetLeft;
    tip.style.left = `${Math.min(track.clientWidth - tip.offsetWidth, Math.max(0, at - tip.offsetWidth / 2))}px`;
  }

  track.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    event.preventDefault();
    track.setPointerCapture(event.pointerId);
    scrub.focus({ preventScroll: true });
    const frame = frameUnder(event);
    goTo(frame);
    tell(frame);
  });
  track.addEventListener('pointermove', (event) => {
    const frame = frameUnder(event);
    const held = track.hasPointerCapture(event.pointerId);
    if (held) goTo(frame);
    if (held || event.pointerType !== 'touch') tell(frame);
  });
  for (const end of ['pointerleave', 'pointercancel', 'lostpointercapture']) {
    track.addEventListener(end, () => {
      tip.hidden = true;
    });
  }

  scrub.addEventListener('input', () => goTo(Number(scrub.value)));
  onKeys(scrub, {
    tenFrames: (_, at) => goTo(store.view.frame + (at ? -PAGE : PAGE)),
    keyFrame(_, at) {
      const { frame } = store.view;
      goTo(at ? (keys.find((key) => key > frame) ?? last()) : (keys.filter((key) => key < frame).at(-1) ?? 0));
    },
  });

  /** What the ticks were drawn of. @type {unknown[]} */
  let ticked = [];

  function showTicks() {
    const { doc, motion } = store.result;
    const { selected, hovered } = store.view;
    if (!doc) return;
    const now = [doc, motion, keyFrameIn(selected), keyFrameIn(hovered)];
    if (now.every((part, at) => part === ticked[at])) return;
    ticked = now;
    const some = spreadOver(keys.length, TICKS, keyFrameIn(selected));
    render(
      some.map((i, at) => {
        const frame = keys[i];
        const name = keyFramesOf(doc)[i].name || `key frame ${i + 1}`;
        const place = `motion.key_frames[${i}]`;
        const room = Math.min(...[keys[some[at - 1]], keys[some[at + 1]]].filter((other) => other !== undefined).map((other) => Math.abs(other - frame))) / last();
        // By a screen reader; a pointer has gone there when it went down.
        const click = (/** @type {MouseEvent} */ event) => event.detail === 0 && goTo(frame);
        const leave = () => store.view.hovered === place && store.setView({ hovered: '' });
        return html`<button
          class=${place === selected || place === hovered ? 'tick marked' : 'tick'}
          tabindex="-1" title=${`${name}, frame ${frame + 1}`} aria-label=${`To key frame ${name}, frame ${frame + 1}`}
          data-frame=${frame} data-place=${place} .style=${`left: ${share(frame)}; --room: ${room}`}
          @click=${click} @pointerenter=${() => store.setView({ hovered: place })} @pointerleave=${leave}
        >${room >= ROOM ? html`<span>${name}</span>` : nothing}</button>`;
      }),
      ticks,
    );
  }

  function show() {
    const { motion } = store.result;
    if (!motion) return;
    // The playhead of another motion may be set before its result is told here.
    if (motion !== taken) return take();
    const { frame, posture } = store.view;
    scrub.value = String(frame);
    playhead.style.left = share(frame);
    track.classList.toggle('away', posture !== null);
  }

  function tellFrame() {
    if (!taken) return;
    scrub.setAttribute('aria-valuetext', frameSentence(store));
    showTicks();
  }

  function tellMotion() {
    if (!taken) return;
    const what = drivesJoints(taken) ? 'Every frame' : `Gap at every frame, ${most(taken)}`;
    strip.setAttribute('aria-label', `${what}: ${countStatuses(taken)}. ${partSentence(taken)}`.trim());
  }

  store.subscribe('view', show);
  function take() {
    const { motion, plain } = store.result;
    if (!motion || !plain) return;
    taken = motion;
    keys = keyFrameFrames(plain, allTimes(motion));
    if (scrub.max !== String(motion.frames - 1)) scrub.max = String(motion.frames - 1);
    drawStrip(strip, motion);
    show();
  }
  store.subscribe('result', take);
  take();
  atRest(store, ['result'], tellMotion);
  atRest(store, ['result', 'view'], tellFrame);
  tellMotion();
  tellFrame();
}

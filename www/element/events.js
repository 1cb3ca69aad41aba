/**
 * The events of <synthetica-linkage>, and its attributes kept in step with what a person chooses.
 *
 * @typedef {import('./element.js').LinkageError} LinkageError
 */
import { MEANINGS, WRITINGS, write } from './attributes.js';

/** How long after the last edit it counts as finished, in milliseconds. */
const SETTLED = 300;

/**
 * @param {import('./media-properties.js').LinkageWords} element
 * @param {object} inside
 * @param {() => boolean} inside.isEdit whether the document changes by an edit, not by opening another
 * @param {() => boolean} inside.isFirst whether the next motion is the first of its document
 * @param {() => void} inside.begin the first motion is there
 * @param {(error: LinkageError | null) => void} inside.fail
 */
export function announce(element, { isEdit, isFirst, begin, fail }) {
  const { store, player } = element.linkage;
  const tell = (/** @type {string} */ name, /** @type {unknown} */ detail = null) => element.dispatchEvent(new CustomEvent(name, { detail }));
  let edited = false;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let settling;
  let { view, result } = store;

  store.subscribe('document', () => {
    if (!isEdit()) return;
    edited = true;
    tell('input');
  });

  store.subscribe('result', () => {
    const { motion, fault, trouble } = store.result;
    const wrong = fault !== result.fault || trouble !== result.trouble;
    const planned = motion !== null && motion !== result.motion;
    ({ result } = store);
    if (wrong) {
      const error = fault ? { message: fault.message, where: fault.where, code: fault.code } : trouble ? { message: trouble, where: '', code: 'failure' } : null;
      fail(error);
      if (error) tell('error', error);
    }
    if (planned && isFirst() && store.result.doc === store.doc) {
      begin();
      tell('ready');
    }
    clearTimeout(settling);
    if (!edited || fault || store.result.doc !== store.doc) return;
    settling = setTimeout(() => {
      edited = false;
      tell('change');
    }, SETTLED);
  });

  store.subscribe('view', () => {
    const before = view;
    ({ view } = store);
    const { frame, playing, loop, speed, side } = view;
    if (frame !== before.frame) tell('framechange', { frame, time: player.currentTime });
    if (playing !== before.playing) tell(playing ? 'play' : 'pause');
    if (loop !== before.loop) keep('loop', loop, WRITINGS.loop(loop));
    if (speed !== before.speed) keep('speed', speed, WRITINGS.speed(speed));
    if (side !== before.side) keep('view', side, WRITINGS.view(side));
    // Only while it rests: an attribute that changes with every picture helps nobody.
    if (!playing && !isFirst()) keep('frame', frame, WRITINGS.frame(frame));
  });

  /** Writes an attribute that means something else. @param {'loop' | 'speed' | 'view' | 'frame'} name @param {unknown} state @param {string | null} text */
  function keep(name, state, text) {
    let meaning;
    try {
      meaning = MEANINGS[name](element.getAttribute(name));
    } catch {
      // It has been refused, and stands there for its author to see until another choice takes its place.
    }
    if (meaning !== state) write(element, name, text);
  }
}

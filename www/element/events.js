/**
 * The events of <synthetica-linkage>, and its attributes kept in step with what a person chooses.
 *
 * @typedef {import('./element.js').LinkageError} LinkageError
 */
import { ATTRIBUTES, modeOf, write } from './attributes.js';

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
  const { store, player, playhead } = element.parts;
  const tell = (/** @type {string} */ name, /** @type {unknown} */ detail = null) => element.dispatchEvent(new CustomEvent(name, { detail }));
  let edited = false;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let settling;

  store.subscribe('document', () => {
    edited = isEdit();
    if (edited) tell('input');
  });

  store.select(({ result }) => result.fault ?? result.trouble, (wrong) => {
    const error = typeof wrong === 'object' ? { message: wrong.message, where: wrong.where, code: wrong.code } : wrong ? { message: wrong, where: '', code: 'failure' } : null;
    fail(error);
    if (error) tell('error', error);
  });
  store.select(({ result }) => result.motion, (motion) => {
    if (!motion || !isFirst() || store.result.doc !== store.doc) return;
    begin();
    tell('ready');
  });
  store.subscribe('result', () => {
    clearTimeout(settling);
    if (!edited || store.result.fault || store.result.doc !== store.doc) return;
    settling = setTimeout(() => {
      edited = false;
      tell('change');
    }, SETTLED);
  });

  store.select(({ view }) => view.frame, (frame) => store.result.motion && tell('framechange', { frame, time: playhead.time }));
  store.select(({ view }) => view.playing, (playing) => tell(playing ? 'play' : 'pause'));
  store.select(({ view }) => view.loop, (loop) => {
    if (modeOf(element) === loop) return;
    element.loop = loop === 'loop';
    element.bounce = loop === 'bounce';
  });
  store.select(({ view }) => view.speed, (speed) => keep('speed', speed));
  store.select(({ view }) => view.side, (side) => keep('view', side));
  let rested = 0;
  // Only while it rests: an attribute that changes with every picture helps nobody.
  store.select(
    ({ view }) => (rested = view.playing || isFirst() ? rested : view.frame),
    (frame) => keep('frame', frame),
  );
  player.tell = tell;

  /** Writes an attribute that means something else. @template {'speed' | 'view' | 'frame'} N @param {N} name @param {ReturnType<typeof ATTRIBUTES[N]['read']>} state */
  function keep(name, state) {
    /** @type {import('./attributes.js').Attribute<any>} */
    const attribute = ATTRIBUTES[name];
    let meaning;
    try {
      meaning = attribute.read(element.getAttribute(name));
    } catch {
      // It has been refused, and stands there for its author to see until another choice takes its place.
    }
    if (meaning !== state) write(element, name, attribute.write(state));
  }
}

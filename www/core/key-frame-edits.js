/**
 * Pure functions from document to document for key frames, one per user action.
 *
 * @typedef {import('./types.js').MechanismDocument} MechanismDocument
 * @typedef {import('./types.js').Entry} Entry
 * @typedef {import('./types.js').KeyFrame} KeyFrame
 */
import { keyFramesOf } from './key-frames.js';
import { freshName, insert, moved, without } from './lists.js';
import { withValueAt } from './path.js';

/** @param {MechanismDocument} doc @param {KeyFrame[]} keys */
const withKeys = (doc, keys) => ({ ...doc, motion: { ...doc.motion, key_frames: keys } });

/**
 * A new key frame at a place among the others; where they have times it comes between its neighbours, or one unit
 * after the last.
 * @param {MechanismDocument} doc
 * @param {KeyFrame} fresh
 * @param {number} [at] at the end unless told
 */
export function addKeyFrame(doc, fresh, at = keyFramesOf(doc).length) {
  const keys = keyFramesOf(doc);
  return duplicateTime(withKeys(doc, insert(keys, at, { ...fresh, name: freshName('key', keys) })), at);
}

/**
 * Moves a pose among the key frames; the times stay where they are, since they grow along the list.
 * @param {MechanismDocument} doc
 * @param {number} from
 * @param {number} to
 */
export function moveKeyFrame(doc, from, to) {
  const keys = keyFramesOf(doc);
  const timed = moved(keys, from, to).map(({ time: _, ...pose }, index) => ({
    ...pose,
    ...(keys[index].time === undefined ? {} : { time: keys[index].time }),
  }));
  return withKeys(doc, timed);
}

/** @param {MechanismDocument} doc @param {number} key */
export function duplicateKeyFrame(doc, key) {
  const keys = keyFramesOf(doc);
  return duplicateTime(withKeys(doc, insert(keys, key + 1, { ...keys[key], name: freshName('key', keys) })), key + 1);
}

/**
 * Gives the new key frame at `index` a time between its neighbours, if key frames have times.
 * @param {MechanismDocument} doc
 * @param {number} index
 */
function duplicateTime(doc, index) {
  const keys = keyFramesOf(doc);
  const before = keys[index - 1]?.time;
  if (before == null) return doc;
  const after = keys[index + 1]?.time;
  const time = timeBetween(before, after);
  return withValueAt(doc, `motion.key_frames[${index}].time`, time);
}

/** A time between two, or one unit after the first; of expressions it is one. @param {Entry} before @param {Entry | null | undefined} after @returns {Entry} */
function timeBetween(before, after) {
  if (typeof before === 'number' && typeof after !== 'string') return after == null ? before + 1 : (before + after) / 2;
  return after == null ? `(${before})+1` : `((${before})+(${after}))/2`;
}

/**
 * Moves a key frame; coordinates that are not given stay.
 * @param {MechanismDocument} doc
 * @param {number} key
 * @param {import('./types.js').Frame} frame
 */
export const setKeyFramePose = (doc, key, frame) =>
  withKeys(doc, keyFramesOf(doc).map((old, index) => (index === key ? { ...old, ...frame } : old)));

/** @param {MechanismDocument} doc @param {number} key */
export const removeKeyFrame = (doc, key) => withKeys(doc, without(keyFramesOf(doc), key));

/**
 * Sets some key frames' times at once, as given; those of the others are made up only where there are none yet. Without a
 * single one given, no key frame has a time.
 * @param {MechanismDocument} doc
 * @param {[key: number, value: Entry | undefined][]} times
 */
export function setTimes(doc, times) {
  const [first] = times.filter(([, value]) => typeof value === 'number');
  const given = times.some(([, value]) => value !== undefined);
  const [key, value] = first ?? times[0];
  const all = setTime(doc, key, given ? value : undefined);
  return given ? times.reduce((next, [at, time]) => withValueAt(next, `motion.key_frames[${at}].time`, time), all) : all;
}

/**
 * Sets one key frame's time. Either all have a time or none: the first one typed gives the others even steps,
 * and clearing one clears all.
 * @param {MechanismDocument} doc
 * @param {number} key
 * @param {Entry | undefined} value
 */
export function setTime(doc, key, value) {
  // Steps of 1 after the first key frame, else so that the first is at 0.
  const even = (/** @type {number} */ index) => {
    if (typeof value !== 'number') return index;
    return key === 0 ? value + index : (value / key) * index;
  };
  const keys = keyFramesOf(doc).map(({ time, ...rest }, index) => {
    if (value === undefined) return rest;
    return { ...rest, time: index === key ? value : (time ?? even(index)) };
  });
  return withKeys(doc, keys);
}

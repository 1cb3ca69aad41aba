/**
 * Key frames of a table in the place of a document's, or behind them: a pure function from document to document.
 *
 * @typedef {import('./types.js').MechanismDocument} MechanismDocument
 * @typedef {import('./types.js').PoseTable['key_frames']} Taken
 */
import { frameAsWritten } from './document-angles.js';
import { keyFramesOf } from './key-frames.js';

/** Frames that a document without a number of them has. */
const FRAMES = 33;

/**
 * The motion gets a frame for each key frame where it has fewer: a tool path would be cut short between them.
 * @param {MechanismDocument} doc @param {Taken} fresh @param {boolean} append
 * @returns {MechanismDocument}
 */
export function takeKeyFrames(doc, fresh, append) {
  const old = append ? keyFramesOf(doc) : [];
  const named = timed(old, fresh).map(({ name, ...pose }) => (name ? { name, ...pose } : pose));
  const key_frames = [...old, ...named.map((key) => frameAsWritten(doc, key))];
  // A motion has key frames or drivers.
  const { drivers: _, ...motion } = doc.motion;
  const { frames = FRAMES } = motion;
  const more = typeof frames === 'number' && frames < key_frames.length ? { frames: key_frames.length } : {};
  return { ...doc, motion: { ...motion, ...more, key_frames } };
}

/**
 * Fresh key frames with times where the old ones have them, later than those, and without where they have none.
 * @param {import('./types.js').KeyFrame[]} old @param {Taken} fresh
 */
function timed(old, fresh) {
  if (!old.length) return fresh;
  const last = old[old.length - 1].time;
  if (typeof last !== 'number') return fresh.map(({ time: _, ...pose }) => pose);
  const [first, second] = fresh.map(({ time }) => time);
  if (first === undefined) return fresh.map((pose, index) => ({ ...pose, time: last + 1 + index }));
  const step = second === undefined ? 1 : second - first;
  const shift = first > last ? 0 : last + step - first;
  return fresh.map((pose) => ({ ...pose, time: (pose.time ?? 0) + shift }));
}

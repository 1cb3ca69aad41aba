/**
 * The shown pose as a frame of the document: what a new key frame is made of.
 */
import { frameAsWritten } from './document-angles.js';
import { frameOf } from './frame-of.js';
import { groupAt, shown } from './shown.js';

/** Decimals of the coordinates in lengths and degrees: finer than a person can see, and short to read. */
const DECIMALS = 9;

/** @param {number} value */
export const plain = (value) => Number(value.toFixed(DECIMALS)) || 0;

/**
 * @param {Parameters<typeof shown>[0] & {doc: import('./types.js').MechanismDocument}} store
 * @param {'pose' | 'goal'} which the reached pose or its goal
 * @returns {import('./types.js').KeyFrame | null} null where nothing is shown
 */
export function shownFrame(store, which) {
  const now = shown(store);
  if (!now) return null;
  const frame = frameOf(groupAt(now[which], now), store.result.plain?.motion.key_frames?.at(-1));
  return frameAsWritten(store.doc, Object.fromEntries(Object.entries(frame).map(([name, value]) => [name, plain(value)])));
}

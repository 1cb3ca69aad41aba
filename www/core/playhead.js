/**
 * The playhead's arithmetic: how time goes on in each mode, and which frame and key frame lie at a time. No DOM.
 *
 * @typedef {'once' | 'loop' | 'bounce'} Loop
 */
import { hasDrivers } from './driven.js';
import { keyFramesOf } from './key-frames.js';

/**
 * Where the playhead is after a step of the motion's own time.
 * @param {{time: number, forwards: boolean}} at
 * @param {number} step not negative
 * @param {{from: number, to: number, loop: Loop}} span
 * @returns {{time: number, forwards: boolean, ended: boolean}}
 */
export function advance({ time, forwards }, step, { from, to, loop }) {
  const length = to - from;
  if (!(length > 0)) return { time: from, forwards: true, ended: loop === 'once' };
  if (loop === 'bounce') {
    // Unfolded, the way there and back is one way twice as long.
    const there = forwards ? time - from : 2 * length - (time - from);
    const on = (there + step) % (2 * length);
    return on <= length ? { time: from + on, forwards: true, ended: false } : { time: from + 2 * length - on, forwards: false, ended: false };
  }
  const next = time + step;
  if (next < to || (next === to && loop === 'loop')) return { time: next, forwards: true, ended: false };
  if (loop === 'once') return { time: to, forwards: true, ended: true };
  return { time: from + ((next - from) % length), forwards: true, ended: false };
}

/** The frame nearest to a time: times grow with the frames. @param {ArrayLike<number>} times @param {number} time */
export function frameAt(times, time) {
  let low = 0;
  let high = times.length - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (times[middle] <= time) low = middle;
    else high = middle;
  }
  return time - times[low] <= times[high] - time ? low : high;
}

/** @param {import('./types.js').MechanismDocument | null} doc */
export const isTimed = (doc) => doc != null && (hasDrivers(doc) || keyFramesOf(doc)[0]?.time != null);

/**
 * The times of all frames of the goal motion, which are equally spaced: those that are not planned come after the others.
 * @param {import('./types.js').Motion} motion
 */
export function allTimes({ time, frames, goal_frames, partial }) {
  if (!partial) return time;
  const step = frames > 1 ? (time[frames - 1] - time[0]) / (frames - 1) : 1;
  return Float64Array.from({ length: goal_frames }, (_, frame) => (frame < frames ? time[frame] : time[0] + step * frame));
}

/**
 * The frame of each key frame; those without times are equally spaced.
 * @param {import('./types.js').MechanismDocument} doc @param {ArrayLike<number>} times of the frames
 */
export function keyFrameFrames(doc, times) {
  const keys = keyFramesOf(doc);
  const [from, to] = [times[0], times[times.length - 1]];
  return keys.map(({ time }, key) => frameAt(times, time == null ? from + ((to - from) * key) / Math.max(1, keys.length - 1) : Number(time)));
}

/**
 * The points of a curve through a column of poses, rounded where they are few, counted from the first one.
 */
import { POSE } from '../../core/poses.js';
import { spreadOver } from '../../core/spread.js';

/** A curve with fewer frames is rounded between them, so many pieces to each. */
const SMOOTH_BELOW = 64;
const PIECES = 6;

/** Of a longer motion so many points are drawn, evenly spread: no screen shows more. */
const MOST = 20_000;

/** The points' numbers, 3 each: one buffer for all curves, which are laid one after another. */
let points = new Float64Array(0);

/**
 * Without those that are almost the one before.
 * @param {Float64Array} column poses
 * @param {number} frames
 * @param {number} apart least distance
 * @returns {{points: Float64Array, count: number}} good until the next curve
 */
export function curveThrough(column, frames, apart) {
  const pieces = frames < SMOOTH_BELOW ? PIECES : 1;
  if (frames > MOST) [column, frames] = [thinned(column, frames), MOST];
  const last = (frames - 1) * pieces;
  if (points.length < 3 * (last + 1)) points = new Float64Array(4 * (last + 1));
  let count = 0;
  for (let i = 0; i <= last; i++) {
    const frame = Math.floor(i / pieces);
    const share = i / pieces - frame;
    let far = 0;
    for (let axis = 0; axis < 3; axis++) {
      const first = column[axis];
      const here = column[POSE * frame + axis] - first;
      let value = here;
      if (share > 0) {
        const before = column[POSE * Math.max(0, frame - 1) + axis] - first;
        const next = column[POSE * Math.min(frames - 1, frame + 1) + axis] - first;
        const after = column[POSE * Math.min(frames - 1, frame + 2) + axis] - first;
        value = rounded(before, here, next, after, share);
      }
      points[3 * count + axis] = value;
      if (count > 0) far += (value - points[3 * count - 3 + axis]) ** 2;
    }
    if (count === 0 || far > apart * apart) count++;
  }
  return { points, count };
}

/** @param {Float64Array} column @param {number} frames */
function thinned(column, frames) {
  const some = new Float64Array(POSE * MOST);
  spreadOver(frames, MOST).forEach((frame, i) => some.set(column.subarray(POSE * frame, POSE * (frame + 1)), POSE * i));
  return some;
}

/** A Catmull–Rom curve from b to c. @param {number} a @param {number} b @param {number} c @param {number} d @param {number} t */
const rounded = (a, b, c, d, t) => 0.5 * (2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t * t + (3 * b - a - 3 * c + d) * t * t * t);

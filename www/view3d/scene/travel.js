/**
 * How far rows slide along their axes over a motion.
 */
import { POSE } from '../../core/poses.js';

/** Numbers of one row: its seat, then the moved frame. */
const ROW = 2 * POSE;

/**
 * @param {import('../../core/types.js').Motion} motion
 * @param {number} first row @param {number} last row
 * @returns {import('./joint-shapes.js').Travel[]} row by row
 */
export function travels({ rows, frames }, first, last) {
  const stride = rows.length / frames;
  return Array.from({ length: last - first + 1 }, (_, row) => {
    let low = Infinity;
    let high = -Infinity;
    for (let frame = 0; frame < frames; frame++) {
      const travel = travelAt(rows, frame * stride + (first + row) * ROW);
      low = Math.min(low, travel);
      high = Math.max(high, travel);
    }
    return { low, high };
  });
}

/** From the seat at `at` to the moved frame behind it, along the seat's z. @param {Float64Array} rows @param {number} at */
function travelAt(rows, at) {
  const [x, y, z, w] = rows.subarray(at + 3, at + POSE);
  const along = (/** @type {number} */ axis) => rows[at + POSE + axis] - rows[at + axis];
  return along(0) * 2 * (x * z + w * y) + along(1) * 2 * (y * z - w * x) + along(2) * (1 - 2 * (x * x + y * y));
}

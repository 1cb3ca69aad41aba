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
  // Read one by one: a hand that drags a key frame has this done for all frames at every move.
  const x = rows[at + 3];
  const y = rows[at + 4];
  const z = rows[at + 5];
  const w = rows[at + 6];
  return (
    (rows[at + POSE] - rows[at]) * 2 * (x * z + w * y) +
    (rows[at + POSE + 1] - rows[at + 1]) * 2 * (y * z - w * x) +
    (rows[at + POSE + 2] - rows[at + 2]) * (1 - 2 * (x * x + y * y))
  );
}

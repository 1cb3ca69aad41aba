/**
 * Where the joints of a spherical linkage are drawn: all its axes meet in one point, and so do its rows; each joint stands on a ball
 * around that point, where its axis leaves it.
 *
 * @typedef {{centre: Vector3, reaches: number[]}} Ball how far each row is from the centre along its axis
 */
import { Vector3 } from 'three';
import { POSE, originOf, turnOf } from '../../core/poses.js';

/** How far an axis may pass the centre, as a share of the ball's radius. */
const EXACT = 1e-6;
/** Share of the mechanism's distances below which a base is at the centre, but for rounding. */
const ROUNDING = 1e-9;

/**
 * The ball is as large as the farthest base is away; 1 where all are at the centre.
 * @param {Pick<import('../../core/types.js').Motion, 'rows' | 'report'>} motion @returns {Ball | null} null where axes do not meet in one point
 */
export function ballOf({ rows, report: { chains } }) {
  const all = chains.flatMap((chain) => chain.rows);
  const second = all.findIndex(({ joint }) => joint > 0);
  if (second < 0 || all.some(({ kind }) => kind !== 'R')) return null;
  const centre = originOf(rows, 2 * second);
  let [radius, off] = [0, 0];
  const sides = all.map(({ joint }, row) => {
    const axis = new Vector3(0, 0, 1).applyQuaternion(turnOf(rows, 2 * row));
    const arm = originOf(rows, 2 * row).sub(centre);
    const along = arm.dot(axis);
    off = Math.max(off, arm.addScaledVector(axis, -along).length());
    // The first joint is on the side of its base.
    if (joint) return 1;
    radius = Math.max(radius, Math.abs(along));
    return along < 0 ? -1 : 1;
  });
  if (radius <= ROUNDING * Math.max(1, centre.length())) radius = 1;
  return off < EXACT * radius ? { centre, reaches: sides.map((side) => side * radius) } : null;
}

/** Rows of some frames with their origins on the ball. @param {Ball} ball @param {Float64Array} rows */
export function onBall({ centre, reaches }, rows) {
  const moved = rows.slice();
  for (let pose = 0; pose < rows.length / POSE; pose++) {
    new Vector3(0, 0, reaches[(pose >> 1) % reaches.length]).applyQuaternion(turnOf(rows, pose)).add(centre).toArray(moved, pose * POSE);
  }
  return moved;
}

/** Rows of some frames where they are drawn. @param {Float64Array} rows @param {import('../../core/types.js').Motion['report']} report */
export function drawnRows(rows, report) {
  const ball = ballOf({ rows, report });
  return ball ? onBall(ball, rows) : rows;
}

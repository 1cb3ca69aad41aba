/**
 * What the thing in hand and its arrows take of the canvas, which no name may cover: names take clicks.
 *
 * @typedef {import('../scene/label-layout.js').Box} Box
 */
import { Vector3 } from 'three';

/** Half of each square that is kept free, in pixels. */
const FREE = 7;

/** Where such squares lie along an arrow, to both of its ends. */
const ALONG = [-0.9, -0.7, -0.5, -0.3, 0.3, 0.5, 0.7, 0.9];

/**
 * Where a pose is on the canvas, in pixels.
 * @param {ArrayLike<number>} pose @param {import('three').Camera} camera @param {number} width @param {number} height
 */
export function onCanvas({ 0: x, 1: y, 2: z }, camera, width, height) {
  const seen = new Vector3(x, y, z).project(camera);
  return [((seen.x + 1) / 2) * width, ((1 - seen.y) / 2) * height];
}

/** @param {number[]} place of the thing in hand @param {Box[]} names of its arrows, one at the end of each @returns {Box[]} */
export function clearOfNames([x, y], names) {
  const ends = names.map((box) => [box.x + box.width / 2 - x, box.y + box.height / 2 - y]);
  const arrows = ends.flatMap(([right, down]) => ALONG.map((share) => [share * right, share * down]));
  // A gizmo has handles between its arrows too.
  const between = ends.map(([right, down], end) => [(right + ends[(end + 1) % ends.length][0]) / 4, (down + ends[(end + 1) % ends.length][1]) / 4]);
  return [[0, 0], ...arrows, ...between].map(([right, down]) => ({ x: x + right - FREE, y: y + down - FREE, width: 2 * FREE, height: 2 * FREE }));
}

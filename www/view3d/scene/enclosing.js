/**
 * How far from points a camera must stand, and how far aside, so that they fill a part of its picture: exact, for the direction
 * in which it looks.
 *
 * @typedef {{right: Vector3, up: Vector3, back: Vector3}} Axes of the camera, of length 1; back is towards it
 * @typedef {{left: number, right: number, low: number, high: number}} Edges of the part: how far it reaches to each side of the
 *   camera's axis, at distance 1, or for each unit of height where parallel lines stay parallel
 */
import { Vector3 } from 'three';

/**
 * An edge of the part is a plane through the camera: a point at x and, towards the camera, z is inside the right one where
 * x ≤ across + right·(distance − z), and a ball around it where it keeps its radius from that plane. That is linear in `across` and
 * the distance, so that one point decides for each edge, and two opposite ones for the distance.
 * @param {(visit: (point: Vector3) => void) => void} each walks through the points
 * @param {Vector3} from from where the results are measured
 * @param {Axes} axes
 * @param {Edges} edges
 * @param {boolean} flat whether parallel lines stay parallel: then the distance is half the height that is seen
 * @param {number} [radius] of a ball around each point
 * @returns {{across: number, above: number, distance: number, nearest: number}} `nearest` is the largest z; −∞ without points
 */
export function enclose(each, from, axes, edges, flat, radius = 0) {
  const depth = flat ? 0 : 1;
  const [left, right, low, high] = [edges.left, edges.right, edges.low, edges.high].map((edge) => edge * depth);
  const most = [-Infinity, -Infinity, -Infinity, -Infinity, -Infinity];
  const p = new Vector3();
  each((point) => {
    p.copy(point).sub(from);
    const [x, y, z] = [p.dot(axes.right), p.dot(axes.up), p.dot(axes.back)];
    most[0] = Math.max(most[0], left * z - x);
    most[1] = Math.max(most[1], right * z + x);
    most[2] = Math.max(most[2], low * z - y);
    most[3] = Math.max(most[3], high * z + y);
    most[4] = Math.max(most[4], z);
  });
  const [l, r, b, t] = [left, right, low, high].map((slope, side) => most[side] + radius * Math.hypot(1, slope));
  const distance = Math.max((l + r) / (edges.left + edges.right), (b + t) / (edges.low + edges.high));
  // In the middle between the nearest and the farthest that two opposite edges allow.
  const across = (r - l + (edges.left - edges.right) * distance) / 2;
  const above = (t - b + (edges.low - edges.high) * distance) / 2;
  return { across, above, distance, nearest: most[4] };
}

/**
 * The shares of such a part that points fill, across and up, about its middle.
 * @param {(visit: (point: Vector3) => void) => void} each
 * @param {Vector3} at what is seen in the middle of the part
 * @param {Axes} axes @param {Edges} edges the same to both sides @param {number} distance of the camera from there @param {boolean} flat
 * @param {number} radius of a ball around each point
 */
export function filled(each, at, { right, up, back }, edges, distance, flat, radius) {
  const most = [0, 0];
  const p = new Vector3();
  each((point) => {
    p.copy(point).sub(at);
    const depth = flat ? distance : distance - p.dot(back);
    const share = (/** @type {number} */ off, /** @type {number} */ slope) => (Math.abs(off) + radius * Math.hypot(1, slope)) / depth / slope;
    most[0] = Math.max(most[0], share(p.dot(right), edges.right));
    most[1] = Math.max(most[1], share(p.dot(up), edges.high));
  });
  return most;
}

/** How far from the middle of a view something stands, in shares of it, that fills a share of a part of it. @param {number} start @param {number} size of the part @param {number} share */
export function aside(start, size, share) {
  const [middle, spare] = [start + size / 2 - 0.5, (size * Math.max(0, 1 - share)) / 2];
  return middle - Math.max(-spare, Math.min(spare, middle));
}

/**
 * A pose in the document's coordinates: x, y, z, longitude, latitude and roll. Apart from poses.js, as the first view needs none.
 */
import { Matrix4, Quaternion } from 'three';

const RADIANS = Math.PI / 180;

/** Cosine of the latitude below which longitude and roll turn about one axis, and only their sum is known. */
export const POLE = 1e-8;

/**
 * The inverse of `frameMatrix` (poses.js).
 * @param {ArrayLike<number>} pose x y z, then the quaternion x y z w
 * @param {import('./types.js').Frame} [near] of the many angles of one turn, those nearest to this frame's
 * @returns {Record<'x' | 'y' | 'z' | 'longitude' | 'latitude' | 'roll', number>} degrees, length
 */
export function frameOf(pose, near) {
  const old = [near?.longitude, near?.latitude, near?.roll].map((value) => (typeof value === 'number' ? value : 0));
  // R = Y(b) X(a) Z(c), column by column.
  const [r11, r21, r31, , , r22, , , r13, r23, r33] = new Matrix4().makeRotationFromQuaternion(
    new Quaternion(pose[3], pose[4], pose[5], pose[6]),
  ).elements;
  const cosine = Math.hypot(r13, r33);
  const a = Math.atan2(-r23, cosine);
  let [b, c] = [Math.atan2(r13, r33), Math.atan2(r21, r22)];
  if (cosine < POLE) {
    // a = ∓90°: R = Y(b ± c) X(a), so the longitude may stay as it was.
    const sum = Math.atan2(-r31, r11);
    b = old[0] * RADIANS;
    c = a < 0 ? sum - b : b - sum;
  }
  const first = [b, -a, c].map((angle) => angle / RADIANS);
  // Over the pole: the other triple of the same turn.
  const second = [first[0] + 180, 180 - first[1], first[2] + 180];
  const [one, other] = [first, second].map((triple) => triple.map((angle, i) => nearest(angle, old[i])));
  const far = (/** @type {number[]} */ triple) => Math.hypot(...triple.map((angle, i) => angle - old[i]));
  const [longitude, latitude, roll] = far(other) < far(one) - 1e-9 ? other : one;
  return { x: pose[0], y: pose[1], z: pose[2], longitude, latitude, roll };
}

/** The angle of the same direction that is nearest to another. @param {number} angle @param {number} to in degrees */
const nearest = (angle, to) => angle - 360 * Math.round((angle - to) / 360);

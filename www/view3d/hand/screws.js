/**
 * Moving a pose along a screw: exp(s ξ) with ξ = (v, ω) taken at the pose's origin, in the fixed frame.
 */
import { Quaternion, Vector3 } from 'three';

/** Slower turning than this is a pure shift. */
const STILL = 1e-9;

/**
 * @param {{twist: ArrayLike<number>, origin: ArrayLike<number>}} screw `origin`: where v is the velocity
 * @param {number} s rad, or a length for a pure shift
 * @param {Vector3} point moved in place
 */
export function movePoint({ twist, origin }, s, point) {
  const v = new Vector3(twist[0], twist[1], twist[2]);
  const w = new Vector3(twist[3], twist[4], twist[5]);
  const rate = w.length();
  if (rate < STILL) return point.addScaledVector(v, s);
  // The axis: c = ω × v / ω² from the origin; along it v·ω / ω² a radian.
  const axis = w.clone().divideScalar(rate);
  const centre = w.clone().cross(v).divideScalar(rate * rate).add(new Vector3(origin[0], origin[1], origin[2]));
  const along = v.dot(axis) * s;
  return point.sub(centre).applyAxisAngle(axis, rate * s).add(centre).addScaledVector(axis, along);
}

/**
 * @param {ArrayLike<number>} pose x y z, then the quaternion x y z w
 * @param {ArrayLike<number>} twist (v, ω) of the pose's origin
 * @param {number} s
 */
export function movePose(pose, twist, s) {
  const at = movePoint({ twist, origin: pose }, s, new Vector3(pose[0], pose[1], pose[2]));
  const w = new Vector3(twist[3], twist[4], twist[5]);
  const rate = w.length();
  const turn = new Quaternion(pose[3], pose[4], pose[5], pose[6]);
  if (rate >= STILL) turn.premultiply(new Quaternion().setFromAxisAngle(w.divideScalar(rate), rate * s)).normalize();
  return Float64Array.of(...at.toArray(), ...turn.toArray());
}

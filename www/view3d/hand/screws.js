/**
 * Screws: moving a pose along one, exp(s ξ) with ξ = (v, ω) taken at the pose's origin, in the fixed frame; and where a wrench acts.
 */
import { Quaternion, Vector3 } from 'three';
import { UNTOLD } from '../../core/freedom-words.js';

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
  const centre = axisFoot(w, v).add(new Vector3(origin[0], origin[1], origin[2]));
  const along = v.dot(axis) * s;
  return point.sub(centre).applyAxisAngle(axis, rate * s).add(centre).addScaledVector(axis, along);
}

/**
 * From a point to the nearest one of a screw's axis: l × m / l², for the turn l and the velocity m of the point, or for a force l
 * and its moment m about the point.
 * @param {Vector3} l @param {Vector3} m
 */
export const axisFoot = (l, m) => l.clone().cross(m).divideScalar(l.lengthSq());

/**
 * Where a chain's wrench is drawn: on its axis, beside the chain's end, where its moment turns about the force; or, where the axis
 * is far away, at the chain's end, with the moment about that. What is too little to be told is null.
 * @param {number[]} wrench force, and its moment about `origin` @param {Vector3} origin @param {Vector3} end of the chain
 * @param {number} reach the farthest that the axis may be from the end
 * @param {number} metricLength weighs moments against forces
 * @returns {{at: Vector3, force: Vector3 | null, moment: Vector3 | null, onAxis: boolean}}
 */
export function wrenchAt(wrench, origin, end, reach, metricLength) {
  const force = new Vector3(...wrench.slice(0, 3));
  const about = (/** @type {Vector3} */ point) => origin.clone().sub(point).cross(force).add(new Vector3(...wrench.slice(3)));
  const foot = axisFoot(force, about(end));
  const onAxis = foot.length() <= reach;
  const at = onAxis ? end.clone().add(foot) : end.clone();
  const moment = onAxis ? force.clone().multiplyScalar(about(at).dot(force) / force.lengthSq()) : about(at);
  const [f, m] = [force.length(), moment.length() / metricLength];
  return { at, force: f > UNTOLD * m ? force : null, moment: m > UNTOLD * f ? moment : null, onAxis };
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

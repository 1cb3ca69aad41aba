/**
 * Frames of the document as transformations to draw: x, y, z and R = Y(longitude) · X(−latitude) · Z(roll), in degrees.
 *
 * @typedef {NonNullable<ReturnType<typeof import('./shown.js').shown>>} Shown
 */
import { Euler, Matrix4, Quaternion, Vector3 } from 'three';

const RADIANS = Math.PI / 180;

/** @param {import('./types.js').Frame | undefined} frame @returns {Matrix4} */
export function frameMatrix(frame) {
  const at = (/** @type {import('./types.js').Entry | undefined} */ value) => (typeof value === 'number' ? value : 0);
  const turn = new Euler(-at(frame?.latitude) * RADIANS, at(frame?.longitude) * RADIANS, at(frame?.roll) * RADIANS, 'YXZ');
  return new Matrix4().compose(
    new Vector3(at(frame?.x), at(frame?.y), at(frame?.z)),
    new Quaternion().setFromEuler(turn),
    new Vector3(1, 1, 1),
  );
}

/** Numbers of one pose in a column: x y z, then the quaternion x y z w. */
export const POSE = 7;

/**
 * @param {import('three').Object3D} object moved to the pose
 * @param {Float64Array} column
 * @param {number} index of the pose in the column
 */
export function moveTo(object, column, index) {
  const at = index * POSE;
  object.position.fromArray(column, at);
  object.quaternion.fromArray(column, at + 3);
}

/** @param {Float64Array} column @param {number} index @returns {Vector3} */
export const originOf = (column, index) => new Vector3().fromArray(column, index * POSE);

/** @param {Float64Array} column @param {number} index @returns {Quaternion} */
export const turnOf = (column, index) => new Quaternion().fromArray(column, index * POSE + 3);

/**
 * The forms in which a frame's rotation stands in the document: longitude–latitude–roll, a quaternion, a matrix, or roll,
 * pitch, yaw in an order; read as a matrix, and written from one.
 *
 * @typedef {import('./types.js').Frame} Frame
 * @typedef {import('./types.js').MechanismDocument} MechanismDocument
 * @typedef {'angles' | 'quaternion_wxyz' | 'quaternion_xyzw' | 'matrix' | 'roll_pitch_yaw'} RotationForm
 * @typedef {import('./orientation.js').Turn} Turn a rotation matrix, nine numbers row by row
 */
import { Matrix4, Quaternion } from 'three';
import { frameOf } from './frame-of.js';
import { frameMatrix } from './poses.js';

/** @type {Record<RotationForm, string>} */
export const ROTATION_FORMS = {
  angles: 'longitude, latitude, roll',
  quaternion_wxyz: 'quaternion w x y z',
  quaternion_xyzw: 'quaternion x y z w',
  matrix: 'rotation matrix',
  roll_pitch_yaw: 'roll, pitch, yaw',
};

/** About fixed axes in lower case, about moving ones in upper case; the first is that of URDF. */
export const ORDERS = ['xyz', 'xzy', 'yxz', 'yzx', 'zxy', 'zyx', 'XYZ', 'XZY', 'YXZ', 'YZX', 'ZXY', 'ZYX', 'ZXZ', 'ZYZ', 'zxz', 'zyz'];

const OTHER = /** @type {const} */ (['quaternion_wxyz', 'quaternion_xyzw', 'matrix', 'roll_pitch_yaw']);

/** @param {Frame | undefined} frame @returns {RotationForm} */
export const rotationForm = (frame) => OTHER.find((form) => frame?.[form] != null) ?? 'angles';

/** @param {Matrix4} matrix @returns {Turn} */
export const rowsOf = ({ elements: e }) => [e[0], e[4], e[8], e[1], e[5], e[9], e[2], e[6], e[10]];

/** @param {Turn} turn */
const matrixOf = ([a, b, c, d, e, f, g, h, i]) => new Matrix4().set(a, b, c, 0, d, e, f, 0, g, h, i, 0, 0, 0, 0, 1);

/** The document's angles in degrees. @param {Pick<MechanismDocument, 'angles'>} doc */
const degreesIn = ({ angles }) => (angles === 'radians' ? 180 / Math.PI : 1);

/**
 * A frame's rotation.
 * @param {Frame | undefined} frame of numbers
 * @param {Pick<MechanismDocument, 'angles'>} doc
 * @returns {Turn | null} null where something is no number
 */
export function turnOfFrame(frame, doc) {
  const form = rotationForm(frame);
  const given = form === 'angles' ? [frame?.longitude ?? 0, frame?.latitude ?? 0, frame?.roll ?? 0] : /** @type {any[]} */ (frame?.[form]).flat();
  if (!given.every((value) => typeof value === 'number' && Number.isFinite(value))) return null;
  const unit = degreesIn(doc);
  const [a, b, c, d] = given;
  if (form === 'angles') return rowsOf(frameMatrix({ longitude: a * unit, latitude: b * unit, roll: c * unit }));
  if (form === 'matrix') return given.length === 9 ? given : null;
  if (form === 'roll_pitch_yaw') return fromAngles(given.map((value) => value * unit), frame?.order ?? 'xyz');
  const [x, y, z, w] = form === 'quaternion_wxyz' ? [b, c, d, a] : given;
  return rowsOf(new Matrix4().makeRotationFromQuaternion(new Quaternion(x, y, z, w).normalize()));
}

/**
 * The frame with another rotation, in its own form or in another one; everything else of it stays.
 * @param {Frame | undefined} frame
 * @param {Turn} turn
 * @param {Pick<MechanismDocument, 'angles'>} doc
 * @param {{form?: RotationForm, order?: string}} [as]
 * @returns {Frame}
 */
export function frameWith(frame, turn, doc, { form = rotationForm(frame), order = frame?.order ?? 'xyz' } = {}) {
  const rest = Object.fromEntries(Object.entries(frame ?? {}).filter(([name]) => !['longitude', 'latitude', 'roll', 'order', ...OTHER].includes(name)));
  const unit = degreesIn(doc);
  const { x, y, z, w } = new Quaternion().setFromRotationMatrix(matrixOf(turn)).normalize();
  if (form === 'angles') {
    const near = rotationForm(frame) === 'angles' && doc.angles !== 'radians' ? frame : undefined;
    const { longitude, latitude, roll } = frameOf([0, 0, 0, x, y, z, w], near);
    return { ...rest, longitude: tidy(longitude / unit), latitude: tidy(latitude / unit), roll: tidy(roll / unit) };
  }
  const sign = w < 0 ? -1 : 1;
  const quaternion = [x, y, z, w].map((value) => tidy(sign * value));
  if (form === 'quaternion_xyzw') return { ...rest, quaternion_xyzw: quaternion };
  if (form === 'quaternion_wxyz') return { ...rest, quaternion_wxyz: [quaternion[3], ...quaternion.slice(0, 3)] };
  if (form === 'matrix') return { ...rest, matrix: [0, 3, 6].map((at) => turn.slice(at, at + 3).map(tidy)) };
  return { ...rest, roll_pitch_yaw: toAngles([x, y, z, w], order).map((angle) => tidy(angle / unit)), ...(order === 'xyz' ? {} : { order }) };
}

/** Decimals of a number that a form gives: what makes a turn of 1e-12 rad. @param {number} value */
const tidy = (value) => Number(value.toFixed(12)) || 0;

const isMoving = (/** @type {string} */ order) => order === order.toUpperCase();

/** @param {number[]} angles degrees @param {string} order @returns {Turn} */
export function fromAngles(angles, order) {
  const about = { x: 'makeRotationX', y: 'makeRotationY', z: 'makeRotationZ' };
  const turns = [...order.toLowerCase()].map((axis, i) => {
    const make = /** @type {'makeRotationX'} */ (about[/** @type {'x'} */ (axis)]);
    return new Matrix4()[make]((angles[i] * Math.PI) / 180);
  });
  const [first, ...rest] = isMoving(order) ? turns : turns.reverse();
  return rowsOf(rest.reduce((product, turn) => product.multiply(turn), first));
}

/**
 * The three angles of a rotation in an order, in degrees; where two of the axes coincide, the last angle about fixed axes or
 * the last one about moving axes is 0. After Bernardes and Viollet (2022), as scipy does.
 * @param {number[]} quaternion x y z w, of length 1
 * @param {string} order
 * @returns {number[]}
 */
export function toAngles(quaternion, order) {
  const moving = isMoving(order);
  const axes = [...order.toLowerCase()].map((axis) => 'xyz'.indexOf(axis));
  if (moving) axes.reverse();
  const [i, j] = axes;
  const symmetric = i === axes[2];
  const k = symmetric ? 3 - i - j : axes[2];
  const sign = ((i - j) * (j - k) * (k - i)) / 2;
  const [qi, qj, qk, w] = [quaternion[i], quaternion[j], quaternion[k] * sign, quaternion[3]];
  const [a, b, c, d] = symmetric ? [w, qi, qj, qk] : [w - qj, qi + qk, qj + w, qk - qi];
  const middle = 2 * Math.atan2(Math.hypot(c, d), Math.hypot(a, b));
  const [sum, difference] = [Math.atan2(b, a), Math.atan2(d, c)];
  const near = 1e-7;
  let [first, last] = [sum - difference, sum + difference];
  if (middle < near) [first, last] = moving ? [0, 2 * sum] : [2 * sum, 0];
  else if (Math.PI - middle < near) [first, last] = moving ? [0, 2 * difference] : [-2 * difference, 0];
  const angles = symmetric ? [first, middle, last] : [first, middle - Math.PI / 2, last * sign];
  const degrees = angles.map((angle) => (Math.atan2(Math.sin(angle), Math.cos(angle)) * 180) / Math.PI);
  return moving ? degrees.reverse() : degrees;
}

/**
 * The turn of a frame in the forms that other programs use: quaternion, rotation matrix, roll-pitch-yaw. Each is written
 * as text and read back; a text that is no turn is refused in words.
 *
 * @typedef {import('./types.js').Frame} Frame
 * @typedef {'quaternion' | 'matrix' | 'rpy'} Form
 * @typedef {readonly number[]} Turn a rotation matrix, nine numbers row by row
 */
import { Matrix4, Quaternion } from 'three';
import { entry } from './edits.js';
import { POLE, frameOf } from './frame-of.js';
import { frameMatrix } from './poses.js';
import { plain } from './shown-frame.js';

const RADIANS = Math.PI / 180;

/** By how much a quaternion's length, or a product of a matrix's columns, may be off: what is left of three decimals. */
const ROUNDED = 1e-3;

/** @param {Matrix4} matrix @returns {Turn} */
const rowsOf = ({ elements: e }) => [e[0], e[4], e[8], e[1], e[5], e[9], e[2], e[6], e[10]];

/** @param {Turn} turn */
const matrixOf = ([a, b, c, d, e, f, g, h, i]) => new Matrix4().set(a, b, c, 0, d, e, f, 0, g, h, i, 0, 0, 0, 0, 1);

/** @param {Turn} turn */
const quaternionOf = (turn) => new Quaternion().setFromRotationMatrix(matrixOf(turn)).normalize();

/** @param {Frame | undefined} frame @returns {Turn} */
export const turnOf = (frame) => rowsOf(frameMatrix({ ...frame, x: 0, y: 0, z: 0 }));

/**
 * The document's three angles of a turn, in degrees.
 * @param {Turn} turn
 * @param {Frame} [near] of the many angles of one turn, those nearest to this frame's
 */
export function anglesOf(turn, near) {
  const { x, y, z, w } = quaternionOf(turn);
  const { longitude, latitude, roll } = frameOf([0, 0, 0, x, y, z, w], near);
  return { longitude: plain(longitude), latitude: plain(latitude), roll: plain(roll) };
}

/** x y z w, with w not negative. @param {Turn} turn @returns {number[]} */
export function quaternion(turn) {
  const { x, y, z, w } = quaternionOf(turn);
  return [x, y, z, w].map((value) => (w < 0 ? -value : value));
}

/**
 * Roll, pitch and yaw in degrees: about the fixed x, then the fixed y, then the fixed z; R = Z(yaw) · Y(pitch) · X(roll), as
 * in URDF. At a pitch of ±90° roll and yaw turn about one axis, and the roll is 0.
 * @param {Turn} turn @returns {number[]}
 */
export function rollPitchYaw([m11, m12, , m21, m22, , m31, m32, m33]) {
  const cosine = Math.hypot(m11, m21);
  const pitch = Math.atan2(-m31, cosine);
  const [roll, yaw] = cosine < POLE ? [0, Math.atan2(-m12, m22)] : [Math.atan2(m32, m33), Math.atan2(m21, m11)];
  return [roll, pitch, yaw].map((angle) => angle / RADIANS);
}

/** @param {number[]} angles roll, pitch and yaw in degrees @returns {Turn} */
function turnOfRollPitchYaw([roll, pitch, yaw]) {
  const about = new Matrix4();
  const turn = new Matrix4().makeRotationZ(yaw * RADIANS);
  return rowsOf(turn.multiply(about.makeRotationY(pitch * RADIANS)).multiply(about.makeRotationX(roll * RADIANS)));
}

/**
 * The forms: their numbers of a turn, and the turn of their numbers or what is wrong with them.
 * @type {Record<Form, {count: number, accepted: string, write: (turn: Turn) => number[], read: (numbers: number[]) => {turn: Turn} | {fault: string}}>}
 */
const FORMS = {
  quaternion: {
    count: 4,
    accepted: 'four numbers x y z w of length 1, such as 0 0 0.7071 0.7071',
    write: quaternion,
    read(numbers) {
      const length = Math.hypot(...numbers);
      const unit = numbers.map((value) => plain(value / length));
      if (length === 0) return { fault: 'All four numbers are 0, which is no turn.' };
      if (Math.abs(length - 1) > ROUNDED) return { fault: `The length is ${plain(length)}, not 1 to within ${ROUNDED}. Divided by its length it is ${unit.join(' ')}.` };
      const [x, y, z, w] = numbers;
      return { turn: rowsOf(new Matrix4().makeRotationFromQuaternion(new Quaternion(x, y, z, w).normalize())) };
    },
  },
  matrix: {
    count: 9,
    accepted: 'nine numbers row by row, whose columns are at right angles, of length 1 and right-handed',
    write: (turn) => [...turn],
    read(numbers) {
      const off = skewness(numbers);
      if (off > ROUNDED) return { fault: `The columns are not at right angles and of length 1: the product of the matrix with its transpose is off by ${plain(off)}, more than ${ROUNDED}.` };
      const determinant = matrixOf(numbers).determinant();
      if (determinant < 0) return { fault: 'The determinant is −1: the matrix mirrors. Perhaps one axis has the wrong sign.' };
      return { turn: nearestTurn(numbers) };
    },
  },
  rpy: {
    count: 3,
    accepted: 'three angles in degrees, roll pitch yaw',
    write: rollPitchYaw,
    read: (numbers) => ({ turn: turnOfRollPitchYaw(numbers) }),
  },
};

/** A turn in a form, as text; a matrix has a line for each row. @param {Form} form @param {Turn} turn */
export function writeTurn(form, turn) {
  const words = FORMS[form].write(turn).map((value) => String(plain(value)));
  if (form !== 'matrix') return words.join(' ');
  return [0, 3, 6].map((at) => words.slice(at, at + 3).join(' ')).join('\n');
}

/**
 * The turn that a text in a form means.
 * @param {Form} form @param {string} text numbers with blanks, commas, semicolons or brackets between them
 * @returns {{turn: Turn} | {fault: string}}
 */
export function readTurn(form, text) {
  const { count, accepted, read } = FORMS[form];
  const words = text.split(/[\s,;()[\]{}]+/).filter(Boolean);
  const numbers = words.map(entry);
  const bad = numbers.find((value) => typeof value !== 'number');
  const remedy = `Accepted: ${accepted}.`;
  if (bad !== undefined) return { fault: `“${bad}” is no number. ${remedy}` };
  if (numbers.length !== count) return { fault: `There ${numbers.length === 1 ? 'is 1 number' : `are ${numbers.length} numbers`}. ${remedy}` };
  const answer = read(/** @type {number[]} */ (numbers));
  return 'fault' in answer ? { fault: `${answer.fault} ${remedy}` } : answer;
}

/** The largest entry of RᵀR − 1. @param {number[]} m row by row */
function skewness(m) {
  let worst = 0;
  for (let i = 0; i < 3; i++) {
    for (let j = i; j < 3; j++) {
      const product = m[i] * m[j] + m[3 + i] * m[3 + j] + m[6 + i] * m[6 + j];
      worst = Math.max(worst, Math.abs(product - (i === j ? 1 : 0)));
    }
  }
  return worst;
}

/** The nearest rotation matrix, by Newton's iteration for the polar factor, X ← (X + X⁻ᵀ) / 2. @param {number[]} numbers @returns {Turn} */
function nearestTurn(numbers) {
  let near = numbers;
  // It doubles the digits each time: of the three that are there, two make twelve.
  for (let i = 0; i < 3; i++) {
    const other = rowsOf(matrixOf(near).invert().transpose());
    near = near.map((value, at) => (value + other[at]) / 2);
  }
  return near;
}

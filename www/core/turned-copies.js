/**
 * Copies of a chain turned around an axis of the fixed frame, which close at the same start values: three equal legs from one.
 *
 * A copy's base frame is R·G, with the turn R. Its gripper frame H' follows from R·G·K(θ)·H' = D, where K are the joints at
 * the start values θ and D = G·K(θ)·H is the workpiece there: H' = (R·G·K)⁻¹·D.
 *
 * @typedef {import('./types.js').MechanismDocument} MechanismDocument
 * @typedef {import('./types.js').Chain} Chain
 * @typedef {import('./types.js').Frame} Frame
 * @typedef {{count: number, axis: 'x' | 'y' | 'z', point: number[]}} Around `count` chains in all, the first included; the axis
 *   goes through the point
 */
import { withChains } from './driver-places.js';
import { Matrix4, Quaternion, Vector3 } from 'three';
import { isByAxes } from './by-axes.js';
import { copyName } from './lists.js';
import { chainVariables, JOINT_TYPES, plainLetter } from './joint-types.js';
import { frameOf } from './frame-of.js';
import { frameMatrix } from './poses.js';

const RADIANS = Math.PI / 180;
const AXES = { x: new Vector3(1, 0, 0), y: new Vector3(0, 1, 0), z: new Vector3(0, 0, 1) };

/** Digits of the copies' numbers: all that a double has but for the last ones, which rounding has spoilt. */
const DIGITS = 14;

/** K: the joints with their links at joint values. @param {Chain} chain @param {number[]} values degrees or lengths */
function jointsMatrix(chain, values) {
  const whole = new Matrix4();
  const part = new Matrix4();
  let variable = 0;
  for (const { type, rows = [] } of chain.joints) {
    JOINT_TYPES[plainLetter(type)].rows.forEach((variables, row) => {
      const { alpha, a, theta, d } = /** @type {Record<string, number>} */ ({ alpha: 0, a: 0, theta: 0, d: 0, ...rows[row] });
      const moved = { theta, d };
      for (const name of variables) moved[name] += values[variable++];
      whole.multiply(part.makeRotationX(alpha * RADIANS).setPosition(a, 0, 0));
      whole.multiply(part.makeRotationZ(moved.theta * RADIANS).setPosition(0, 0, moved.d));
    });
  }
  return whole;
}

/** Where a chain has the workpiece at joint values: G·K·H. @param {Chain} chain @param {number[]} values degrees or lengths */
export const workpieceAt = (chain, values) => frameMatrix(chain.base).multiply(jointsMatrix(chain, values)).multiply(frameMatrix(chain.gripper));

/** @param {Matrix4} matrix @param {Frame | undefined} near @param {number} size lengths far below it are rounding @returns {Frame} */
function rounded(matrix, near, size) {
  const place = new Vector3();
  const turn = new Quaternion();
  matrix.decompose(place, turn, new Vector3());
  const frame = frameOf([place.x, place.y, place.z, turn.x, turn.y, turn.z, turn.w], near);
  const entries = Object.entries(frame).map(([name, value]) => {
    const scale = name.length === 1 ? size : 360;
    return [name, Math.abs(value) < scale * 10 ** -DIGITS ? 0 : Number(value.toPrecision(DIGITS))];
  });
  return Object.fromEntries(entries);
}

/**
 * What keeps a chain from being copied, in words; '' if nothing does.
 * @param {Chain} chain @param {readonly unknown[] | undefined} start
 */
export function whyNotCopied(chain, start) {
  if (isByAxes(chain)) {
    const typed = chain.joints.flatMap(({ point, axis, second }) => [point, axis, second].flatMap((vector) => vector ?? []));
    return typed.every((value) => typeof value === 'number') ? '' : 'A point or direction of this chain is no number: write it as one first.';
  }
  if (!chain.joints.every(({ rows }) => rows)) return 'The rows of this chain are not known yet: mend the document first.';
  const numbers = [chain.base, chain.gripper, ...chain.joints.flatMap(({ rows }) => rows ?? [])].flatMap((part) => Object.values(part ?? {}));
  if (numbers.some((value) => typeof value !== 'number')) return 'A number of this chain is at fault: mend it first.';
  const known = start?.length === chainVariables(chain).length && start.every((value) => typeof value === 'number');
  return known ? '' : 'The chain has no start values yet, at which its copies would close: find a start first.';
}

/**
 * @param {MechanismDocument} doc
 * @param {number} chain
 * @param {Around} around
 * @param {number[]} start degrees or lengths, at which the copies close
 * @param {Chain} [plain] the chain as rows and numbers, where the document gives it by expressions, axes or another
 *   convention: the copies are such chains
 * @returns {MechanismDocument} with the copies behind the chain
 */
export function turnedCopies(doc, chain, { count, axis, point }, start, plain = doc.chains[chain]) {
  if (isByAxes(plain)) return turnedAxes(doc, chain, { count, axis, point });
  const old = plain;
  const base = frameMatrix(old.base);
  const inner = base.clone().multiply(jointsMatrix(old, start));
  const workpiece = inner.clone().multiply(frameMatrix(old.gripper));
  const size = Math.max(...[base, inner, workpiece].map((matrix) => new Vector3().setFromMatrixPosition(matrix).length()), ...point.map(Math.abs));
  const [x, y, z] = point;
  const chains = [...doc.chains];
  chains[chain] = { ...doc.chains[chain], start };
  for (let k = 1; k < count; k++) {
    const turn = new Matrix4().makeTranslation(x, y, z);
    turn.multiply(new Matrix4().makeRotationAxis(AXES[axis], (2 * Math.PI * k) / count)).multiply(new Matrix4().makeTranslation(-x, -y, -z));
    const gripper = turn.clone().multiply(inner).invert().multiply(workpiece);
    const copy = {
      ...old,
      name: copyName(old.name, chains),
      base: rounded(turn.multiply(base), old.base, size),
      gripper: rounded(gripper, old.gripper, size),
      start,
    };
    chains.splice(chain + k, 0, copy);
  }
  return withCopies(doc, chain, chains);
}

/** Drivers keep their chains, also behind the copies. @param {MechanismDocument} doc @param {number} chain @param {Chain[]} chains */
const withCopies = (doc, chain, chains) => withChains({ ...doc, chains: doc.chains.map((old, i) => (i === chain ? chains[chain] : old)) }, chains);

/** Of a chain by its axes: its points and directions are turned, and all copies meet at home. @param {MechanismDocument} doc @param {number} chain @param {Around} around @returns {MechanismDocument} */
function turnedAxes(doc, chain, { count, axis, point }) {
  const old = doc.chains[chain];
  const centre = new Vector3(...point);
  const extent = Math.max(...old.joints.flatMap(({ point: at }) => (at ?? []).map((value) => Math.abs(Number(value)))), ...point.map(Math.abs));
  const written = (/** @type {Vector3} */ vector, /** @type {number} */ size) =>
    vector.toArray().map((value) => (Math.abs(value) < size * 10 ** -DIGITS ? 0 : Number(value.toPrecision(DIGITS))));
  const chains = [...doc.chains];
  for (let k = 1; k < count; k++) {
    const angle = (2 * Math.PI * k) / count;
    const turned = (/** @type {any} */ vector) => new Vector3(.../** @type {[number, number, number]} */ ([...vector])).applyAxisAngle(AXES[axis], angle);
    const joints = old.joints.map((joint) => ({
      ...joint,
      ...(joint.point && { point: written(turned(new Vector3(.../** @type {any} */ (joint.point)).sub(centre)).add(centre), extent) }),
      ...(joint.axis && { axis: written(turned(joint.axis), 1) }),
      ...(joint.second && { second: written(turned(joint.second), 1) }),
    }));
    chains.splice(chain + k, 0, { ...old, name: copyName(old.name, chains), joints });
  }
  return withCopies(doc, chain, chains);
}

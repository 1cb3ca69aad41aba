/**
 * The two conventions of a Denavit–Hartenberg table: modified (Craig), X(α, a) Z(θ, d), and standard, Z(θ, d) X(α, a),
 * whose last row's link goes to the gripper.
 *
 * @typedef {import('./types.js').Chain} Chain
 * @typedef {import('./types.js').Row} Row
 * @typedef {import('./types.js').MechanismDocument} MechanismDocument
 * @typedef {'modified' | 'standard'} Convention
 */
import { Matrix4 } from 'three';
import { isByAxes } from './by-axes.js';
import { frameMatrix } from './poses.js';
import { frameWith, rowsOf } from './rotation-forms.js';

/** @param {Chain} chain @returns {Convention} */
export const conventionOf = ({ convention }) => (convention === 'standard' ? 'standard' : 'modified');

/** @param {Chain} chain @param {Convention} convention @returns {Chain} */
function named(chain, convention) {
  const { convention: _, ...rest } = chain;
  return convention === 'standard' ? { ...rest, convention } : rest;
}

/** The numbers stay, and mean something else. @param {MechanismDocument} doc @param {number[]} chains @param {Convention} convention @returns {MechanismDocument} */
export const asPrinted = (doc, chains, convention) => ({
  ...doc,
  chains: doc.chains.map((chain, i) => (chains.includes(i) && !isByAxes(chain) ? named(chain, convention) : chain)),
});

/**
 * The chain in the other convention, with the same motion: each row's link moves to its neighbour, as typed; the one that
 * has no row there goes to the base or the gripper.
 * @param {Chain} chain
 * @param {Chain} plain what it stands for: numbers, degrees, modified
 * @param {MechanismDocument} doc whose unit of angles the numbers have
 * @returns {Chain}
 */
export function converted(chain, plain, doc) {
  const toStandard = conventionOf(chain) === 'modified';
  /** @type {Pick<Row, 'alpha' | 'a'>[]} */
  const links = chain.joints.flatMap(({ rows = [] }) => rows.map(({ alpha, a }) => ({ ...(alpha !== undefined && { alpha }), ...(a !== undefined && { a }) })));
  const [end] = toStandard ? links.splice(0, 1) : links.splice(-1, 1);
  if (toStandard) links.push({});
  else links.unshift({});
  let row = 0;
  const joints = chain.joints.map((joint) => ({
    ...joint,
    ...(joint.rows && { rows: joint.rows.map(({ alpha: _, a: __, ...rest }) => ({ ...links[row++], ...rest })) }),
  }));
  const fresh = named({ ...chain, joints }, toStandard ? 'standard' : 'modified');
  // An end without a link leaves base and gripper as they are typed.
  if (!end || [end.alpha, end.a].every((value) => (value ?? 0) === 0)) return fresh;
  if (!toStandard) return { ...fresh, gripper: written(chain.gripper, frameMatrix(plain.gripper), doc) };
  const { alpha = 0, a = 0 } = /** @type {Record<string, number>} */ (plain.joints[0].rows?.[0] ?? {});
  const link = new Matrix4().makeRotationX((alpha * Math.PI) / 180).setPosition(a, 0, 0);
  return { ...fresh, base: written(chain.base, frameMatrix(plain.base).multiply(link), doc) };
}

/** @param {import('./types.js').Frame | undefined} frame @param {Matrix4} matrix @param {MechanismDocument} doc */
function written(frame, matrix, doc) {
  const [x, y, z] = matrix.elements.slice(12, 15).map(tidy);
  return { ...frameWith(frame, rowsOf(matrix), doc), x, y, z };
}

/** Without the last digits, which rounding has spoilt. @param {number} value */
const tidy = (value) => Number(value.toPrecision(14)) || 0;

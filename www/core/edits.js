/**
 * Pure functions from document to document, one per user action; those of key frames are in key-frame-edits.js.
 *
 * @typedef {import('./types.js').MechanismDocument} MechanismDocument
 * @typedef {import('./types.js').Entry} Entry
 * @typedef {import('./types.js').Joint} Joint
 * @typedef {import('./types.js').Chain} Chain
 */
import { withChain, withChains } from './driver-places.js';
import { copyName, freshName, insert, moved, without } from './lists.js';
import { plainLetter } from './joint-types.js';
import { valueAt, withValueAt } from './path.js';

const NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;

/**
 * What was typed, as a document keeps it: a number if it is one, else the text itself.
 * @param {string} text
 * @returns {Entry}
 */
export function entry(text) {
  const plain = text.trim().replace(/^[−–]/, '-');
  const number = NUMBER.test(plain) ? Number(plain) : NaN;
  return Number.isFinite(number) ? number : plain;
}

/**
 * @param {MechanismDocument} doc
 * @param {string} path
 * @param {unknown} value undefined removes it
 */
export const setValue = (doc, path, value) => withValueAt(doc, path, value);

/**
 * One coordinate of a point that is given whole or not at all: the first one typed takes over the others, and clearing
 * one clears all.
 * @param {MechanismDocument} doc
 * @param {string} path
 * @param {number} axis 0 to 2
 * @param {Entry | undefined} value
 * @param {number[]} others what holds where the document gives nothing
 */
export function setCoordinate(doc, path, axis, value, others) {
  if (value === undefined) return withValueAt(doc, path, undefined);
  const point = [...(valueAt(doc, path) ?? others)];
  point[axis] = value;
  return withValueAt(doc, path, point);
}

/**
 * Replaces a chain's joints. Its start values belonged to the old joints, so they go: the planner finds new ones.
 * @param {MechanismDocument} doc
 * @param {number} chain
 * @param {(joints: Joint[]) => Joint[]} change
 */
function changeJoints(doc, chain, change) {
  const { start: _, ...rest } = doc.chains[chain];
  return withChain(doc, chain, { ...rest, joints: change(rest.joints) });
}

/** @param {MechanismDocument} doc @param {number} chain @param {number} joint @param {Joint} fresh */
export const setJoint = (doc, chain, joint, fresh) =>
  changeJoints(doc, chain, (joints) => joints.map((old, i) => (i === joint ? fresh : old)));

/** @param {MechanismDocument} doc @param {number} chain @param {number} at where the new joint comes @param {Joint} fresh */
export const insertJoint = (doc, chain, at, fresh) => changeJoints(doc, chain, (joints) => insert(joints, at, fresh));

/** @param {MechanismDocument} doc @param {number} chain @param {number} from @param {number} to */
export const moveJoint = (doc, chain, from, to) => changeJoints(doc, chain, (joints) => moved(joints, from, to));

/** @param {MechanismDocument} doc @param {number} chain @param {number} joint */
export const removeJoint = (doc, chain, joint) => changeJoints(doc, chain, (joints) => without(joints, joint));

/** Other joints between the same base and gripper. @param {MechanismDocument} doc @param {number} chain @param {Joint[]} fresh */
export const setJoints = (doc, chain, fresh) => changeJoints(doc, chain, () => fresh);

/**
 * A chain's joints by their letters. What the old and the new type have in common at the base and at the gripper stays, and
 * between them each joint that keeps its place and its letter; the others are new.
 * @param {MechanismDocument} doc
 * @param {number} chain
 * @param {import('./types.js').JointType[]} letters from base to workpiece
 * @param {Record<import('./types.js').JointType, Joint>} fresh a new joint of each type
 */
export function setChainType(doc, chain, letters, fresh) {
  const old = doc.chains[chain].joints;
  const is = (/** @type {number} */ at, /** @type {string} */ letter) => plainLetter(old[at].type) === letter;
  if (old.length === letters.length && letters.every((letter, i) => is(i, letter))) return doc;
  const most = Math.min(old.length, letters.length);
  let front = 0;
  while (front < most && is(front, letters[front])) front++;
  let back = 0;
  while (back < most - front && is(old.length - 1 - back, letters[letters.length - 1 - back])) back++;
  const added = letters.length - old.length;
  return setJoints(doc, chain, letters.map((letter, i) => {
    const stays = i < letters.length - back ? old[i] : old[i - added];
    const between = i < old.length - back;
    return (i >= letters.length - back || between) && stays && plainLetter(stays.type) === letter ? stays : fresh[letter];
  }));
}

/** @param {MechanismDocument} doc @param {Chain} fresh */
export const addChain = (doc, fresh) => ({
  ...doc,
  chains: [...doc.chains, { ...fresh, name: freshName('chain', doc.chains) }],
});

/** @param {MechanismDocument} doc @param {number} chain */
export const duplicateChain = (doc, chain) =>
  withChains(doc, insert(doc.chains, chain + 1, { ...doc.chains[chain], name: copyName(doc.chains[chain].name, doc.chains) }));

/** @param {MechanismDocument} doc @param {number} from @param {number} to */
export const moveChain = (doc, from, to) => withChains(doc, moved(doc.chains, from, to));

/** @param {MechanismDocument} doc @param {number} chain */
export const removeChain = (doc, chain) => withChains(doc, without(doc.chains, chain));

/**
 * @param {MechanismDocument} doc
 * @param {number} chain
 * @param {number} index
 * @param {Entry} value
 * @param {number[]} current the values in use, which fill the places where the document gives none
 */
export function setStart(doc, chain, index, value, current) {
  const start = [...(doc.chains[chain].start ?? current)];
  start[index] = value;
  return withValueAt(doc, `chains[${chain}].start`, start);
}

/** Takes over every chain's start values. @param {MechanismDocument} doc @param {Chain[]} from */
export const takeStarts = (doc, from) => ({
  ...doc,
  chains: doc.chains.map((chain, index) => ({ ...chain, start: from[index]?.start ?? chain.start })),
});

/** @param {MechanismDocument} doc @param {number} chain */
export const clearStart = (doc, chain) => withValueAt(doc, `chains[${chain}].start`, undefined);

/**
 * @param {MechanismDocument} doc
 * @param {{chain: number, joint: number, freedom: number, freedoms: number}} at
 * @param {'min' | 'max'} bound
 * @param {Entry | undefined} value undefined opens the bound
 */
export function setLimit(doc, { chain, joint, freedom, freedoms }, bound, value) {
  const old = doc.chains[chain].joints[joint].limits;
  const limits = Array.from({ length: freedoms }, (_, i) => old?.[i] ?? null);
  const { [bound]: _, ...rest } = limits[freedom] ?? {};
  const limit = value === undefined ? rest : { ...rest, [bound]: value };
  limits[freedom] = Object.values(limit).some((v) => v !== null) ? limit : null;
  const path = `chains[${chain}].joints[${joint}].limits`;
  return withValueAt(doc, path, limits.every((l) => l === null) ? undefined : limits);
}

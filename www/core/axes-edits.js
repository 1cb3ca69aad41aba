/**
 * What is done with a chain by its axes: joints get another type or are pasted, and the chain becomes the rows that it stands
 * for.
 *
 * @typedef {import('./types.js').Chain} Chain
 * @typedef {import('./types.js').Joint} Joint
 * @typedef {import('./types.js').JointType} JointType
 * @typedef {import('./types.js').MechanismDocument} MechanismDocument
 * @typedef {import('./types.js').Entry} Entry
 */
import { AXES_JOINTS } from './by-axes.js';
import { JOINT_LETTERS } from './joint-types.js';

/**
 * The directions of each type, and whether each of its vectors may be left out.
 * @type {Record<JointType, {optional: ('point' | 'axis' | 'second')[], axis: string, second: string}>}
 */
export const VECTORS = {
  R: { optional: [], axis: 'axis', second: '' },
  P: { optional: ['point'], axis: 'slider', second: '' },
  C: { optional: [], axis: 'axis', second: '' },
  T: { optional: [], axis: 'first axis', second: 'second axis' },
  S: { optional: ['axis'], axis: 'first axis', second: '' },
  E: { optional: ['point', 'second'], axis: 'normal', second: 'first slider' },
};

/** The joint as one of another type, with what that has a use for; its limits were others. @param {Joint} joint @param {JointType} type @returns {Joint} */
export function asType({ point, axis, second }, type) {
  const fresh = AXES_JOINTS[type];
  const across = axis && type === 'T' ? { second: second ?? acrossOf(axis) } : {};
  return { ...fresh, ...(point && { point }), ...(axis && { axis }), ...(second && VECTORS[type].second && { second }), ...across };
}

/** A direction at right angles to one of numbers: the coordinate axis that is least along it, made square. @param {Entry[]} axis @returns {number[]} */
export function acrossOf(axis) {
  const [x, y, z] = axis.map((value) => (typeof value === 'number' ? value : 0));
  const least = [x, y, z].map(Math.abs).reduce((best, value, i, all) => (value < all[best] ? i : best), 0);
  // axis × e
  const across = [[0, z, -y], [-z, 0, x], [y, -x, 0]][least];
  return across.some(Boolean) ? across.map((value) => value || 0) : [1, 0, 0];
}

/**
 * A pasted text as joints: a line a joint, its letter, then the numbers of point and directions: `R 0 0 0  0 0 1`. What a
 * joint may leave out may be left out at the end: S has a point only, P and E may have a direction only. A line of headings
 * before them is skipped.
 * @param {string} text
 * @param {(word: string) => Entry} entry what a word means
 * @returns {{joints: Joint[]} | {fault: string} | null} null where the text is none of joints
 */
export function readJoints(text, entry) {
  const lines = text.split(/\r?\n/).map((line) => line.trim()).filter(Boolean);
  const isJoint = (/** @type {string} */ line = '') => /^[RPCTUSE]([\s,;]|$)/i.test(line);
  const heads = isJoint(lines[0]) ? 0 : 1;
  if (!isJoint(lines[heads])) return null;
  /** @type {Joint[]} */
  const joints = [];
  for (const [index, line] of lines.entries()) {
    if (index < heads) continue;
    if (!isJoint(line)) return { fault: `Line ${index + 1}, “${line.slice(0, 60)}”, does not begin with the letter of a joint. Accepted: ${JOINT_LETTERS.join(', ')}.` };
    const [letter, ...words] = line.split(line.includes('\t') ? /\t/ : line.includes(';') ? /;/ : /[\s,]+/).map((word) => word.trim()).filter(Boolean);
    const type = /** @type {JointType} */ (letter.toUpperCase().replace('U', 'T'));
    const { optional } = VECTORS[type];
    const numbers = words.map(entry);
    const vectors = [0, 3, 6].map((at) => numbers.slice(at, at + 3)).filter(({ length }) => length);
    // Three numbers of a joint that needs no point are its direction.
    const names = optional.includes('point') && vectors.length === 1 ? ['axis'] : ['point', 'axis', 'second'];
    const of = Object.fromEntries(vectors.map((vector, i) => [names[i], vector]));
    const needed = /** @type {const} */ (['point', 'axis', 'second']).filter((name) => name in AXES_JOINTS[type] && !optional.includes(name));
    if (numbers.length % 3 || numbers.length > (VECTORS[type].second || type === 'S' ? 9 : 6) || needed.some((name) => !of[name])) {
      return { fault: `Line ${index + 1}, “${line.slice(0, 60)}”: accepted for ${type} are its letter and the numbers of ${[...needed, ...optional.map((name) => `perhaps ${name}`)].join(', ')}, three each.` };
    }
    joints.push({ type, ...of });
  }
  return { joints };
}

/** The document with joints written over those from one on, or behind them. @param {MechanismDocument} doc @param {number} chain @param {number} at @param {Joint[]} joints @returns {MechanismDocument} */
export function withJoints(doc, chain, at, joints) {
  const { start: _, ...rest } = doc.chains[chain];
  const all = [...rest.joints];
  joints.forEach((joint, i) => {
    all[at + i] = joint;
  });
  return { ...doc, chains: doc.chains.map((old, i) => (i === chain ? { ...rest, joints: all } : old)) };
}

/**
 * A chain by axes turned into the rows that it stands for. Limits and start count from home there too, and stay as typed.
 * @param {MechanismDocument} doc
 * @param {number} chain
 * @param {Chain} plain what it stands for, in degrees
 * @returns {MechanismDocument}
 */
export function intoRows(doc, chain, plain) {
  const turn = (/** @type {any} */ value) => (doc.angles === 'radians' ? (value * Math.PI) / 180 : value);
  const angles = ['alpha', 'theta', 'longitude', 'latitude', 'roll'];
  const inUnit = (/** @type {object} */ part) => Object.fromEntries(Object.entries(part).map(([name, value]) => [name, angles.includes(name) ? turn(value) : value]));
  const old = doc.chains[chain];
  const joints = old.joints.map((joint, i) => {
    const { type, rows = [] } = plain.joints[i];
    return { type, rows: rows.map(inUnit), ...(joint.limits && { limits: joint.limits }) };
  });
  const start = old.start ?? plain.start;
  const fresh = { ...(old.name !== undefined && { name: old.name }), base: inUnit(plain.base ?? {}), joints, gripper: inUnit(plain.gripper ?? {}), ...(start && { start }) };
  return { ...doc, chains: doc.chains.map((other, i) => (i === chain ? fresh : other)) };
}

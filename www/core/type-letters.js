/**
 * The type of a chain as it is typed: `RPS`, `r p s`.
 *
 * @typedef {import('./types.js').JointType} JointType
 */
import { JOINT_LETTERS, JOINT_TYPES } from './joint-types.js';

const ACCEPTED = `Accepted: letters from base to workpiece, ${JOINT_LETTERS.map((letter) => `${letter} ${JOINT_TYPES[letter].name}`).join(', ')}; U is T; such as RPS.`;

/**
 * @param {string} text
 * @returns {{letters: JointType[]} | {fault: string}}
 */
export function readType(text) {
  const letters = Array.from(text.toUpperCase().replaceAll('U', 'T').replace(/[\s,;-]/g, ''));
  const bad = letters.find((letter) => !(letter in JOINT_TYPES));
  if (bad !== undefined) return { fault: `“${bad}” is no joint. ${ACCEPTED}` };
  if (!letters.length) return { fault: `A chain needs a joint. ${ACCEPTED}` };
  return { letters: /** @type {JointType[]} */ (letters) };
}

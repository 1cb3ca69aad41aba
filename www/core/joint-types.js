/**
 * The six joints of Table 1 as the page names and draws them: letter, name, and which numbers of each
 * Denavit–Hartenberg row are the joint's variables.
 *
 * @typedef {import('./types.js').JointType} JointType
 * @typedef {'theta' | 'd'} Variable
 */

/** @type {Record<JointType, {name: string, rows: Variable[][]}>} */
export const JOINT_TYPES = {
  R: { name: 'revolute', rows: [['theta']] },
  P: { name: 'prismatic', rows: [['d']] },
  C: { name: 'cylindric', rows: [['theta', 'd']] },
  T: { name: 'universal', rows: [['theta'], ['theta']] },
  S: { name: 'spherical', rows: [['theta'], ['theta'], ['theta']] },
  E: { name: 'planar', rows: [['d'], ['d'], ['theta']] },
};

/** @type {JointType[]} */
export const JOINT_LETTERS = ['R', 'P', 'C', 'T', 'S', 'E'];

/**
 * The letter that a plain document has: U is T, and a letter may be small.
 * @param {string} type
 */
export const plainLetter = (type) => /** @type {JointType} */ (type.toUpperCase() === 'U' ? 'T' : type.toUpperCase());

/** What a joint's letter means; undefined where it means none. @param {string} type */
export const jointOf = (type) => /** @type {typeof JOINT_TYPES[JointType] | undefined} */ (JOINT_TYPES[plainLetter(type)]);

const DIGITS = '₀₁₂₃₄₅₆₇₈₉';

/**
 * The paper's name of a variable: θ₁, d₂ (numbered by the chain's rows).
 * @param {Variable} variable
 * @param {number} row row of the chain, from 0
 */
export function variableName(variable, row) {
  const index = Array.from(String(row + 1), (digit) => DIGITS[Number(digit)]).join('');
  return (variable === 'theta' ? 'θ' : 'd') + index;
}

/**
 * A chain's variables in order, with the joint, the joint's freedom and the row they belong to.
 * @param {import('./types.js').Chain} chain
 */
export function chainVariables(chain) {
  /** @type {{variable: Variable, joint: number, freedom: number, row: number, rowOfJoint: number}[]} */
  const all = [];
  let row = 0;
  chain.joints.forEach(({ type }, joint) => {
    let freedom = 0;
    jointOf(type)?.rows.forEach((variables, rowOfJoint) => {
      for (const variable of variables) all.push({ variable, joint, freedom: freedom++, row, rowOfJoint });
      row++;
    });
  });
  return all;
}

/** @param {import('./types.js').Chain} chain */
export const chainType = (chain) => chain.joints.map((joint) => plainLetter(joint.type)).join('');

/** Whether a chain is given by the axes of its joints at home, and has no rows. @param {import('./types.js').Chain} chain */
export const isByAxes = (chain) => chain.joints.some(({ point, axis, second }) => point !== undefined || axis !== undefined || second !== undefined);

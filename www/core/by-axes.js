/**
 * Chains that are given by the axes of their joints at the home position, and what a new one is.
 *
 * @typedef {import('./types.js').Chain} Chain
 * @typedef {import('./types.js').Joint} Joint
 * @typedef {import('./types.js').JointType} JointType
 */

export { isByAxes } from './joint-types.js';

/** A new joint of each type, at the origin. @type {Record<JointType, Joint>} */
export const AXES_JOINTS = {
  R: { type: 'R', point: [0, 0, 0], axis: [0, 0, 1] },
  P: { type: 'P', axis: [0, 0, 1] },
  C: { type: 'C', point: [0, 0, 0], axis: [0, 0, 1] },
  T: { type: 'T', point: [0, 0, 0], axis: [0, 0, 1], second: [1, 0, 0] },
  S: { type: 'S', point: [0, 0, 0] },
  E: { type: 'E', axis: [0, 0, 1] },
};

/** @returns {Chain} */
export const axesChain = () => ({ joints: [AXES_JOINTS.R] });

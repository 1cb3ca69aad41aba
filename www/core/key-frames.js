/**
 * The key frames of a document: none where the joints are driven.
 */

/** @type {import('./types.js').KeyFrame[]} */
const NONE = [];

/** @param {import('./types.js').MechanismDocument} doc */
export const keyFramesOf = ({ motion }) => motion.key_frames ?? NONE;

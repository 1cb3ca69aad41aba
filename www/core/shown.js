/**
 * What is shown now: a frame of the motion, or the posture that stands in its place while the linkage is moved by hand.
 */

import { drivesJoints } from './driven.js';

/**
 * Columns with the index of the shown frame in them, and how many frames they hold. The document is the one that
 * the motion belongs to. Where there is no goal, the reached pose stands in its place.
 * @param {{result: import('./types.js').Result, view: import('./types.js').View}} store
 */
export function shown({ result: { motion, doc }, view: { frame, posture } }) {
  if (!motion || !doc) return null;
  if (posture) {
    const { joints, pose, rows, goal } = posture;
    return { doc, index: 0, frames: 1, joints, pose, rows, goal };
  }
  const { frames, joints, pose, rows } = motion;
  const goal = drivesJoints(motion) ? pose : motion.goal;
  return { doc, index: Math.min(frame, frames - 1), frames, joints, pose, rows, goal };
}

/**
 * Whether the posture is one of a joint driven by hand: it has no goal.
 * @param {import('./types.js').View['posture']} posture
 */
export const isDriven = (posture) => posture?.value !== undefined;

/**
 * Whether what is shown has no goal: joints are driven, by hand or by the motion.
 * @param {{result: Pick<import('./types.js').Result, 'motion'>, view: Pick<import('./types.js').View, 'posture'>}} store
 */
export const hasNoGoal = ({ result: { motion }, view: { posture } }) => (posture ? isDriven(posture) : drivesJoints(motion));

/** One frame's group of a column. @param {Float64Array} column @param {{index: number, frames: number}} at */
export function groupAt(column, { index, frames }) {
  const width = column.length / frames;
  return column.subarray(index * width, (index + 1) * width);
}

/**
 * How what is shown ended: its status and the numbers of its certificate.
 * @param {{result: import('./types.js').Result, view: import('./types.js').View}} store
 */
export function shownEnd({ result: { motion }, view: { frame, posture } }) {
  if (posture) return posture;
  if (!motion) return null;
  return {
    status: motion.report.statuses[motion.status[frame]],
    metric: motion.metric[frame],
    translation_gap: motion.translation_gap[frame],
    rotation_gap: motion.rotation_gap[frame],
    closure: motion.closure[frame],
    misfit: motion.misfit[frame],
    sigma_min: motion.sigma_min[frame],
    projected_gradient: motion.projected_gradient[frame],
    iterations: motion.iterations[frame],
  };
}

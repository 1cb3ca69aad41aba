/**
 * Ways to assemble in an order: by how close they are at the key frame, or by what the motion that is planned from each costs.
 *
 * @typedef {import('../../core/types.js').Mode} Mode
 * @typedef {import('../../core/types.js').Modes} Modes
 */
import { isCloser } from './best-words.js';

/** @param {Mode} one @param {Mode} other */
const byNearness = (one, other) => one.metric - other.metric;

/** What a motion lacks: one that is not planned yet lacks most. @param {Mode} one */
const certified = ({ mean, certified = 0 }) => (mean === undefined ? -1 : certified);

/**
 * As the planner compares them: a frame that is certified counts more than any distance. Of motions that are alike that of the
 * document's start comes first.
 * @param {Mode} one @param {Mode} other
 */
function byMotion(one, other) {
  const means = [one.mean ?? 0, other.mean ?? 0];
  const difference = isCloser(means[0], means[1]) || isCloser(means[1], means[0]) ? means[0] - means[1] : 0;
  return certified(other) - certified(one) || difference || Number(other.is_start) - Number(one.is_start) || byNearness(one, other);
}

/** The mode whose motion is the best, once all are planned. @param {Modes | null} modes */
export const bestMode = (modes) => (modes?.progress === 1 ? ordered(modes.found, 'motion').find(({ mean }) => mean !== undefined) : undefined);

/** The modes in an order; those that are alike as they were found. @param {Mode[]} found @param {'key' | 'motion'} order */
export const ordered = (found, order) => [...found].sort(order === 'motion' ? byMotion : byNearness);

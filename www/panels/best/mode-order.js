/**
 * Ways to assemble in an order: by how close they are at the key frame, or by what the motion that is planned from each costs.
 *
 * @typedef {import('../../core/types.js').Mode} Mode
 * @typedef {import('../../core/types.js').Modes} Modes
 */

/** @param {Mode} one @param {Mode} other */
const byNearness = (one, other) => one.metric - other.metric;

/** Those that are not planned yet come last. @param {Mode} one @param {Mode} other */
const byMotion = (one, other) => (one.mean ?? Number.MAX_VALUE) - (other.mean ?? Number.MAX_VALUE) || byNearness(one, other);

/** The mode whose motion is the closest on average, once all are planned. @param {Modes | null} modes */
export const bestMode = (modes) => (modes?.progress === 1 ? [...modes.found].sort(byMotion).find(({ mean }) => mean !== undefined) : undefined);

/** The modes in an order; those that are alike as they were found. @param {Mode[]} found @param {'key' | 'motion'} order */
export const ordered = (found, order) => [...found].sort(order === 'motion' ? byMotion : byNearness);

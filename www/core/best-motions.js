/**
 * The motions that were found by the search for the best one: shown like any other, and not what the planner plans by itself.
 *
 * @type {WeakSet<import('./types.js').Motion>}
 */
export const bestMotions = new WeakSet();

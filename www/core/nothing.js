/**
 * The document of a linkage that has been given none.
 */

/** @type {import('./types.js').MechanismDocument} */
export const NOTHING = { version: 1, chains: [], motion: { key_frames: [] } };

/** Whether a linkage has been given a document. @param {Pick<import('./store.js').Store, 'doc'>} store */
export const isEmpty = (store) => store.doc === NOTHING;

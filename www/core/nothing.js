/**
 * What a linkage is before it has a document, and when that is taken from it.
 *
 * @typedef {import('./store.js').Store} Store
 */

/** @type {import('./types.js').MechanismDocument} */
export const NOTHING = { version: 1, chains: [], motion: { key_frames: [] } };

/** Whether a linkage has no document. @param {Pick<Store, 'doc'>} store */
export const isEmpty = (store) => store.doc === NOTHING;

/** Takes the document away, and all that was made of it. @param {Store} store */
export function empty(store) {
  store.restore({ doc: NOTHING, past: [], future: [] }, store.originOf(NOTHING));
  store.setResult({ motion: null, doc: null, plain: null, fault: null, trouble: '' });
  store.setWhy(null);
  store.setView({ frame: 0, posture: null, selected: '', hovered: '' });
}

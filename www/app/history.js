/**
 * Undo and redo: the header's buttons, and the keys of the animation's place.
 *
 * @typedef {import('../core/store.js').Store} Store
 */
import { byId } from '../ui/dom.js';

/** @param {Store} store */
export function createHistory(store) {
  /** @type {HTMLButtonElement} */
  const undo = byId('undo');
  /** @type {HTMLButtonElement} */
  const redo = byId('redo');
  undo.addEventListener('click', () => undoOne(store));
  redo.addEventListener('click', () => store.redo());

  const show = () => {
    undo.disabled = !store.canUndo && !movedByHand(store);
    redo.disabled = !store.canRedo;
  };
  store.subscribe('document', show);
  store.subscribe('view', show);
  show();
}

/** Whether the linkage stands where a hand has moved it, and not where an iterate of the planner is. @param {Pick<Store, 'view'>} store */
const movedByHand = ({ view: { posture } }) => posture !== null && posture.note === undefined;

/** What came last goes first: a posture that a hand has moved to is no edit, and is shown until the motion is. @param {Store} store */
export function undoOne(store) {
  if (movedByHand(store)) store.setView({ posture: null });
  else store.undo();
}

/**
 * In a cell too: the document is the text that is edited, so the browser's own undo of the field must not run.
 * @param {Pick<import('../element/workbench.js').App, 'store' | 'keys' | 'signal'>} app
 */
export function createHistoryKeys({ store, keys, signal }) {
  const press = (/** @type {KeyboardEvent} */ event) => {
    if (!(event.ctrlKey || event.metaKey) || event.altKey) return;
    const key = event.key.toLowerCase();
    if (key !== 'z' && key !== 'y') return;
    event.preventDefault();
    if (key === 'y' || event.shiftKey) store.redo();
    else undoOne(store);
  };
  keys.addEventListener('keydown', /** @type {EventListener} */ (press), { signal });
}

/**
 * Undo and redo: the header's buttons.
 *
 * @typedef {import('../core/store.js').Store} Store
 */
import { atRest } from '../core/at-rest.js';
import { movedByHand, undoOne } from '../core/undo.js';
import { byId } from '../ui/dom.js';
import { keyTip } from '../ui/keys.js';

/** @param {Store} store */
export function createHistory(store) {
  /** @type {HTMLButtonElement} */
  const undo = byId('undo');
  /** @type {HTMLButtonElement} */
  const redo = byId('redo');
  keyTip(undo, 'Undo', 'undo');
  keyTip(redo, 'Redo', 'redo');
  undo.addEventListener('click', () => undoOne(store));
  redo.addEventListener('click', () => store.redo());

  const show = () => {
    undo.disabled = !store.canUndo && !movedByHand(store);
    redo.disabled = !store.canRedo;
  };
  atRest(store, ['document', 'view'], show);
  show();
}

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
  undo.addEventListener('click', () => store.undo());
  redo.addEventListener('click', () => store.redo());

  const show = () => {
    undo.disabled = !store.canUndo;
    redo.disabled = !store.canRedo;
  };
  store.subscribe('document', show);
  show();
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
    else store.undo();
  };
  keys.addEventListener('keydown', /** @type {EventListener} */ (press), { signal });
}

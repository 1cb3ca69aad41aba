/**
 * Undo and redo, by button and by key.
 *
 * @typedef {import('../store.js').Store} Store
 */
import { byId } from '../dom.js';

/** @param {Store} store */
export function createHistory(store) {
  /** @type {HTMLButtonElement} */
  const undo = byId('undo');
  /** @type {HTMLButtonElement} */
  const redo = byId('redo');
  undo.addEventListener('click', () => store.undo());
  redo.addEventListener('click', () => store.redo());

  // In a cell too: the document is the text that is edited, so the browser's own undo of the field must not run.
  document.addEventListener('keydown', (event) => {
    if (!(event.ctrlKey || event.metaKey) || event.altKey) return;
    const key = event.key.toLowerCase();
    if (key !== 'z' && key !== 'y') return;
    event.preventDefault();
    if (key === 'y' || event.shiftKey) store.redo();
    else store.undo();
  });

  const show = () => {
    undo.disabled = !store.canUndo;
    redo.disabled = !store.canRedo;
  };
  store.subscribe('document', show);
  show();
}

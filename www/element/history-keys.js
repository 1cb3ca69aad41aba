/**
 * Undo and redo by their keys.
 */
import { undoOne } from '../core/undo.js';

/**
 * In a cell too: the document is the text that is edited, so the browser's own undo of the field must not run.
 * @param {Pick<import('./workbench.js').App, 'store' | 'keys' | 'signal'>} app
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

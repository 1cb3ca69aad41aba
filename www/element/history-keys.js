/**
 * Undo and redo by their keys.
 */
import { undoOne } from '../core/undo.js';
import { onKeys } from '../ui/keys.js';

/**
 * In a cell too: the document is the text that is edited, so the browser's own undo of the field must not run.
 * @param {Pick<import('./workbench.js').App, 'store' | 'keys' | 'signal'>} app
 */
export function createHistoryKeys({ store, keys, signal }) {
  onKeys(keys, { undo: () => undoOne(store), redo: () => store.redo() }, { signal });
}

/**
 * Showing another document: in place of everything, or as a step that undo takes back.
 *
 * @typedef {import('./types.js').MechanismDocument} MechanismDocument
 */
import { ask } from './ask.js';
import { isEmpty } from './nothing.js';
import { Refusal } from './refusal.js';
import { sayUndo } from './undo.js';

/** @param {import('./linkage.js').Parts} parts */
export function createOpening({ store, planner, player, say }) {
  /** The document with every default written out. @param {string} text @returns {Promise<import('./ask.js').Outcome<MechanismDocument>>} */
  const whole = (text) => ask(async () => JSON.parse(await planner.normalise(text)), 'read the document');

  /** A step that undo takes back. @param {MechanismDocument} doc @param {string} [title] @param {FileSystemFileHandle | null} [handle] */
  function show(doc, title = '', handle = null) {
    const { doc: former, unsaved } = store;
    player.currentTime = 0;
    store.setView({ selected: '', hovered: '' });
    const origin = { title, handle, saved: doc };
    // There is nothing that undo could take back.
    if (isEmpty(store)) return store.restore({ doc, past: [], future: [] }, origin);
    store.open(doc, origin);
    const name = former.name || 'the linkage';
    if (unsaved) sayUndo({ store, say }, former, `Opened ${doc.name || title || 'a linkage'} in place of ${name}, which has changes that are in no file.`);
  }

  /**
   * @param {string} text a document
   * @param {string} [title] what its file is called
   * @param {FileSystemFileHandle | null} [handle] the file, where it can be written to
   * @returns {Promise<boolean>} whether it is shown now; if not, the reason has been told
   */
  async function open(text, title = '', handle = null) {
    const read = await whole(text);
    if (read.is === 'answer') {
      show(read.value, title, handle);
      return true;
    }
    const again = read.is === 'trouble' && { label: 'Try again', act: () => open(text, title, handle) };
    say(`${title ? `“${title}”` : 'The document'} was not opened. ${read.message}`, { ...again, stays: true });
    return false;
  }

  return { open, show, whole };
}

/** Why something that was given could not be used, in words. @param {unknown} error */
export function reason(error) {
  if (error instanceof Refusal) return error.message;
  // Nothing that goes wrong is silent.
  return `Something went wrong (${error instanceof Error ? error.message : error}).`;
}

/**
 * Showing another document: in place of everything, or as a step that undo takes back.
 *
 * @typedef {import('./types.js').MechanismDocument} MechanismDocument
 */
import { DocumentFault, PlannerFailure } from '../planner/planner.js';
import { Refusal } from './refusal.js';
import { sentence } from './format.js';
import { sayUndo } from './undo.js';

/** @param {import('./linkage.js').Parts} parts */
export function createOpening({ store, planner, player, say }) {
  /** The document with every default written out. @param {string} text @returns {Promise<MechanismDocument>} */
  const whole = async (text) => JSON.parse(await planner.normalise(text));

  /** A step that undo takes back. @param {MechanismDocument} doc @param {string} [title] @param {FileSystemFileHandle | null} [handle] */
  function show(doc, title = '', handle = null) {
    const { doc: former, unsaved } = store;
    player.currentTime = 0;
    store.setView({ selected: '', hovered: '' });
    store.open(doc, { title, handle, saved: doc });
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
    try {
      show(await whole(text), title, handle);
      return true;
    } catch (error) {
      say(`${title ? `“${title}”` : 'The document'} was not opened. ${reason(error)}`, { stays: true });
      return false;
    }
  }

  return { open, show, whole };
}

/** Why a document was not opened, in words. @param {unknown} error */
export function reason(error) {
  if (error instanceof DocumentFault) return sentence(error.fault.message);
  if (error instanceof Refusal) return error.message;
  if (error instanceof PlannerFailure) return `The planner failed (${error.message}).`;
  // Nothing that goes wrong is silent.
  return `Something went wrong (${error instanceof Error ? error.message : error}).`;
}

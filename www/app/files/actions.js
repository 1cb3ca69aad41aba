/**
 * What a person does with documents: new, open, save, share. Uses the browser's file access where there is one, else
 * uploads and downloads.
 *
 * @typedef {import('../../element/workbench.js').App} App
 */
import { encode } from '../../core/link-codec.js';
import { readText, RefusedFile } from './reading.js';
import { fileName, saveFile } from '../../export/save.js';
import { openShare } from './share.js';
import { DocumentFault } from '../../planner/planner.js';
import { sentence } from '../../core/format.js';

/** What not every browser has, and the page's types do not know. @typedef {{showOpenFilePicker?: (options: object) => Promise<FileSystemFileHandle[]>, showSaveFilePicker?: (options: object) => Promise<FileSystemFileHandle>}} Pickers */
const pickers = () => /** @type {Window & Pickers} */ (window);

const TYPES = [{ description: 'Linkage', accept: { 'application/json': ['.json'] } }];

/** @param {App} app @param {HTMLInputElement} chooser */
export function createActs(app, chooser) {
  const { store, planner, say, open } = app;

  /** Opens a file that was handed in. @param {File} file @param {FileSystemFileHandle | null} [handle] */
  async function take(file, handle = null) {
    try {
      await open(await readText(file), file.name, handle);
    } catch (error) {
      const why = error instanceof RefusedFile ? error.message : `It could not be read (${/** @type {Error} */ (error).message}).`;
      say(`“${file.name}” was not opened. ${why}`, { stays: true });
    }
  }

  async function pick() {
    const { showOpenFilePicker } = pickers();
    if (!showOpenFilePicker) return chooser.click();
    try {
      const [handle] = await showOpenFilePicker.call(window, { types: TYPES });
      await take(await handle.getFile(), handle);
    } catch (error) {
      // Given up by the person; where file access is forbidden, the plain way is left.
      if (!isAbort(error)) chooser.click();
    }
  }

  /** The file to write to; null for a download, undefined if the person gave up. @param {boolean} another */
  async function target(another) {
    const { handle, title } = store.origin;
    if (handle && !another) return handle;
    const { showSaveFilePicker } = pickers();
    if (!showSaveFilePicker) return null;
    const suggestedName = title || fileName(store.doc, 'json');
    return showSaveFilePicker.call(window, { suggestedName, types: TYPES }).catch((error) => (isAbort(error) ? undefined : null));
  }

  /** @param {boolean} [another] to a file of another name */
  async function save(another = false) {
    const handle = await target(another);
    if (handle === undefined) return;
    const { doc } = store;
    const { text, whole } = await textOf(doc);
    const title = handle?.name ?? fileName(doc, 'json');
    try {
      if (handle) {
        const stream = await handle.createWritable();
        await stream.write(text);
        await stream.close();
      } else saveFile(title, new Blob([text], { type: 'application/json' }));
    } catch (error) {
      say(`“${title}” could not be written (${/** @type {Error} */ (error).message}).`, { label: 'Save to another file', act: () => save(true), stays: true });
      return;
    }
    store.markSaved(doc, { title, handle });
    const done = handle ? `Saved as ${title}.` : `Downloaded as ${title}.`;
    say(whole ? done : `${done} It is at fault, and opens again only after that is mended.`);
  }

  /** @param {import('../../core/types.js').MechanismDocument} doc @returns {Promise<{text: string, whole: boolean}>} `whole` if it is without a fault */
  async function textOf(doc) {
    try {
      return { text: await planner.normalise(JSON.stringify(doc)), whole: true };
    } catch {
      // The work is the person's, with its fault too.
      return { text: `${JSON.stringify(doc, null, 2)}\n`, whole: false };
    }
  }

  const fresh = async () => open((await planner.defaults()).document);

  async function share() {
    try {
      const text = JSON.stringify(JSON.parse(await planner.normalise(JSON.stringify(store.doc))));
      openShare(app, text, await encode(text));
    } catch (error) {
      if (!(error instanceof DocumentFault)) throw error;
      say(`A link is made of a document without faults. ${sentence(error.fault.message)}`, { stays: true });
    }
  }

  return { fresh, pick, save, share, take };
}

/** @param {unknown} error */
const isAbort = (error) => error instanceof DOMException && error.name === 'AbortError';

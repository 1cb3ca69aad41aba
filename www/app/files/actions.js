/**
 * What a person does with documents: new, open, save, share. Uses the browser's file access where there is one, else
 * uploads and downloads.
 *
 * @typedef {import('../../element/workbench.js').App} App
 */
import { ask } from '../../core/ask.js';
import { MAX_PAYLOAD, MAX_TEXT, encode } from '../../core/link-codec.js';
import { readText, RefusedFile } from './reading.js';
import { fileName } from '../../export/file-name.js';
import { saveFile } from '../../export/save.js';
import { openShare } from './share.js';
import { withPart } from '../../ui/lazy.js';
import { faultText } from '../../core/fault-text.js';

/** What not every browser has, and the page's types do not know. @typedef {{showOpenFilePicker?: (options: object) => Promise<FileSystemFileHandle[]>, showSaveFilePicker?: (options: object) => Promise<FileSystemFileHandle>}} Pickers */
const pickers = () => /** @type {Window & Pickers} */ (window);

const TYPES = [{ description: 'Linkage', accept: { 'application/json': ['.json'] } }];

/** @param {App} app @param {HTMLInputElement} chooser */
export function createActions(app, chooser) {
  const { store, planner, say, open, whole } = app;

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
    const { text, flaw } = await textOf(doc);
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
    say(`${done} ${flaw}`.trim());
  }

  /** @param {import('../../core/types.js').MechanismDocument} doc @returns {Promise<{text: string, flaw: string}>} `flaw` in words, if it has one */
  async function textOf(doc) {
    const read = await ask(() => planner.normalise(JSON.stringify(doc)), 'read the document');
    if (read.is === 'answer') return { text: read.value, flaw: '' };
    // The work is the person's, with its fault too.
    const flaw = read.is === 'fault' ? 'It is at fault, and opens again only after that is mended.' : `It was not checked for faults. ${read.message}`;
    return { text: `${JSON.stringify(doc, null, 2)}\n`, flaw };
  }

  const fresh = () => withPart(app, 'What makes new linkages', () => import('../new-dialog.js'), ({ openNew }) => openNew(app));

  async function share() {
    const read = await whole(JSON.stringify(store.doc));
    if (read.is === 'fault') say(`A link is made of a document without faults. ${faultText(read.fault)}`, { stays: true });
    if (read.is === 'trouble') say(`No link was made. ${read.message}`, { label: 'Try again', act: share, stays: true });
    if (read.is !== 'answer') return;
    const text = JSON.stringify(read.value);
    const payload = text.length > MAX_TEXT ? '' : await encode(text);
    if (!payload || payload.length > MAX_PAYLOAD) {
      say(`The document has ${(text.length / 1e6).toFixed(1)} MB, which is too large for a link. Save it to a file and send that.`, { label: 'Save to a file', act: () => save(true), stays: true });
      return;
    }
    openShare(app, text, payload);
  }

  return { fresh, pick, save, share, take };
}

/** @param {unknown} error */
const isAbort = (error) => error instanceof DOMException && error.name === 'AbortError';

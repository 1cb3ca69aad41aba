/**
 * Keeps the work in the browser's own storage: the document with its undo steps, and what would otherwise have been
 * overwritten. Knows no DOM; the storage is handed in.
 *
 * The kept text is a stamp, a line end, and JSON. A page overwrites only what it has loaded or written itself, by the
 * stamp; work of another page, or from before a link was opened, goes onto the shelf first.
 *
 * @typedef {import('../../core/types.js').MechanismDocument} MechanismDocument
 * @typedef {{doc: MechanismDocument, past: MechanismDocument[], future: MechanismDocument[],
 *   good: MechanismDocument | null, title: string, unsaved: boolean}} Work
 *   `good` is the last document without a fault, if the present one has one; `title` what its file is called
 * @typedef {{when: number, by: string, title: string, doc?: MechanismDocument, text?: string}} Earlier `text` in place of a
 *   document, where it cannot be read
 */

import { textOf } from '../../core/document-text.js';
import { same } from '../../core/spread.js';

/** The 1 is the version of the form. */
const KEPT = 'synthetica.work.1';
const SHELF = 'synthetica.earlier.1';
/** Where versions of the page before this one put a text that they could not read. */
const BROKEN = 'synthetica.broken';

/** Undo steps that are kept, fewer where they do not fit. */
const STEPS = [60, 8, 0];

/** Characters that no browser's storage holds; most hold half of it. */
export const LARGEST = 10_000_000;

/** Pieces of earlier work on the shelf. */
export const MAX_EARLIER = 6;

/**
 * @param {() => Storage} storage may throw: some browsers forbid even the look at it
 * @param {string} page tells this page from another tab's
 */
export function createKeeper(storage, page) {
  let known = '';
  let writes = 0;

  /** @param {string} key @returns {string | null} */
  const read = (key) => {
    try {
      return storage().getItem(key);
    } catch {
      return null;
    }
  };
  /** @param {string} key @param {string} text whether it is kept now */
  const write = (key, text) => {
    try {
      storage().setItem(key, text);
      return true;
    } catch {
      return false;
    }
  };

  /** @param {string} key */
  const remove = (key) => {
    try {
      storage().removeItem(key);
    } catch {
      // It stays.
    }
  };

  /** @returns {Earlier[]} newest first */
  const earlier = () => {
    try {
      const list = JSON.parse(read(SHELF) ?? '[]');
      const listed = Array.isArray(list) ? list.map(fromStored).filter((entry) => isDocument(entry?.doc) || typeof entry?.text === 'string') : [];
      const old = read(BROKEN);
      return old ? [...listed, { when: 0, by: '', title: '', text: old }] : listed;
    } catch {
      return [];
    }
  };

  /**
   * Puts kept work aside, unless it is a document in which nothing was changed.
   * @param {string} text @param {boolean} [always] also then @returns {boolean} whether it may be overwritten
   */
  function shelve(text, always = false) {
    const work = parse(text);
    if (work && !always && !(work.unsaved || work.past.length)) return true;
    const what = work ? { by: stampOf(text).split(' ')[0], title: work.title, doc: work.doc } : { by: '', title: '', text };
    const others = earlier().filter(({ by, doc, text: other }) => !(what.by && by === what.by) && !same([doc, other], [what.doc, what.text]));
    if (!write(SHELF, JSON.stringify([{ when: Date.now(), ...what }, ...others].slice(0, MAX_EARLIER).map(toStored)))) return false;
    remove(BROKEN);
    return true;
  }

  return {
    earlier,

    /** The kept work, or a text that cannot be read, which is put aside. @returns {{work: Work | null, broken: string}} */
    load() {
      const text = read(KEPT);
      if (!text) return { work: null, broken: '' };
      const work = parse(text);
      if (work) {
        known = stampOf(text);
        return { work, broken: '' };
      }
      this.setAside();
      return { work: null, broken: text };
    },

    /** Another document is shown than the kept one: it goes onto the shelf before it is overwritten. */
    disown() {
      known = '';
    },

    /** The kept work cannot be shown: it goes onto the shelf. Where that is full, it stays, and nothing is kept in its place. */
    setAside() {
      known = '';
      if (shelve(read(KEPT) ?? '', true)) remove(KEPT);
    },

    /** @param {Work} work @returns {boolean} false where the storage is full or forbidden */
    save(work) {
      const present = read(KEPT);
      if (present && stampOf(present) !== known && !shelve(present)) return false;
      const stamp = `${page} ${++writes}`;
      const room = LARGEST / Math.max(1, textOf(work.doc).length);
      for (const steps of STEPS.filter((many) => many === 0 || 1 + 2 * many <= room)) {
        // No browser keeps so much: its text is not even made.
        if (room < 1) return false;
        const { past, future } = work;
        const kept = { ...work, past: steps ? past.slice(-steps) : [], future: future.slice(0, steps) };
        if (write(KEPT, `${stamp}\n${JSON.stringify(toStored(kept))}`)) {
          known = stamp;
          return true;
        }
      }
      return false;
    },

    /** Whether a change of the storage is another page's work. @param {{key: string | null, newValue: string | null}} event */
    isOthers: ({ key, newValue }) => key === KEPT && newValue !== null && stampOf(newValue) !== known,
  };
}

/** In the stored form, which earlier versions of the page wrote too, a document is called so. @template T @param {T & {doc?: MechanismDocument}} entry */
const toStored = ({ doc, ...rest }) => ({ document: doc, ...rest });

/** @param {any} entry @returns {any} */
const fromStored = ({ document: doc, ...rest }) => ({ doc, ...rest });

/** @param {string} text */
const stampOf = (text) => text.slice(0, Math.max(0, text.indexOf('\n')));

/** @param {string} text @returns {Work | null} */
function parse(text) {
  try {
    const { doc, past, future, good, title, unsaved } = fromStored(JSON.parse(text.slice(text.indexOf('\n') + 1)));
    if (!isDocument(doc)) return null;
    const documents = (/** @type {unknown} */ list) => (Array.isArray(list) && list.every(isDocument) ? list : []);
    return { doc, past: documents(past), future: documents(future), good: isDocument(good) ? good : null, title: String(title ?? ''), unsaved: unsaved === true };
  } catch {
    return null;
  }
}

/** Whether the tables can be made for it; whether it is without a fault is Rust's to say. @param {any} value @returns {value is MechanismDocument} */
const isDocument = (value) =>
  typeof value === 'object' && value !== null && Array.isArray(value.chains) &&
  value.chains.every((/** @type {any} */ chain) => Array.isArray(chain?.joints) && chain.joints.every((/** @type {any} */ joint) => typeof joint?.type === 'string')) &&
  isList(value.motion?.key_frames ?? value.motion?.drivers) && isList(value.motion.drivers ?? []) && (value.motion.drivers ?? []).every((/** @type {any} */ { values }) => isList(values));

const isList = (/** @type {unknown} */ list) => Array.isArray(list) && list.every((item) => typeof item === 'object' && item !== null);

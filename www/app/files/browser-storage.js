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
 * @typedef {{when: number, by: string, title: string, doc: MechanismDocument}} Earlier
 */

/** The 1 is the version of the form. */
const KEPT = 'synthetica.work.1';
const SHELF = 'synthetica.earlier.1';
const BROKEN = 'synthetica.broken';

/** Undo steps that are kept, fewer where they do not fit. */
const STEPS = [60, 8, 0];

/** Pieces of earlier work on the shelf. */
const MAX_EARLIER = 6;

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

  /** @returns {Earlier[]} newest first */
  const earlier = () => {
    try {
      const list = JSON.parse(read(SHELF) ?? '[]');
      return Array.isArray(list) ? list.map(fromStored).filter((entry) => isDocument(entry?.doc)) : [];
    } catch {
      return [];
    }
  };

  /** Puts kept work aside, unless nothing was changed in it. @param {string} text @returns {boolean} whether it may be overwritten */
  function shelve(text) {
    const work = parse(text);
    if (!work || !(work.unsaved || work.past.length)) return true;
    const by = text.slice(0, text.indexOf('\n')).split(' ')[0];
    const { doc, title } = work;
    const others = earlier().filter((entry) => entry.by !== by && !same(entry.doc, doc));
    return write(SHELF, JSON.stringify([{ when: Date.now(), by, title, doc }, ...others].slice(0, MAX_EARLIER).map(toStored)));
  }

  return {
    earlier,

    /** The kept work; `broken` if there is something that cannot be read, which is put aside. @returns {{work: Work | null, broken: boolean}} */
    load() {
      const text = read(KEPT);
      if (!text) return { work: null, broken: false };
      const work = parse(text);
      if (work) {
        known = stampOf(text);
        return { work, broken: false };
      }
      this.setAside(text);
      return { work: null, broken: true };
    },

    /** Another document is shown than the kept one: it goes onto the shelf before it is overwritten. */
    disown() {
      known = '';
    },

    /** What could not be shown. @param {string} [text] the kept text unless told */
    setAside(text = read(KEPT) ?? '') {
      if (write(BROKEN, text)) {
        try {
          storage().removeItem(KEPT);
        } catch {
          // It stays, and is overwritten by the next edit.
        }
      }
    },
    broken: () => read(BROKEN) ?? '',

    /** @param {Work} work @returns {boolean} false where the storage is full or forbidden */
    save(work) {
      const present = read(KEPT);
      if (present && stampOf(present) !== known && !shelve(present)) return false;
      const stamp = `${page} ${++writes}`;
      for (const steps of STEPS) {
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

/** In the stored form, which earlier versions of the page wrote too, a document is called so. @template T @param {T & {doc: MechanismDocument}} entry */
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
  Array.isArray(value.motion?.key_frames) && value.motion.key_frames.every((/** @type {any} */ key) => typeof key === 'object' && key !== null);

/** @param {unknown} a @param {unknown} b */
const same = (a, b) => JSON.stringify(a) === JSON.stringify(b);

/**
 * Opens in an element the document that it is given, or that its attributes or its content ask for. Of several requests the
 * newest counts.
 */
import { ask, LATE, untilAnswered } from '../core/ask.js';
import { isEmpty } from '../core/linkage.js';
import { Refusal } from '../core/refusal.js';
import { findDocument } from './find.js';

/** How long an element may be without a document before it says so, in milliseconds: a script may be about to give it one. */
const PATIENCE = 1000;

const NOTHING_GIVEN = 'No linkage is given. Accepted: a document by src, by a script of type application/json inside, or by the property document; or a sample by type.';

/**
 * @param {HTMLElement & {src: string, type: string, parts: import('../core/linkage.js').Linkage}} element
 * @param {(error: unknown) => void} complain
 * @param {Promise<unknown>} begun before that nothing is loaded
 */
export function createOpening(element, complain, begun) {
  const { parts: linkage } = element;
  /** Counts requests: an answer to an older one is late. */
  let loads = 0;
  /** Goes on with a load that was interrupted because the element was taken out. @type {((back: null) => void) | null} */
  let goOn = null;
  let opens = false;
  let waits = true;
  begun.then(() => (waits = false));

  /** What the attributes or the content ask for. */
  async function load() {
    const now = ++loads;
    if (waits) await begun;
    if (now !== loads) return;
    try {
      const found = await findDocument(element, (type) => answer(now, () => ask(() => linkage.planner.assemble(type), 'make a linkage of this type')));
      if (found) await open(found.text, found.title, now);
      else if (document.readyState === 'loading') document.addEventListener('DOMContentLoaded', () => now === loads && load(), { once: true });
      else setTimeout(() => now === loads && isEmpty(linkage.store) && complain(new Refusal(NOTHING_GIVEN)), PATIENCE);
    } catch (error) {
      if (now === loads) complain(error);
    }
  }

  /**
   * Asked again after trouble, and when the element is put back that was taken out meanwhile, while nothing else is to be shown.
   * @template {{is: string}} O @param {number} now @param {() => Promise<O>} question
   */
  async function answer(now, question) {
    for (;;) {
      const outcome = await untilAnswered(linkage.store, async () => (now === loads ? question() : LATE));
      if (outcome.is !== 'late' || now !== loads) return outcome;
      if (!element.isConnected) await new Promise((resolve) => (goOn = resolve));
    }
  }

  /** @param {string} text @param {string} title @param {number} now */
  async function open(text, title, now) {
    const { store, whole } = linkage;
    if (waits) await begun;
    const read = await answer(now, () => whole(text));
    if (now !== loads) return;
    if (read.is === 'fault') store.setResult({ fault: read.fault, trouble: '' });
    if (read.is !== 'answer') return;
    const doc = read.value;
    opening.isFresh = opens = true;
    store.restore({ doc, past: [], future: [] }, { title, handle: null, saved: doc });
    opens = false;
  }

  const opening = {
    /** The next motion is the first of its document. */
    isFresh: true,
    /** A document is being opened that is no edit. */
    get opens() {
      return opens;
    },
    load,
    /** Loads unless something is there or asked for. */
    loadFirst() {
      if (isEmpty(linkage.store) && !loads) load();
    },
    /** The element has been put back. */
    comeBack: () => goOn?.(null),
    /** A document as an object or its text; null waits for one, whatever the attributes ask for. @param {unknown} next */
    give(next) {
      const now = ++loads;
      if (next === null) return;
      if (typeof next !== 'string' && (typeof next !== 'object' || Array.isArray(next))) {
        complain(new Refusal(`The property document is ${Array.isArray(next) ? 'a list' : typeof next}. Accepted: a document as an object or its text.`));
        return;
      }
      open(typeof next === 'string' ? next : JSON.stringify(next), '', now);
    },
  };
  return opening;
}

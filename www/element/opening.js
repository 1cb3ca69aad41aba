/**
 * Opens in an element the document that it is given, or that its attributes or its content ask for. Of several requests the
 * newest counts.
 */
import { ask, LATE, untilAnswered } from '../core/ask.js';
import { empty, isEmpty } from '../core/nothing.js';
import { reason } from '../core/open.js';
import { Refusal } from '../core/refusal.js';
import { askedFor, findDocument, isByType } from './find.js';

/** How long an element may be without a document before it says so, in milliseconds: a script may be about to give it one. */
const PATIENCE = 1000;

const NOTHING_GIVEN = 'No linkage is given. Accepted: a document by src, by a script of type application/json inside, or by the property document; or a sample by type.';

/**
 * @param {HTMLElement & {src: string, type: string, parts: import('./media-properties.js').LinkageWords['parts']}} element
 * @param {object} inside
 * @param {Promise<unknown>} inside.started before that nothing is loaded
 * @param {(error: unknown) => void} inside.complain
 * @param {() => void} inside.emptied it has no document any more
 * @param {() => void} inside.settle the playhead goes where it was set meanwhile
 */
export function createOpening(element, { started, complain, emptied, settle }) {
  const { parts: linkage } = element;
  const { store, player, playhead } = linkage;
  /** Counts requests: an answer to an older one is late. */
  let loads = 0;
  /** What the attributes and the content asked for when that was last looked at; null where a document was given since. @type {string | null} */
  let lastAsked = null;
  /** Goes on with a load that was interrupted because the element was taken out. @type {((back: null) => void) | null} */
  let resume = null;
  let isOpening = false;
  let isStarted = false;
  started.then(() => (isStarted = true));
  /** Until a document is there, what comes to stand inside is seen. A server that renders pages has none. */
  const content = globalThis.MutationObserver && new MutationObserver(() => lookAgain());

  const lookAgain = () => lastAsked !== null && askedFor(element) !== lastAsked && element.isConnected && load();

  /** @param {boolean} another whether another document is asked for */
  function begin(another) {
    if (another) player.first.requested();
    if (!isEmpty(store)) playhead.forget();
    return ++loads;
  }

  /** What the attributes or the content ask for. */
  async function load() {
    lastAsked = askedFor(element);
    const now = begin(lastAsked !== '' || !isEmpty(store));
    content.observe(element, { childList: true, characterData: true, subtree: true });
    // The page's parser may be about to add what is asked for before anything else.
    if (document.readyState === 'loading') document.addEventListener('DOMContentLoaded', lookAgain, { once: true });
    if (!lastAsked) return isEmpty(store) ? nothingYet(now) : clear();
    if (!isStarted) await started;
    if (now !== loads) return;
    const known = isByType(element) ? linkage.planner.hold() : () => {};
    /** @param {string} type */
    const assemble = (type) => {
      const made = ask(() => linkage.planner.assemble(type), 'make a linkage of this type');
      known();
      return made;
    };
    try {
      const found = await findDocument(element, (type) => answer(now, () => assemble(type))).finally(known);
      if (found && now === loads) await open(found.text, found.title, now);
    } catch (error) {
      if (now === loads) fail(error);
    }
  }

  /** @param {number} now */
  async function nothingYet(now) {
    player.first.requestedNothing();
    forgive();
    await started;
    if (document.readyState === 'loading') await new Promise((ready) => document.addEventListener('DOMContentLoaded', ready, { once: true }));
    setTimeout(() => now === loads && isEmpty(store) && fail(new Refusal(NOTHING_GIVEN)), PATIENCE);
  }

  /** @param {unknown} error */
  function fail(error) {
    failed(reason(error));
    complain(error);
  }

  /** The document before stays, and what was wanted meanwhile is wanted of that. @param {string} why */
  function failed(why) {
    player.first.failed(why);
    if (!player.first.isAwaited) settle();
  }

  /** What was wrong with another document is over. */
  function forgive() {
    const { fault, trouble } = store.result;
    if (fault || trouble) store.setResult({ fault: null, trouble: '' });
  }

  /** Without a document, until another one is asked for. */
  function clear() {
    player.first.emptied();
    forgive();
    if (isEmpty(store)) return;
    opening.isFresh = isOpening = true;
    playhead.forget();
    empty(store);
    element.removeAttribute('frame');
    isOpening = false;
    emptied();
  }

  /**
   * Asked again after trouble, and when the element is put back that was taken out meanwhile, while nothing else is to be shown.
   * @template {{is: string}} O @param {number} now @param {() => Promise<O>} question
   */
  async function answer(now, question) {
    for (;;) {
      const outcome = await untilAnswered(store, async () => (now === loads ? question() : LATE));
      if (outcome.is !== 'late' || now !== loads) return outcome;
      if (!element.isConnected) await new Promise((resolve) => (resume = resolve));
    }
  }

  /** @param {string} text @param {string} title @param {number} now */
  async function open(text, title, now) {
    if (!isStarted) await started;
    const read = await answer(now, () => linkage.whole(text));
    if (now !== loads) return;
    if (read.is === 'fault') {
      failed(read.message);
      store.setResult({ fault: read.fault, trouble: '' });
    }
    if (read.is !== 'answer') return;
    const doc = read.value;
    opening.isFresh = isOpening = true;
    // Where the former document's playhead rested says nothing of this one.
    if (!isEmpty(store) && !playhead.isWanted) element.removeAttribute('frame');
    player.first.opened();
    store.setView({ selected: '', hovered: '' });
    store.restore({ doc, past: [], future: [] }, { title, handle: null, saved: doc });
    forgive();
    isOpening = false;
    content.disconnect();
  }

  const opening = {
    /** The next motion is the first of its document. */
    isFresh: true,
    /** A document is being opened that is no edit. */
    get isOpening() {
      return isOpening;
    },
    /** The attributes may ask for something else. @param {boolean} isRemoved one was taken away */
    attributeChanged(isRemoved) {
      // A document that was given stays when an attribute goes that had no part in it.
      if (isRemoved && lastAsked === null) return;
      if (element.isConnected && askedFor(element) !== lastAsked) load();
      else if (!element.isConnected) lastAsked ??= '';
    },
    /** The element is in a page: loads what was asked for meanwhile, and at first what there is. */
    loadWhatIsAsked() {
      if (loads === 0 ? isEmpty(store) : lastAsked !== null && askedFor(element) !== lastAsked) load();
    },
    /** The element has been put back. */
    resume: () => resume?.(null),
    /** A document as an object or its text; null waits for one, whatever the attributes ask for. @param {unknown} next */
    setDocument(next) {
      const now = begin(true);
      lastAsked = null;
      content.disconnect();
      if (next == null) {
        clear();
        return;
      }
      if (typeof next !== 'string' && (typeof next !== 'object' || Array.isArray(next))) {
        fail(new Refusal(`The property document is ${Array.isArray(next) ? 'a list' : typeof next}. Accepted: a document as an object or its text.`));
        return;
      }
      open(typeof next === 'string' ? next : JSON.stringify(next), '', now);
    },
  };
  return opening;
}

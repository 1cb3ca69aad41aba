/**
 * For the page around a frame: `const frame = linkageFrame(iframe)` talks to the linkage in it, by the protocol of
 * protocol.js.
 *
 * @typedef {'ready' | 'document' | 'state' | 'height' | 'error'} Told
 * @typedef {{resolve: (value: any) => void, reject: (reason: Error) => void}} Asked
 */
import { VERSION } from './version.js';

/** In this order they are told to who begins to listen late. @type {Told[]} */
const TOLD = ['ready', 'document', 'state', 'height', 'error'];

/** How long an answer may take, in milliseconds. */
const PATIENCE = 10000;

/**
 * @param {HTMLIFrameElement} iframe shows a frame's page
 * @param {object} [wish]
 * @param {boolean} [wish.fit] the frame gets the height that it would fill
 * @param {string} [wish.origin] of the frame's page; `*` where it is sandboxed without an origin of its own
 * @param {number} [wish.patience] milliseconds after which `get` gives up
 */
export function linkageFrame(iframe, { fit = false, origin = sandboxed(iframe) ? '*' : new URL(iframe.src, document.baseURI).origin, patience = PATIENCE } = {}) {
  /** @type {Map<unknown, Asked>} */
  const waiting = new Map();
  /** @type {Record<Told, Set<(content: any) => void>>} */
  const listeners = { ready: new Set(), document: new Set(), state: new Set(), height: new Set(), error: new Set() };
  /** What has been heard since the frame's page was loaded. @type {Set<Told>} */
  let known = new Set();
  /** What waits until the frame is there to hear it; null once it is. @type {object[] | null} */
  let unsent = [];
  /** Why no answer will come. */
  let silence = '';
  // Another helper of the same frame hears the answers too.
  const own = Math.random();
  let asked = 0;

  const post = (/** @type {object} */ message, to = origin) => iframe.contentWindow?.postMessage({ synthetica: VERSION, ...message }, to);
  const send = (/** @type {object} */ message) => (unsent ? void unsent.push(message) : post(message));

  /** @param {unknown} id */
  function settle(id) {
    const one = waiting.get(id);
    waiting.delete(id);
    return one;
  }

  /** Nothing that waits will be answered. @param {string} why */
  function giveUp(why) {
    silence = why;
    for (const id of [...waiting.keys()]) settle(id)?.reject(new Error(why));
  }

  /** @param {Told} type @param {any} content */
  function tell(type, content) {
    known.add(type);
    if (fit && type === 'height') iframe.style.height = `${content}px`;
    for (const listener of listeners[type] ?? []) listener(content);
  }

  /** The frame says that it is there, and if it was asked what it has told so far. @param {Record<string, any>} greeting */
  function meet(greeting) {
    if (!greeting.again) known = new Set();
    for (const type of TOLD) if (type in greeting && !known.has(type)) tell(type, greeting[type]);
    if (!greeting.listens) giveUp('This frame listens to nobody, because it does not know the page around it. Accepted: the origin of that page in the frame’s address, such as origin=https://course.example, or a page that sends its referrer.');
    else silence = '';
  }

  /** @param {MessageEvent} event */
  function receive({ source, origin: from, data }) {
    if (source !== iframe.contentWindow || (origin !== '*' && from !== origin) || data?.synthetica !== VERSION) return;
    const { type, id, error } = data;
    const messages = unsent ?? [];
    unsent = null;
    for (const message of messages) post(message);
    if (type === 'hello') return meet(data);
    if (id === undefined) return tell(type, data[type] ?? data);
    if (type === 'error') settle(id)?.reject(new Error(error.message));
    else settle(id)?.resolve(data[type]);
  }
  addEventListener('message', receive);
  // A frame that is there already tells what it has told so far. To any page: this says nothing.
  post({ type: 'hello' }, '*');

  return {
    /** @param {Told} type @param {(content: any) => void} listener @returns {() => void} ends it */
    on(type, listener) {
      listeners[type].add(listener);
      return () => listeners[type].delete(listener);
    },
    /**
     * Rejects what the frame refuses, and what it does not answer in time.
     * @param {'document' | 'trajectory' | 'state' | 'height'} what @returns {Promise<any>}
     */
    get(what) {
      const id = `${own}/${++asked}`;
      return new Promise((resolve, reject) => {
        if (silence) return reject(new Error(silence));
        const late = setTimeout(() => {
          const why = unsent ? 'it is not loaded: its address does not open, is of another origin than this helper was told, or waits to come into view (loading="lazy")' : 'it is busy, or its page has been left';
          settle(id)?.reject(new Error(`The frame gave no “${what}” within ${patience / 1000} s: ${why}.`));
        }, patience);
        const done = (/** @type {(value: any) => void} */ act) => (/** @type {any} */ value) => {
          clearTimeout(late);
          act(value);
        };
        waiting.set(id, { resolve: done(resolve), reject: done(reject) });
        send({ type: 'get', what, id });
      });
    },
    /** Shows a document; in place of the address's own if that is not there yet. @param {object | string} doc */
    setDocument: (doc) => send({ type: 'document', document: doc }),
    /** @param {{paused?: boolean, frame?: number, currentTime?: number, speed?: number, loop?: boolean, bounce?: boolean, view?: string, theme?: string, panels?: string, interaction?: string}} state */
    setState: (state) => send({ type: 'state', state }),
    /** Stops listening; what waits for an answer is rejected. */
    close() {
      removeEventListener('message', receive);
      giveUp('The helper of this frame is closed.');
    },
  };
}

/** @param {HTMLIFrameElement} iframe */
const sandboxed = (iframe) => iframe.hasAttribute('sandbox') && !iframe.sandbox.contains('allow-same-origin');

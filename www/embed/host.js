/**
 * For the page around a frame: `const frame = linkageFrame(iframe)` talks to the linkage in it, by the protocol of
 * protocol.js.
 *
 * @typedef {'ready' | 'document' | 'state' | 'height' | 'error'} Told
 */
const VERSION = 1;

/**
 * @param {HTMLIFrameElement} iframe shows a frame's page
 * @param {object} [wish]
 * @param {boolean} [wish.fit] the frame gets the height that it would fill
 * @param {string} [wish.origin] of the frame's page; `*` where it is sandboxed without an origin of its own
 */
export function linkageFrame(iframe, { fit = false, origin = sandboxed(iframe) ? '*' : new URL(iframe.src, document.baseURI).origin } = {}) {
  /** @type {Map<number, {resolve: (value: any) => void, reject: (reason: Error) => void}>} */
  const waiting = new Map();
  /** @type {Record<Told, Set<(content: any) => void>>} */
  const listeners = { ready: new Set(), document: new Set(), state: new Set(), height: new Set(), error: new Set() };
  let lastId = 0;

  /** @param {string} type @param {object} content */
  const send = (type, content) => iframe.contentWindow?.postMessage({ synthetica: VERSION, type, ...content }, origin);

  /** @param {MessageEvent} event */
  function receive({ source, origin: from, data }) {
    if (source !== iframe.contentWindow || (origin !== '*' && from !== origin) || data?.synthetica !== VERSION) return;
    const { type, id, error } = data;
    const asked = waiting.get(id);
    if (asked) {
      waiting.delete(id);
      if (type === 'error') asked.reject(new Error(error.message));
      else asked.resolve(data[type]);
      return;
    }
    if (fit && type === 'height') iframe.style.height = `${data.height}px`;
    for (const listener of listeners[/** @type {Told} */ (type)] ?? []) listener(data[type] ?? data);
  }
  addEventListener('message', receive);

  return {
    /** @param {Told} type @param {(content: any) => void} listener @returns {() => void} ends it */
    on(type, listener) {
      listeners[type].add(listener);
      return () => listeners[type].delete(listener);
    },
    /** @param {'document' | 'trajectory' | 'state' | 'height'} what @returns {Promise<any>} */
    get(what) {
      const id = ++lastId;
      return new Promise((resolve, reject) => {
        waiting.set(id, { resolve, reject });
        send('get', { what, id });
      });
    },
    /** Shows a document. @param {object | string} doc */
    setDocument: (doc) => send('document', { document: doc }),
    /** @param {{paused?: boolean, frame?: number, currentTime?: number, speed?: number, loop?: boolean, bounce?: boolean, view?: string, theme?: string, panels?: string}} state */
    setState: (state) => send('state', { state }),
    /** Stops listening. */
    close: () => removeEventListener('message', receive),
  };
}

/** @param {HTMLIFrameElement} iframe */
const sandboxed = (iframe) => iframe.hasAttribute('sandbox') && !iframe.sandbox.contains('allow-same-origin');

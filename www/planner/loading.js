/**
 * How much of the planner's wasm has come: counted in the worker that fetches it, and told on the page.
 *
 * @typedef {{kind: 'loading', loaded: number, total: number}} Loading bytes, as they are after decompression
 */

/** Of the page's worker. @type {Loading | null} */
let latest = null;
/** @type {Set<() => void>} */
const listeners = new Set();

export const loading = {
  get latest() {
    return latest;
  },
  /** @param {Loading} next */
  tell(next) {
    latest = next;
    for (const listener of [...listeners]) listener();
  },
  /** @param {() => void} listener @param {AbortSignal} signal ends it */
  subscribe(listener, signal) {
    listeners.add(listener);
    signal.addEventListener('abort', () => listeners.delete(listener), { once: true });
  },
};

/**
 * Counts what a response brings. The length in its header would be that of the compressed bytes.
 * @param {Response} response @param {number} total @param {(message: Loading) => void} send @returns {Response}
 */
export function counted(response, total, send) {
  if (!response.ok || !response.body) return response;
  let loaded = 0;
  send({ kind: 'loading', loaded, total });
  const counter = new TransformStream({
    transform(/** @type {Uint8Array} */ bytes, out) {
      loaded += bytes.byteLength;
      send({ kind: 'loading', loaded, total });
      out.enqueue(bytes);
    },
  });
  return new Response(response.body.pipeThrough(counter), response);
}

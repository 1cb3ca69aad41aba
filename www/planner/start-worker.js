/**
 * Starts the planner's worker. The package's builds put another module in this one's place (see tools/package/planner.js).
 */

/** Bundlers know a worker's file by the expression that makes one; here it only says where the file is. */
const { address } = (() => {
  class Worker {
    /** @param {URL} address @param {{type: 'module'}} _ */
    constructor(address, _) {
      this.address = String(address);
    }
  }
  return new Worker(new URL('./worker.js', import.meta.url), { type: 'module' });
})();

/**
 * The one that the page's first script has started, see public/first.js, with what it has said since: once.
 * @returns {Worker | null}
 */
function startedEarly() {
  const page = /** @type {{syntheticaWorker?: {worker: Worker, said: Event[]}}} */ (/** @type {unknown} */ (globalThis));
  const { worker, said } = page.syntheticaWorker ?? {};
  delete page.syntheticaWorker;
  if (!worker || !said) return null;
  // Whoever takes it listens by then, and all that it says from now on comes later.
  queueMicrotask(() => {
    for (const event of said) worker.dispatchEvent(new /** @type {typeof Event} */ (event.constructor)(event.type, event));
  });
  return worker;
}

/** A worker must be of the page's own origin: code that comes from another one is imported by a small one that is. */
export function startWorker() {
  const early = startedEarly();
  if (early) return early;
  const own = new URL(address).origin === globalThis.origin;
  const text = `import ${JSON.stringify(address)};`;
  return new Worker(own ? address : URL.createObjectURL(new Blob([text], { type: 'text/javascript' })), { type: 'module' });
}

/** How many workers a program may have. */
export const atMost = () => 1;

/**
 * Starts the planner's worker. Bundlers know a worker by the expression in `start`, so it is written out as it is.
 */

const start = () => new Worker(new URL('./worker.js', import.meta.url), { type: 'module' });

/** @param {string} [address] of worker.js, where it was said */
export function startWorker(address) {
  try {
    return address ? new Worker(address, { type: 'module' }) : start();
  } catch (error) {
    // The package lies on another origin than the page, which may import a script from there but not start it.
    if (typeof Worker !== 'function') throw error;
    const [url, type] = address ? [address, 'module'] : asked();
    const text = type === 'module' ? `import ${JSON.stringify(url)};` : `importScripts(${JSON.stringify(url)});`;
    const own = URL.createObjectURL(new Blob([text], { type: 'text/javascript' }));
    return type === 'module' ? new Worker(own, { type }) : new Worker(own);
  }
}

/** The address and type that a bundler has put into the expression, which it knows only as a whole. @returns {[string, string | undefined]} */
function asked() {
  const { Worker } = globalThis;
  /** @type {[string, string | undefined]} */
  let found;
  try {
    globalThis.Worker = class {
      constructor(url, { type } = {}) {
        found = [String(url), type];
      }
    };
    start();
  } finally {
    globalThis.Worker = Worker;
  }
  return found;
}

/** A browser's program has one worker, beside that of the elements. */
export const atMost = () => 1;

/**
 * Starts the planner's worker. Bundlers know a worker by this very expression, so it is written out as it is.
 */

/** Not for bundlers, which would take it for one file more. */
const NAME = 'worker.js';

export function startWorker() {
  try {
    return new Worker(new URL('./worker.js', import.meta.url), { type: 'module' });
  } catch {
    // The package lies on another origin than the page, which may import a script from there but not start it.
    const text = `import ${JSON.stringify(new URL(NAME, import.meta.url))};`;
    return new Worker(URL.createObjectURL(new Blob([text], { type: 'text/javascript' })), { type: 'module' });
  }
}

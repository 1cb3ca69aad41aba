/**
 * The inline build's planner: what is elsewhere a file of its own is held as text in the one script.
 */
import packed from 'held:wasm';
import script from 'held:worker';

/** @param {unknown} [given] what a program said to load instead */
export function wasm(given) {
  if (given !== undefined) return given;
  const bytes = Uint8Array.from(atob(packed), (character) => character.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'))).arrayBuffer();
}

/** The wasm's text is there once, and handed on. @param {string} [address] of worker.js, where it was said */
export function startWorker(address) {
  if (address) return new Worker(address, { type: 'module' });
  const text = [`self.packed = '${packed}';`, script];
  return new Worker(URL.createObjectURL(new Blob(text, { type: 'text/javascript' })));
}

/** A browser's program has one worker, beside that of the elements. */
export const atMost = () => 1;

/**
 * The inline build's planner: what is elsewhere a file of its own is held as text in the one script.
 */
import packed from 'held:wasm';
import script from 'held:worker';

/** @returns {Promise<ArrayBuffer>} */
export function wasm() {
  const bytes = Uint8Array.from(atob(packed), (character) => character.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'))).arrayBuffer();
}

/** The wasm's text is there once, and handed on. */
export function startWorker() {
  const text = [`self.packed = '${packed}';`, script];
  return new Worker(URL.createObjectURL(new Blob(text, { type: 'text/javascript' })));
}

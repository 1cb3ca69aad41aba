/**
 * The planner's wasm in Node, which does not fetch files.
 */
import { readFile } from 'node:fs/promises';

/** @param {unknown} [given] what a program said to load instead: an address, a path, or what is there */
export async function wasm(given) {
  if (given === undefined) return own();
  if (typeof given !== 'string' || /^https?:/.test(given)) return given;
  return readFile(given.startsWith('file:') ? new URL(given) : given);
}

/** A bundler may have moved the file to where only browsers find it, as Next's does: then it is had from a script, which takes longer. */
async function own() {
  try {
    return await readFile(new URL('./synthetica.wasm', import.meta.url));
  } catch {
    const { wasm: packed } = await import('./wasm-text.node.js');
    return packed();
  }
}

/**
 * The planner's wasm in Node, which does not fetch files.
 */
import { readFile } from 'node:fs/promises';

/** @param {unknown} [given] what a program said to load instead: an address, a path, or what is there */
export function wasm(given) {
  if (given === undefined) return readFile(new URL('./synthetica.wasm', import.meta.url));
  if (typeof given !== 'string' || /^https?:/.test(given)) return given;
  return readFile(given.startsWith('file:') ? new URL(given) : given);
}

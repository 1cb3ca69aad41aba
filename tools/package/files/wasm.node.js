/**
 * The planner's wasm in Node, which does not fetch files.
 */
import { readFile } from 'node:fs/promises';

export const wasm = () => readFile(new URL('./synthetica.wasm', import.meta.url));

/**
 * Where the planner's wasm lies. Bundlers know a file by this very expression, so it is written out as it is.
 */

/** @param {unknown} [given] what a program said to load instead */
export const wasm = (given) => given ?? new URL('./synthetica.wasm', import.meta.url);

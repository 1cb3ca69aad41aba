/**
 * Where the planner's wasm lies. Bundlers know a file by this very expression, so it is written out as it is.
 */
export const wasm = () => new URL('./synthetica.wasm', import.meta.url);

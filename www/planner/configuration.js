/**
 * Where the planner's two files are, as a program said by `configure`; undefined where it did not.
 *
 * @typedef {string | BufferSource | WebAssembly.Module} Wasm an address, or what is there
 */
export const configuration = {
  /** @type {Wasm | Promise<Wasm> | undefined} */
  wasm: undefined,
  /** @type {string | undefined} */
  worker: undefined,
  /** The planner has been asked for: too late to say it. */
  begun: false,
};

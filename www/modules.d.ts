/** A page's script and styles as texts, bundled whole by tools/vite.config.js. */
declare module '*?bundle' {
  export const script: string;
  export const style: string;
}

/** The length of the first wasm, which the page's build writes (tools/vite.config.js). */
declare const FIRST_WASM_BYTES: number | undefined;

/** A page's script and styles as texts, bundled whole by tools/vite.config.js. */
declare module '*?bundle' {
  export const script: string;
  export const style: string;
}

/** The lengths of the two wasm files, which the page's build writes (tools/vite.config.js). */
declare const WASM_BYTES: { first: number; whole: number } | undefined;

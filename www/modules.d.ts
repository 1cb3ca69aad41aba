/** A page's script and styles as texts, bundled whole by tools/vite.config.js. */
declare module '*?bundle' {
  export const script: string;
  export const style: string;
}

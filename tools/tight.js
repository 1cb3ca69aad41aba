// What every build of www/ has in common: which browsers it is for, and texts without what only their writers need.
import { readFileSync } from 'node:fs';

/** The first with light-dark(), which otherwise is replaced by something that knows of no scheme but its own sheet's. */
const CSS_TARGET = ['chrome123', 'firefox120', 'safari17.5'];

/** Vite's options. */
export const TARGETS = { target: 'es2022', cssTarget: CSS_TARGET };

/** `file.html?raw`: the blanks between its lines are for its writer. */
export const tightMarkup = () => ({
  name: 'tight-markup',
  enforce: 'pre',
  load(id) {
    const [file, query] = id.split('?');
    if (query !== 'raw' || !file.endsWith('.html')) return null;
    this.addWatchFile(file);
    return `export default ${JSON.stringify(readFileSync(file, 'utf8').replace(/\s*\n\s*/g, ' '))};`;
  },
});

/** The 3D library's shaders are texts, which no minifier shortens: without their margins, remarks and empty lines. */
export const tightShaders = () => ({
  name: 'tight-shaders',
  transform: (code, id) => (id.endsWith('/three.module.js') ? code.replace(/^[ \t]+/gm, '').replace(/^\/\/.*$/gm, '').replace(/\n{2,}/g, '\n') : null),
});

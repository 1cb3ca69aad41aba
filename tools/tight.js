// What every build of www/ has in common: its target browsers, and markup and shaders without the parts that a page never uses.
import { readFileSync, realpathSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { THREE, isOfThree, standInFor } from './lean/modules.js';
import { lean } from './lean/three.js';

const at = (path) => fileURLToPath(new URL(path, import.meta.url));

/** By its own path, also where node_modules is a link: it would be in the page twice, here and where its parts import it. */
const RENDERER = realpathSync(at('node_modules/lit-html/node'));

/** The first with light-dark(), which otherwise is replaced by something that knows of no scheme but its own sheet's. */
const CSS_TARGET = ['chrome123', 'firefox120', 'safari17.5'];

/** Vite's options. */
export const TARGETS = { target: 'es2022', cssTarget: CSS_TARGET };

/** `file.html?raw`: the blanks between its lines are for its writer. */
const tightMarkup = () => ({
  name: 'tight-markup',
  enforce: 'pre',
  load(id) {
    const [file, query] = id.split('?');
    if (query !== 'raw' || !file.endsWith('.html')) return null;
    this.addWatchFile(file);
    return `export default ${JSON.stringify(readFileSync(file, 'utf8').replace(/\s*\n\s*/g, ' '))};`;
  },
});

/**
 * The 3D library from its single modules, of which a bundler leaves out what nobody imports (of its one big file it keeps
 * much), with the modules of tools/three in place of what the page never uses, and without what nothing reaches.
 */
const leanThree = () => ({
  name: 'lean-three',
  apply: 'build',
  enforce: 'pre',
  resolveId(id, importer) {
    if (id === 'three') return join(THREE, 'Three.js');
    return importer?.startsWith(THREE) ? standInFor(id) : null;
  },
  transform(_, id) {
    if (!isOfThree(id)) return null;
    const code = lean().kept(id);
    // Line by line, to see which module the bytes of a build come from.
    return { code, map: { version: 3, sources: [id], names: [], mappings: code.split('\n').map((_, line) => (line ? 'AACA' : 'AAAA')).join(';') } };
  },
});

/** The renderer as servers load it, which is as long: a page that is rendered there may name the element, and there is no document. */
const rendererForServers = () => ({
  name: 'renderer-for-servers',
  apply: 'build',
  enforce: 'pre',
  resolveId(id) {
    const [, part = 'lit-html.js'] = /^lit-html(?:\/(.+))?$/.exec(id) ?? [, null];
    return part && join(RENDERER, part);
  },
});

/**
 * The plots without their own writer of numbers, which every chart here replaces: it is made as the file is loaded, and
 * fails where the browser's language is no language tag, as "C" in WebKit on Linux.
 */
const plotsWithoutLanguage = () => ({
  name: 'plots-without-language',
  enforce: 'pre',
  transform(code, id) {
    if (!/\/uplot\/dist\/uPlot\.esm\.js$/.test(id.split('?')[0])) return null;
    const [before, after, ...more] = code.split("new Intl.NumberFormat(domEnv ? nav.language : 'en-US')");
    if (after === undefined || more.length > 0) throw new Error('uPlot makes its writer of numbers in another way: see plotsWithoutLanguage in tools/tight.js');
    return `${before}{ format: String }${after}`;
  },
});

/** Vite's plugins. */
export const tight = () => [tightMarkup(), leanThree(), rendererForServers(), plotsWithoutLanguage()];

// How Vite serves and builds the page in www/.
import { createHash } from 'node:crypto';
import { readFileSync, readdirSync, statSync, writeFileSync } from 'node:fs';
import { join, relative } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build, defineConfig } from 'vite';
import { early } from './early.js';
import { importedAtOnce } from './imported-at-once.js';
import { licenceComment, licences, ourselves, packagesIn, partsOf } from './licences.js';
import { inlineScript } from './package/inline.js';
import { pages } from './pages.js';
import { onlyStyles, styleLoads } from './style-loads.js';
import { TARGETS, tight } from './tight.js';

const at = (path) => fileURLToPath(new URL(path, import.meta.url));

/** The length of a wasm package. @param {string} name */
const bytes = (name) => statSync(at(`../www/${name}/synthetica_bg.wasm`)).size;

/** Every file below a folder, by its path from there. @param {string} folder */
const filesIn = (folder) =>
  readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => relative(folder, join(entry.parentPath, entry.name)).replaceAll('\\', '/'))
    .sort();

/** What other pages name in a script tag keeps its name: NAME.js is that file of www/ with what it imports. */
const LASTING = { element: 'element/embed.js', frame: 'embed/host.js' };
/** The element as one script that loads nothing, for frames and for files that hold everything. */
const INLINE = 'embed/inline.js';

/** The lasting scripts: inline.js in the build, all of them in dev. */
const lastingScripts = () => ({
  name: 'lasting-scripts',
  async generateBundle() {
    this.emitFile({ type: 'asset', fileName: 'inline.js', source: (await inlineScript(INLINE)).script });
  },
  configureServer({ middlewares }) {
    const serve = (name, text) =>
      middlewares.use(`/${name}.js`, async (_, response, next) => {
        const script = await text().catch(next);
        if (script) response.setHeader('content-type', 'text/javascript').end(script);
      });
    for (const [name, file] of Object.entries(LASTING)) serve(name, async () => `export * from '/${file}';`);
    serve('inline', async () => (await inlineScript(INLINE)).script);
  },
});

/** Writes www/service-worker.js into the build, with the list of its files. */
const serviceWorker = () => ({
  name: 'service-worker',
  apply: 'build',
  closeBundle() {
    const dist = at('../www/dist');
    // Pictures for other sites are none of what a reader sees.
    const files = filesIn(dist).filter((file) => file !== 'service-worker.js' && file !== 'index.html' && !file.startsWith('cards/'));
    const version = createHash('sha256');
    for (const file of ['index.html', ...files]) version.update(file).update(readFileSync(join(dist, file)));
    const list = { version: version.digest('hex').slice(0, 12), files: ['./', ...files.map((file) => `./${file}`)] };
    const place = "{ version: '', files: [] }";
    const text = readFileSync(at('../www/service-worker.js'), 'utf8');
    if (!text.includes(place)) throw new Error(`www/service-worker.js has lost its ${place}`);
    writeFileSync(join(dist, 'service-worker.js'), text.replace(place, JSON.stringify(list)));
  },
});

/** Writes licences.txt: ours, and those of the packages and crates whose code is in the build. */
const licencesOfOthers = () => ({
  name: 'licences-of-others',
  apply: 'build',
  generateBundle(_, output) {
    const parts = [ourselves(), ...partsOf(packagesIn(Object.values(output)), { wasm: true })];
    this.emitFile({ type: 'asset', fileName: 'licences.txt', source: licences(parts) });
  },
});

/** `file.js?bundle`: that script with all it imports and their licences as one text, and its styles as another. */
const bundle = () => ({
  name: 'bundle',
  enforce: 'pre',
  async load(id) {
    const [entry, query] = id.split('?');
    if (query !== 'bundle') return null;
    const { output } = await build({
      configFile: false,
      root: at('../www'),
      logLevel: 'error',
      build: {
        ...TARGETS,
        write: false,
        modulePreload: false,
        rolldownOptions: { input: entry, output: { format: 'es', codeSplitting: false } },
      },
      plugins: tight(),
    });
    const script = output.find((file) => file.type === 'chunk').code;
    const style = output.filter((file) => file.fileName.endsWith('.css')).map((file) => file.source);
    if (output.filter((file) => file.type === 'chunk').length !== 1) throw new Error(`${entry} is in more than one piece`);
    this.addWatchFile(entry);
    const licensed = licenceComment(packagesIn(output), { wasm: false }) + script;
    return `export const script = ${JSON.stringify(licensed)};\nexport const style = ${JSON.stringify(style.join('\n'))};`;
  },
});

/** Files that are loaded together in any case are one; a module belongs to the first that names it. */
const linkage = importedAtOnce(at('../www/element/define.js'));
const workbench = importedAtOnce(at('../www/element/workbench.js'));
const panels = importedAtOnce(at('../www/element/panels.js'));
/** What the applet has from the start; its entry is a file of its own. */
const applet = importedAtOnce(at('../www/app/main.js'));
applet.delete(at('../www/app/main.js'));
// An element that makes pictures has it too, and not the applet.
workbench.add(at('../www/export/save.js'));

export default defineConfig({
  root: at('../www'),
  // Relative addresses: the built page works in any folder of any server.
  base: './',
  cacheDir: at('node_modules/.vite'),
  // As it is written, so that tight.js can change it in dev too.
  optimizeDeps: { exclude: ['uplot'] },
  server: { fs: { allow: [at('../www'), at('node_modules')] } },
  build: {
    ...TARGETS,
    outDir: at('../www/dist'),
    // Browsers that know the page's CSS know this too.
    modulePreload: { polyfill: false, resolveDependencies: onlyStyles },
    emptyOutDir: true,
    rolldownOptions: {
      input: Object.fromEntries(Object.entries({ index: 'index.html', embed: 'embed.html', ...LASTING }).map(([name, file]) => [name, at(`../www/${file}`)])),
      preserveEntrySignatures: 'exports-only',
      output: {
        // Pictures of samples stand at lasting addresses, see tools/pages.js: there once.
        assetFileNames: ({ originalFileNames: [file = ''] }) => (file.startsWith('thumbnails/') ? 'thumbnails/[name][extname]' : 'assets/[name]-[hash][extname]'),
        entryFileNames: ({ name }) => (name in LASTING ? '[name].js' : 'assets/[name]-[hash].js'),
        codeSplitting: { groups: [{ name: 'linkage', test: (id) => linkage.has(id) }, { name: 'workbench', test: (id) => workbench.has(id) }, { name: 'panels', test: (id) => panels.has(id) }, { name: 'applet', test: (id) => applet.has(id) }] },
      },
    },
  },
  worker: { format: 'es' },
  // For the progress of its loading, see www/planner/worker.js.
  define: { WASM_BYTES: JSON.stringify({ first: bytes('pkg-first'), whole: bytes('pkg') }) },
  plugins: [pages(), early(), styleLoads(), bundle(), tight(), lastingScripts(), licencesOfOthers(), serviceWorker()],
});

// How Vite serves and builds the page in www/.
import { createHash } from 'node:crypto';
import { readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { join, relative } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build, defineConfig } from 'vite';
import { pages } from './pages.js';

const at = (path) => fileURLToPath(new URL(path, import.meta.url));

/** Every file below a folder, by its path from there. @param {string} folder */
const filesIn = (folder) =>
  readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => relative(folder, join(entry.parentPath, entry.name)).replaceAll('\\', '/'))
    .sort();

/** Writes www/service-worker.js into the build, with the list of its files. */
const serviceWorker = () => ({
  name: 'service-worker',
  apply: 'build',
  closeBundle() {
    const dist = at('../www/dist');
    const files = filesIn(dist).filter((file) => file !== 'service-worker.js' && file !== 'index.html');
    const version = createHash('sha256');
    for (const file of ['index.html', ...files]) version.update(file).update(readFileSync(join(dist, file)));
    const list = { version: version.digest('hex').slice(0, 12), files: ['./', ...files.map((file) => `./${file}`)] };
    const place = "{ version: '', files: [] }";
    const text = readFileSync(at('../www/service-worker.js'), 'utf8');
    if (!text.includes(place)) throw new Error(`www/service-worker.js has lost its ${place}`);
    writeFileSync(join(dist, 'service-worker.js'), text.replace(place, JSON.stringify(list)));
  },
});

/** `file.js?bundle`: that script with all it imports as one text, and its styles as another. */
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
        target: 'es2022',
        write: false,
        modulePreload: false,
        rolldownOptions: { input: entry, output: { format: 'es', codeSplitting: false } },
      },
    });
    const script = output.find((file) => file.type === 'chunk').code;
    const style = output.filter((file) => file.fileName.endsWith('.css')).map((file) => file.source);
    if (output.filter((file) => file.type === 'chunk').length !== 1) throw new Error(`${entry} is in more than one piece`);
    this.addWatchFile(entry);
    return `export const script = ${JSON.stringify(script)};\nexport const style = ${JSON.stringify(style.join('\n'))};`;
  },
});

export default defineConfig({
  root: at('../www'),
  // Relative addresses: the built page works in any folder of any server.
  base: './',
  cacheDir: at('node_modules/.vite'),
  server: { fs: { allow: [at('../www'), at('node_modules')] } },
  build: {
    target: 'es2022',
    // The first with light-dark(), which otherwise is replaced by something that knows of no scheme but its own sheet's.
    cssTarget: ['chrome123', 'firefox120', 'safari17.5'],
    outDir: at('../www/dist'),
    emptyOutDir: true,
    rolldownOptions: {
      input: { index: at('../www/index.html'), element: at('../www/element/embed.js') },
      preserveEntrySignatures: 'exports-only',
      // What other pages name in a script tag keeps its name.
      output: { entryFileNames: ({ name }) => (name === 'element' ? 'element.js' : 'assets/[name]-[hash].js') },
    },
  },
  worker: { format: 'es' },
  plugins: [pages(), bundle(), serviceWorker()],
});

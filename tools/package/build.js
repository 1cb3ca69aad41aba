// Builds the npm package into dist/: the planner for programs, the element, both in one script, types, schema, samples.
import { execFileSync } from 'node:child_process';
import { copyFileSync, cpSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';
import { build } from 'vite';
import { importedAtOnce } from '../imported-at-once.js';
import { licences, packagesIn, partsOf } from '../licences.js';
import { TARGETS, tight } from '../tight.js';
import { documentTypes } from './document-types.js';
import { attributeTypes, elementsManifest, frameworkTypes } from './element-types.js';
import { inlineModule, inlineScript } from './inline.js';
import { planner } from './planner.js';

const at = (path) => fileURLToPath(new URL(`../../${path}`, import.meta.url));
const dist = (path) => at(`dist/${path}`);
const put = (path, text) => writeFileSync(dist(path), text);

/** Files of the package that bundlers must find as they are written: no build touches them. @param {string[]} names */
const asWritten = (names) => ({
  name: 'as-written',
  enforce: 'pre',
  resolveId: (id) => (names.includes(id.replace('./', '')) ? { id, external: true } : null),
});

/** Files that are loaded together in any case are one; the planner's are apart, for who wants nothing else. */
const together = [['planner', 'planner/api.js'], ['linkage', 'element/define.js'], ['workbench', 'element/workbench.js'], ['panels', 'element/panels.js']].map(([name, file]) => {
  const all = importedAtOnce(at(`www/${file}`));
  return { name, test: (id) => all.has(id) };
});

/**
 * @param {Record<string, string>} entry names and files
 * @param {{wasm: string, worker: string, codeSplitting: unknown}} how with names of files in tools/package/files
 * @returns {Promise<string[]>} the npm packages whose code is in it
 */
async function modules(entry, { wasm, worker, codeSplitting }) {
  const [{ output }] = await build({
    configFile: false,
    root: at('www'),
    logLevel: 'error',
    publicDir: false,
    build: {
      ...TARGETS,
      outDir: at('dist'),
      emptyOutDir: false,
      lib: { entry: Object.fromEntries(Object.entries(entry).map(([name, file]) => [name, at(file)])), formats: ['es'] },
      rolldownOptions: { external: /^(node:|worker_threads$)/, output: { entryFileNames: '[name].js', chunkFileNames: 'part-[name].js', codeSplitting } },
    },
    plugins: [planner({ wasm: `./${wasm}`, worker: `./${worker}` }), asWritten([wasm, worker]), tight()],
  });
  for (const name of [wasm, worker]) copyFileSync(at(`tools/package/files/${name}`), dist(name));
  return packagesIn(output);
}

/** The worker with the module that says where the wasm is, as it is written. @param {string} worker */
function withWasm(worker) {
  const [line, name] = worker.match(/^import ?\{ ?wasm as (\w+) ?\} ?from ?"\.\/wasm\.js";\n?/) ?? [];
  if (!line) throw new Error('dist/worker.js does not begin with its import of wasm.js');
  return `${readFileSync(at('tools/package/files/wasm.js'), 'utf8').replace('export const wasm', `const ${name}`)}${worker.slice(line.length)}`;
}

/** The wasm as a script of Node's. */
const wasmText = () => `// The wasm as text, for servers whose bundler has moved the file.
import { gunzipSync } from 'node:zlib';

const TEXT = '${gzipSync(readFileSync(at('www/pkg/synthetica_bg.wasm')), { level: 9 }).toString('base64')}';

export const wasm = () => gunzipSync(Buffer.from(TEXT, 'base64'));
`;

/** Those of the functions come from the code, those of documents from the schema, those of attributes and events from their list; the element's others are written by hand, and checked against it. */
function types() {
  const made = mkdtempSync(join(tmpdir(), 'types-'));
  writeFileSync(at('tools/package/types/attributes.d.ts'), attributeTypes());
  execFileSync(at('tools/node_modules/.bin/tsc'), ['-p', at('tools/package'), '--outDir', made], { stdio: 'inherit' });
  // In the package all lie in one folder.
  const flat = (file) => readFileSync(join(made, file), 'utf8').replaceAll('../core/types.js', './types.js');
  put('index.d.ts', flat('www/planner/api.d.ts'));
  for (const name of ['errors', 'configure', 'configuration']) put(`${name}.d.ts`, flat(`www/planner/${name}.d.ts`));
  put('frame.d.ts', flat('www/embed/host.d.ts'));
  rmSync(made, { recursive: true });
  for (const name of ['attributes.d.ts', 'element.d.ts', 'inline.d.ts', 'worker.d.ts']) copyFileSync(at(`tools/package/types/${name}`), dist(name));
  put('types.d.ts', `${readFileSync(at('src/bind/wasm.d.ts'), 'utf8')}\n${documentTypes(JSON.parse(readFileSync(at('src/document/schema.json'), 'utf8')))}`);
  for (const [name, text] of Object.entries(frameworkTypes())) put(name, text);
  put('custom-elements.json', `${JSON.stringify(elementsManifest(), null, 2)}\n`);
  put('types.js', '// Only types: see types.d.ts.\nexport {};\n');
}

const crate = (field) => readFileSync(at('Cargo.toml'), 'utf8').match(new RegExp(`^${field} = (.*)$`, 'm'))[1];

const manifest = {
  name: 'synthetica',
  version: JSON.parse(crate('version')),
  description: JSON.parse(crate('description')),
  keywords: JSON.parse(crate('keywords')),
  license: JSON.parse(crate('license')),
  type: 'module',
  // Where the element is defined, and what is a program of its own.
  sideEffects: ['./element.js', './part-linkage.js', './inline.js', './inline-module.js', './worker.js', './worker.node.js'],
  exports: {
    '.': { types: './index.d.ts', node: './index.node.js', default: './index.js' },
    './element': { types: './element.d.ts', default: './element.js' },
    './frame': { types: './frame.d.ts', default: './frame.js' },
    './inline': { types: './inline.d.ts', default: './inline-module.js' },
    './worker': { types: './worker.d.ts', default: './worker.js' },
    // Only types.
    './react': { types: './react.d.ts', default: './types.js' },
    './vue': { types: './vue.d.ts', default: './types.js' },
    './svelte': { types: './svelte.d.ts', default: './types.js' },
    './types': { types: './types.d.ts', default: './types.js' },
    './wasm': './synthetica.wasm',
    './schema': './document.schema.json',
    './samples/*': './samples/*',
    './custom-elements.json': './custom-elements.json',
    './package.json': './package.json',
  },
  files: ['*.js', '*.d.ts', '*.wasm', '*.json', 'samples', 'LICENSE-*'],
  customElements: './custom-elements.json',
  engines: { node: '>=20.19' },
};

rmSync(at('dist'), { recursive: true, force: true });
mkdirSync(dist('samples'), { recursive: true });
const BROWSER = { wasm: 'wasm.js', worker: 'start-worker.js' };
const NODE = { wasm: 'wasm.node.js', worker: 'start-worker.node.js', codeSplitting: false };
const others = await modules({ index: 'www/planner/api.js', element: 'www/element/embed.js', frame: 'www/embed/host.js' }, { ...BROWSER, codeSplitting: { groups: together } });
// Whole, so that a site may have it anywhere.
await modules({ worker: 'www/planner/worker.js' }, { ...BROWSER, codeSplitting: false });
writeFileSync(dist('worker.js'), withWasm(readFileSync(dist('worker.js'), 'utf8')));
await modules({ 'index.node': 'www/planner/api.js' }, NODE);
put('wasm-text.node.js', wasmText());
await modules({ 'worker.node': 'tools/package/worker.node.js' }, NODE);
put('LICENSE-OTHERS', licences(partsOf(others, { wasm: true })));
const { script, names } = await inlineScript('embed/everything.js');
put('inline.js', script);
put('inline-module.js', inlineModule(names));
types();
for (const [from, to] of [
  ['www/pkg/synthetica_bg.wasm', 'synthetica.wasm'],
  ['src/document/schema.json', 'document.schema.json'],
  ['tools/package/README.md', 'README.md'],
  ['LICENSE-APACHE', 'LICENSE-APACHE'],
  ['LICENSE-MIT', 'LICENSE-MIT'],
]) copyFileSync(at(from), dist(to));
cpSync(at('www/mechanisms'), dist('samples'), { recursive: true });
put('package.json', `${JSON.stringify(manifest, null, 2)}\n`);

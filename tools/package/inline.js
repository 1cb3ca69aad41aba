// Inline builds: the element as one classic script that loads nothing, neither by a tag nor by itself.
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';
import { build } from 'vite';
import { inert } from '../../www/export/inert.js';
import { licenceComment, packagesIn } from '../licences.js';
import { TARGETS, tight } from '../tight.js';
import { planner } from './planner.js';

const at = (path) => fileURLToPath(new URL(path, import.meta.url));

/** Modules that are there only as text. @param {Record<string, string>} modules */
const held = (modules) => ({
  name: 'held',
  enforce: 'pre',
  resolveId: (id) => (id in modules ? `\0${id}` : null),
  load: (id) => modules[id.slice(1)] ?? null,
});

/** @param {string} entry a file in www/ @param {Record<string, string>} modules @returns {Promise<{code: string, exports: string[], packages: string[]}>} */
async function oneScript(entry, modules) {
  const { output } = await build({
    configFile: false,
    root: at('../../www'),
    logLevel: 'error',
    build: {
      ...TARGETS,
      write: false,
      modulePreload: false,
      rolldownOptions: {
        input: at(`../../www/${entry}`),
        preserveEntrySignatures: 'exports-only',
        output: { format: 'iife', name: 'synthetica', codeSplitting: false },
      },
    },
    plugins: [planner({ wasm: at('held.js'), worker: at('held.js') }), held(modules), tight()],
  });
  if (output.length !== 1) throw new Error(`${entry} needs other files: ${output.map(({ fileName }) => fileName).join(', ')}`);
  const [{ code, exports }] = output;
  return { code, exports, packages: packagesIn(output) };
}

/** In the same words wherever it is read: a page and a server may say nothing of the encoding. @param {string} code */
const asAscii = (code) => code.replace(/[^\0-\x7f]/g, (letter) => `\\u${letter.charCodeAt(0).toString(16).padStart(4, '0')}`);

const asModule = (value) => `export default ${JSON.stringify(value)};`;

/**
 * The script's text with the licences of what is in it, which may stand in a page's script tag too, and the names that its
 * global has.
 * @param {string} entry a file in www/ @returns {Promise<{script: string, names: string[]}>}
 */
export async function inlineScript(entry) {
  const wasm = gzipSync(readFileSync(at('../../www/pkg/synthetica_bg.wasm')), { level: 9 }).toString('base64');
  const worker = await oneScript('planner/worker.js', { 'held:wasm': 'export default self.packed;', 'held:worker': asModule('') });
  const { code, exports, packages } = await oneScript(entry, { 'held:wasm': asModule(wasm), 'held:worker': asModule(worker.code) });
  const comment = licenceComment([...new Set([...packages, ...worker.packages])].sort(), { wasm: true });
  // In a module its variable would be nobody else's.
  return { script: asAscii(inert(`${comment}${code.trimEnd()}\n${exports.length > 0 ? 'globalThis.synthetica = synthetica;\n' : ''}`)), names: exports };
}

/** The same to import from. The script stays one of its own, since pages name it. @param {string[]} names */
export const inlineModule = (names) => `// What inline.js leaves in the global synthetica, to import from.
import './inline.js';

export const { ${names.join(', ')} } = globalThis.synthetica;
`;

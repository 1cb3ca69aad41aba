// The planner of the package's builds: one wasm package for all questions, its wasm and its worker from where the build
// has them.
import { fileURLToPath } from 'node:url';

const at = (path) => fileURLToPath(new URL(`../../www/${path}`, import.meta.url));

const CONFIGURED = fileURLToPath(new URL('start-configured.js', import.meta.url));

/** Where wasm-bindgen expects the wasm: beside its script, which is true of no bundle. */
const BESIDE = "new URL('synthetica_bg.wasm', import.meta.url)";

/**
 * @param {object} where modules that take the place of the page's own
 * @param {string} where.wasm exports `wasm(given)`: an address, or a promise of the bytes; `given` is what the program said
 * @param {string} where.worker exports `startWorker(address)` and `atMost()`
 */
export const planner = ({ wasm, worker }) => ({
  name: 'planner',
  enforce: 'pre',
  resolveId(id, importer) {
    if (id === './start-worker.js' && importer.startsWith(at('planner/'))) return CONFIGURED;
    if (id === 'started:worker') return this.resolve(worker, importer);
    return id === '../pkg-first/synthetica.js' ? at('pkg/synthetica.js') : null;
  },
  transform(code, id) {
    if (id !== at('pkg/synthetica.js')) return null;
    if (!code.includes(BESIDE)) throw new Error(`www/pkg/synthetica.js has lost its ${BESIDE}`);
    const imports = `import { wasm as place } from ${JSON.stringify(wasm)};\nimport { configuration } from ${JSON.stringify(at('planner/configuration.js'))};\n`;
    return `${imports}${code.replace(BESIDE, 'place(configuration.wasm)')}`;
  },
});

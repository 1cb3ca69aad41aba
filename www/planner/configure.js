/**
 * Says where the planner's files are, for programs whose bundler or server has them elsewhere than it expects.
 *
 * @typedef {import('./configuration.js').Wasm} Wasm
 */
import { object, wrong } from './arguments.js';
import { configuration } from './configuration.js';

const WASM = 'an address (a string or a URL), bytes (an ArrayBuffer or a view of one), a Response or a WebAssembly.Module';
const WORKER = 'an address (a string or a URL)';

/**
 * Where the files of the package are, if not where its own code finds them: `synthetica.wasm`, and `worker.js` (in Node
 * `worker.node.js`). Called before the first question to the planner, and before an element is there. Addresses are
 * relative to the page, in Node paths relative to the working folder.
 * @param {object} where
 * @param {string | URL | BufferSource | Response | WebAssembly.Module} [where.wasm]
 * @param {string | URL} [where.worker]
 */
export function configure(where) {
  const given = object('The argument of configure', where, 'an object with wasm, worker');
  for (const name of Object.keys(given)) if (name !== 'wasm' && name !== 'worker') throw new TypeError(`configure: ${name} is unknown. Accepted: wasm, worker.`);
  if (configuration.begun) throw new Error('configure was called after the first question to the planner, which has looked for its files already. Accepted: a call before the first question and before the first element.');
  const { wasm, worker } = given;
  const next = { wasm: wasm === undefined ? undefined : wasmOf(wasm), worker: worker === undefined ? undefined : addressOf(worker) };
  if (worker !== undefined && next.worker === undefined) throw wrong('configure: worker', worker, WORKER);
  if (next.wasm !== undefined) configuration.wasm = next.wasm;
  if (next.worker !== undefined) configuration.worker = next.worker;
}

/** @param {unknown} wasm @returns {Wasm | Promise<Wasm>} */
function wasmOf(wasm) {
  if (wasm instanceof ArrayBuffer || ArrayBuffer.isView(wasm) || wasm instanceof WebAssembly.Module) return wasm;
  if (typeof Response === 'function' && wasm instanceof Response) {
    const bytes = bytesOf(wasm);
    // Each question tells it; without one nobody needs to.
    bytes.catch(() => {});
    return bytes;
  }
  const address = addressOf(wasm);
  if (address === undefined) throw wrong('configure: wasm', wasm, WASM);
  return address;
}

/** Read once, for as many workers as there will be. @param {Response} response */
async function bytesOf(response) {
  if (!response.ok) throw new Error(`the wasm could not be loaded: ${response.status} ${response.statusText}`);
  return response.arrayBuffer();
}

/** Whole where there is a page or worker: the planner's worker lies elsewhere. @param {unknown} address @returns {string | undefined} */
function addressOf(address) {
  if (address instanceof URL) return address.href;
  if (typeof address !== 'string' || address === '') return undefined;
  const base = globalThis.document?.baseURI ?? globalThis.location?.href;
  if (!base) return address;
  if (!URL.canParse(address, base)) throw new TypeError(`configure: “${address}” is no address. Accepted: ${WORKER}.`);
  return new URL(address, base).href;
}

// The built page begins to load what it needs with its first bytes, and the planner's worker is the one that was started then.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { loadsEarly } from '../../tools/early.js';
import { startWorker } from '../../www/planner/start-worker.js';

const page = (/** @type {string} */ more = '') => `<head>
    <script src="./first.js"></script>
    <script type="module" crossorigin src="./assets/index-1.js"></script>
    <link rel="modulepreload" crossorigin href="./assets/workbench-1.js">
    <link rel="stylesheet" crossorigin href="./assets/index-1.css">${more}
  </head>`;
const bundle = { 'assets/worker-1.js': {}, 'assets/3rps-1.js': { facadeModuleId: '/x/www/mechanisms/3rps.json?raw' }, 'assets/index-1.js': {} };

test('scripts and the sample are asked for before the first script runs, and the others wait for it', () => {
  const order = [...loadsEarly(page(), bundle).matchAll(/(?:src|href)="\.\/([^"]+)"(?: data-worker="([^"]+)")?/g)].map(([, file, worker]) => [file, worker].filter(Boolean).join(' with '));
  assert.deepEqual(order, ['assets/index-1.js', 'assets/workbench-1.js', 'assets/index-1.css', 'assets/3rps-1.js', 'first.js with ./assets/worker-1.js', 'assets/index-1.js']);
});

test('a page that is built in another way fails the build', () => {
  assert.throws(() => loadsEarly(page().replace('first.js', 'other.js'), bundle), /built in another way/);
  assert.throws(() => loadsEarly(page(), { ...bundle, 'assets/worker-2.js': {} }), /2 workers, 1 samples/);
});

test('the worker that runs already is taken once, and all that it has said is heard', async () => {
  const worker = new EventTarget();
  const said = [new MessageEvent('message', { data: { kind: 'holds' } }), new MessageEvent('message', { data: { id: 0, kind: 'value' } })];
  Object.assign(globalThis, { syntheticaWorker: { worker, said }, Worker: class {} });
  const taken = startWorker();
  assert.equal(taken, worker);
  /** @type {unknown[]} */
  const heard = [];
  taken.addEventListener('message', ({ data }) => heard.push(data.kind));
  await Promise.resolve();
  assert.deepEqual(heard, ['holds', 'value']);
  assert.notEqual(startWorker(), worker);
});

// In Node plans are made in threads: side by side, bit by bit as in a program's own, ended at once, and none holds a program up.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { getEventListeners } from 'node:events';
import { cpSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { availableParallelism, tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { COLUMNS, digests } from '../e2e/digest.mjs';
import { dist } from './site.mjs';

let threads = 0;
process.on('worker', () => (threads += 1));
const index = new URL('index.node.js', dist).href;
const { open, plan } = await import(index);

const sample = JSON.parse(readFileSync(new URL('samples/3rps.json', dist), 'utf8'));
/** By the paper's method, which takes long. */
const long = { ...sample, motion: { ...sample.motion, frames: 5000 }, planner: { method: 'gradient' } };

/** Without the threads' files, as where a bundler has lost them. */
const alone = mkdtempSync(join(tmpdir(), 'alone-'));
after(() => rmSync(alone, { recursive: true }));
cpSync(fileURLToPath(dist), alone, { recursive: true, filter: (file) => !file.endsWith('/worker.node.js') });

/** Runs a program; gives what it printed. It must end by itself. @param {string} code */
const run = (code) => execFileSync('node', ['--input-type=module', '-e', code], { encoding: 'utf8', timeout: 60_000 }).trim();
const given = `const { plan } = await import(${JSON.stringify(index)}); const sample = ${JSON.stringify(sample)}; const long = ${JSON.stringify(long)};`;

test('many plans are made in at most as many threads as can run at once, the program’s own free meanwhile', async () => {
  const names = Array.from({ length: 6 * availableParallelism() }, (_, index) => `${index}`);
  const motions = await Promise.all(names.map((name) => plan({ ...sample, name })));
  assert.ok(motions.every(({ frames }) => frames === 129));
  assert.equal(threads, availableParallelism());
});

test('every column is the same to the last bit, with threads and without', async () => {
  const { plan: planHere } = await import(pathToFileURL(join(alone, 'index.node.js')).href);
  for (const name of ['3rps', '2tpr', 'delta']) {
    const text = readFileSync(new URL(`samples/${name}.json`, dist), 'utf8');
    const [there, here] = await Promise.all([digests(await plan(text)), digests(await planHere(text))]);
    for (const column of COLUMNS) assert.ok(Number.parseInt(there[column]) > 0, column);
    assert.deepEqual(there, here, name);
  }
});

test('a plan that is taken back rejects, and its thread plans another; as many long ones as there are threads hold up no other question', async () => {
  const started = threads;
  const ends = Array.from({ length: availableParallelism() }, () => new AbortController());
  const ended = ends.map(({ signal }, index) => {
    const begun = withResolvers();
    const rejects = assert.rejects(plan({ ...long, name: `${index}` }, { signal, onProgress: begun.resolve }), { name: 'AbortError' });
    return { begun: begun.promise, rejects };
  });
  await Promise.all(ended.map(({ begun }) => begun));
  const session = await open(sample);
  assert.equal((await session.plan()).frames, 129);
  session.close();
  // Another function's plan waits for one of theirs to end.
  const waiting = new AbortController();
  const parked = assert.rejects(plan({ ...long, name: 'parked' }, { signal: waiting.signal }), { name: 'AbortError' });
  const next = plan({ ...sample, name: 'next' });
  waiting.abort();
  await parked;
  ends[0].abort();
  assert.equal((await next).frames, 129);
  for (const end of ends) end.abort();
  await Promise.all(ended.map(({ rejects }) => rejects));
  assert.equal(threads, Math.max(started, availableParallelism()), 'none was ended');
});

test('one signal of a thousand plans keeps none of them, and Node does not warn of it', async () => {
  const warnings = [];
  const hear = (warning) => warnings.push(warning);
  process.on('warning', hear);
  after(() => process.off('warning', hear));
  const { signal } = new AbortController();
  const short = { ...sample, motion: { ...sample.motion, frames: 2 } };
  const options = { signal, stop: signal };
  const plans = Promise.all(Array.from({ length: 1000 }, (_, index) => plan({ ...short, name: `${index % 50}` }, options)));
  assert.equal(getEventListeners(signal, 'abort').length, 1);
  await plans;
  assert.deepEqual(getEventListeners(signal, 'abort'), []);
  assert.deepEqual(warnings.filter(({ name }) => name === 'MaxListenersExceededWarning'), []);
});

test('a program ends by itself: after its plan, with one taken back, with one that nobody waits for any more', () => {
  assert.equal(run(`${given} console.log((await plan(sample)).frames);`), '129');
  assert.equal(
    run(`${given} const end = new AbortController(); let begun;
      const first = new Promise((resolve) => (begun = resolve));
      const ended = plan(long, { signal: end.signal, onProgress: begun }).catch(({ name }) => console.log(name));
      await first; end.abort(); await ended;`),
    'AbortError',
  );
});

test('a thread that a program cannot have is done without', () => {
  assert.equal(run(`${given.replace(index, pathToFileURL(join(alone, 'index.node.js')).href)} console.log((await plan(sample)).frames);`), '129');
});

function withResolvers() {
  const all = {};
  all.promise = new Promise((resolve, reject) => Object.assign(all, { resolve, reject }));
  return all;
}

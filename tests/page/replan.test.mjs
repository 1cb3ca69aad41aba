// The result follows the document; a plan that takes long says how far it is.
import assert from 'node:assert/strict';
import { afterEach, beforeEach, mock, test } from 'node:test';
import { createReplanning } from '../../www/core/replan.js';
import { createStore } from '../../www/core/store.js';
import { DocumentFault, PlannerNotLoaded, Superseded } from '../../www/planner/errors.js';

const named = (name) => ({ version: 1, name, chains: [], motion: { key_frames: [] } });
const settled = () => new Promise((done) => setImmediate(done));

let now = 0;
beforeEach(() => mock.method(performance, 'now', () => now));
afterEach(() => mock.restoreAll());

function made() {
  const plans = [];
  const plan = (text, options) => new Promise((resolve, reject) => plans.push({ text, ...options, resolve, reject }));
  const store = createStore(named('a'));
  const { replan } = createReplanning({ store, planner: { plan } });
  return { store, plans, replan };
}

test('only what takes longer than half a second says so, until it ends', async () => {
  const { store, plans, replan } = made();
  replan();
  now += 400;
  plans[0].onProgress({ done: 3, frames: 9 });
  assert.equal(store.planning, null);
  now += 200;
  plans[0].onProgress({ done: 4, frames: 9 });
  assert.deepEqual([store.planning.done, store.planning.frames], [4, 9]);
  store.planning.stop();
  assert.equal(plans[0].stop.aborted, true);
  plans[0].resolve('a part');
  await settled();
  assert.deepEqual([store.planning, store.result.motion], [null, 'a part']);
});

test('of an older plan nothing is said', async () => {
  const { store, plans } = made();
  store.edit(() => named('b'));
  now += 1000;
  store.edit(() => named('c'));
  plans[0].onProgress({ done: 3, frames: 9 });
  assert.equal(store.planning, null);
  now += 1000;
  plans[1].onProgress({ done: 1, frames: 9 });
  plans[0].reject(new Superseded());
  await settled();
  assert.equal(store.planning.done, 1);
});

test('a fault of an earlier text goes as soon as the mended one is being planned', async () => {
  const { store, plans, replan } = made();
  replan();
  store.setResult({ fault: { code: 'out-of-range', message: 'a fault', where: '', accepted: '' } });
  plans[0].onProgress({ done: 1, frames: 9 });
  assert.equal(store.result.fault, null);
  // An older plan says nothing of the present text.
  store.edit(() => named('b'));
  store.setResult({ fault: { code: 'out-of-range', message: 'a fault', where: '', accepted: '' } });
  plans[0].onProgress({ done: 2, frames: 9 });
  assert.notEqual(store.result.fault, null);
});

test('a plan for which the planner could not be loaded is asked for again when that trouble is over, unless a newer one was', async () => {
  const { store, plans, replan } = made();
  replan();
  plans[0].reject(new PlannerNotLoaded('503'));
  await settled();
  assert.deepEqual([store.result.trouble, store.result.again], ['The planner could not be loaded (503).', true]);
  store.setResult({ trouble: '' });
  await settled();
  assert.deepEqual([plans.length, store.result.again], [2, false]);
  plans[1].reject(new PlannerNotLoaded('503'));
  await settled();
  store.edit(() => named('b'));
  plans[2].resolve('a motion');
  await settled();
  assert.deepEqual([plans.length, store.result.motion, store.result.trouble, store.result.again], [3, 'a motion', '', false]);
});

test('a fault is told of the present document only', async () => {
  const { store, plans, replan } = made();
  const fault = { code: 'out-of-range', message: 'a fault', where: '', accepted: '' };
  replan();
  store.edit(() => named('b'));
  plans[0].reject(new DocumentFault(fault));
  await settled();
  assert.equal(store.result.fault, null);
  plans[1].reject(new DocumentFault(fault));
  await settled();
  assert.equal(store.result.fault, fault);
});

test('a start that was found for an older document is not written into a newer one: it is looked for again', async () => {
  const asked = [];
  const findStart = (text) => new Promise((resolve) => asked.push({ name: JSON.parse(text).name, resolve }));
  const store = createStore({ ...named('a'), chains: [{ joints: [], start: [1] }] });
  const { findStart: find } = createReplanning({ store, planner: { findStart, plan: () => new Promise(() => {}) }, say() {} });
  find();
  store.edit((doc) => ({ ...doc, name: 'b' }));
  const found = (start) => JSON.stringify({ chains: [{ start }] });
  asked[0].resolve(found([2]));
  await settled();
  assert.deepEqual(asked.map(({ name }) => name), ['a', 'b']);
  assert.deepEqual(store.doc.chains[0].start, [1]);
  asked[1].resolve(found([3]));
  await settled();
  assert.deepEqual([store.doc.name, store.doc.chains[0].start], ['b', [3]]);
});

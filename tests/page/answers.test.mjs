// What the worker does, in Node: documents that stay open, plans in portions, other questions in between.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { Queue } from '../../www/planner/queue.js';
import { Planner } from '../../www/planner/planner.js';
import { createAnswers } from '../../www/planner/calls.js';

const at = (path) => new URL(`../../www/${path}`, import.meta.url);
/** How many documents were freed. */
let freed = 0;
for (const folder of ['pkg', 'pkg-first']) {
  const { initSync, Session } = await import(at(`${folder}/synthetica.js`));
  initSync({ module: readFileSync(at(`${folder}/synthetica_bg.wasm`)) });
  const { free } = Session.prototype;
  Session.prototype.free = function () {
    freed += 1;
    free.call(this);
  };
}
const sample = JSON.parse(readFileSync(at('mechanisms/3rps.json'), 'utf8'));
const short = JSON.stringify(sample);
/** By the paper's method, which takes long. */
const long = JSON.stringify({ ...sample, motion: { ...sample.motion, frames: 2000 }, planner: { method: 'gradient' } });

/** What is said of a question before its answer. */
const UNDERWAY = ['received', 'begun', 'progress'];

/** Answers with all that they say, and a promise of the last answer to a question. */
function made() {
  const said = [];
  const waiting = new Map();
  const { receive } = createAnswers((answer) => {
    said.push(answer);
    if (!UNDERWAY.includes(answer.kind)) waiting.get(answer.id)?.(answer);
  });
  let ids = 0;
  /** @returns {Promise<any> & {id: number}} */
  const ask = (call, args = [], about = {}) => {
    const id = ++ids;
    const last = new Promise((resolve) => waiting.set(id, resolve));
    receive({ kind: 'ask', id, call, args, ...about });
    return Object.assign(last, { id });
  };
  const progress = async (id) => {
    const own = (wanted) => said.some((answer) => answer.id === id && wanted(answer.kind));
    while (!own((kind) => kind === 'progress')) {
      assert.ok(!own((kind) => !UNDERWAY.includes(kind)), `it ended without progress: ${JSON.stringify(said.at(-1))}`);
      await new Promise((turn) => setImmediate(turn));
    }
  };
  return { said, receive, ask, progress };
}

test('a document is opened with its text and then asked by its number', async () => {
  const { ask, receive } = made();
  const { value: motion } = await ask('plan', [], { doc: 1, text: short });
  assert.deepEqual([motion.frames, motion.partial], [129, false]);
  const joints = motion.joints.slice(0, 15);
  const goal = motion.goal.slice(0, 7);
  // The smaller package has no words for what it refuses: the whole one, which is not loaded yet, says them.
  const open = await ask('explain', [joints.map((value) => value + 0.1), goal], { doc: 1 });
  assert.match(open.fault?.message ?? open.message, /the loops are open by/);
  assert.ok((await ask('pull', [joints, goal], { doc: 1 })).value.closure <= 1e-10);
  assert.equal((await ask('explain', [joints, goal], { doc: 1 })).value.freedoms.length, 3);
  assert.equal(JSON.parse((await ask('text', [], { doc: 1 })).value).planner.method, 'newton');
  // Of the whole package.
  assert.equal((await ask('trace', [-1, joints], { doc: 1 })).fault.where, 'motion.frames');
  assert.match((await ask('export_motion', ['csv', ''], { doc: 1 })).value, /^frame,/);
  assert.equal((await ask('chain_by_index', [1.5, 0])).value, undefined);
  assert.equal((await ask('plan', [], { doc: 2, text: '{' })).fault.line, 1);
  receive({ kind: 'close', doc: 1 });
  assert.equal((await ask('text', [], { doc: 1 })).kind, 'failure');
});

test('both metrics are compared: the document’s own as it is planned, and the other one', async () => {
  const { ask } = made();
  const { value: motion } = await ask('plan', [], { doc: 1, text: short });
  const { value: gaps } = await ask('compare_metrics', [], { doc: 1 });
  assert.deepEqual(gaps.map(({ metric }) => metric), ['pose', 'dual-quaternion']);
  const [other, own] = gaps;
  assert.deepEqual([own.length, own.translation_gap, own.rotation_gap], [motion.report.metric.length, Math.max(...motion.translation_gap), Math.max(...motion.rotation_gap)]);
  assert.notEqual(other.translation_gap, own.translation_gap);
  // Once more is the same.
  assert.deepEqual((await ask('compare_metrics', [], { doc: 1 })).value, gaps);
});

test('a comparison goes in portions: other questions are answered in between, and it can be taken back', async () => {
  const { said, ask, receive } = made();
  const comparison = ask('compare_metrics', [], { doc: 1, text: long });
  const other = await ask('text', [], { doc: 2, text: short });
  assert.equal(other.kind, 'value');
  assert.ok(said.every(({ id, kind }) => id !== comparison.id || UNDERWAY.includes(kind)), 'it is not done yet');
  receive({ kind: 'cancel', id: comparison.id });
  assert.equal((await comparison).kind, 'cancelled');
});

test('a search tells what it has so far, other questions are answered in between, and asked again it goes on', async () => {
  const { said, ask, receive, progress } = made();
  // So many frames that the search takes longer than the pause before it tells what it has.
  const some = JSON.stringify({ ...sample, motion: { ...sample.motion, frames: 1025 } });
  const stopped = ask('best', [], { doc: 1, text: some });
  await progress(stopped.id);
  const { value: motion } = await ask('best_motion', [], { doc: 1 });
  assert.equal(motion.frames, 1025);
  receive({ kind: 'stop', id: stopped.id });
  const { value: part } = await stopped;
  assert.ok(part.progress < 1 && part.starts >= 0, `${part.progress}`);
  const { value: best } = await ask('best', [], { doc: 1 });
  assert.equal(best.progress, 1);
  assert.ok(best.starts >= part.starts && best.best.mean <= best.followed.mean && best.lower_bound <= best.best.mean + 1e-12);
  assert.equal(best.lane.length, 1025);
  const tellings = said.filter(({ id, kind }) => id === stopped.id && kind === 'progress').map((answer) => answer.progress.progress);
  assert.deepEqual(tellings, [...tellings].sort((a, b) => a - b));
  if (best.curve.length) assert.equal((await ask('calm_motion', [best.curve[0].price], { doc: 1 })).value.motion.frames, 1025);
});

test('ways to assemble are searched at one key frame after the other, each from its beginning', async () => {
  const { ask } = made();
  const some = JSON.stringify({ ...sample, motion: { ...sample.motion, frames: 17 } });
  const { value: first } = await ask('modes', [0], { doc: 1, text: some });
  assert.deepEqual([first.key, first.progress], [0, 1]);
  assert.equal(first.found.filter(({ is_start }) => is_start).length, 1);
  const { value: text } = await ask('text_with_mode', [first.found[0].index], { doc: 1 });
  assert.equal(JSON.parse(text).chains[0].start.length, 5);
  const { value: other } = await ask('modes', [1], { doc: 1 });
  assert.deepEqual([other.key, other.progress], [1, 1]);
  assert.equal((await ask('modes', [9], { doc: 1 })).kind, 'fault');
});

test('other questions are answered between the portions of a plan, and another plan is made beside it', async () => {
  const { said, ask, receive, progress } = made();
  const slow = ask('plan', [], { doc: 1, text: long });
  await progress(slow.id);
  const { value: motion } = await ask('plan', [], { doc: 2, text: short });
  await ask('pull', [motion.joints.slice(0, 15), motion.goal.slice(0, 7)], { doc: 1 });
  assert.ok(said.every(({ id, kind }) => id !== slow.id || UNDERWAY.includes(kind)), 'it still goes on');
  receive({ kind: 'cancel', id: slow.id });
});

test('a plan that is stopped has the frames so far, as the whole has them; asked again it goes on from there', async () => {
  const { said, ask, receive, progress } = made();
  const some = { ...sample, motion: { ...sample.motion, frames: 40 }, planner: { method: 'gradient' } };
  const about = { doc: 1, text: JSON.stringify(some) };
  const stopped = ask('plan', [], about);
  await progress(stopped.id);
  receive({ kind: 'stop', id: stopped.id });
  const { value: part } = await stopped;
  assert.equal(part.partial, true);
  assert.ok(part.frames > 0 && part.frames < 40 && part.goal_frames === 40, `${part.frames}`);
  const reported = said.filter(({ kind }) => kind === 'progress').map(({ progress }) => progress);
  assert.ok(reported.every(({ done, frames }) => done <= part.frames && frames === 40));
  for (const name of ['time', 'metric', 'status', 'sigma_min']) assert.equal(part[name].length, part.frames, name);

  const on = ask('plan', [], { doc: 1 });
  const { value: whole } = await on;
  assert.ok(said.filter(({ id }) => id === on.id).every(({ kind, progress }) => kind !== 'progress' || progress.done >= part.frames));
  const { value: afresh } = await made().ask('plan', [], about);
  for (const name of ['joints', 'pose', 'metric', 'closure', 'sigma_min', 'iterations', 'status']) {
    assert.deepEqual(whole[name], afresh[name], name);
    assert.deepEqual(part[name], afresh[name].slice(0, part[name].length), name);
  }
});

test('a plan that is taken back ends; its document is freed after it, and no sooner', async () => {
  const { said, ask, receive, progress } = made();
  const slow = ask('plan', [], { doc: 1, text: long });
  await progress(slow.id);
  const before = freed;
  receive({ kind: 'close', doc: 1 });
  await new Promise((turn) => setTimeout(turn, 50));
  assert.equal(freed, before, 'it is still asked');
  receive({ kind: 'cancel', id: slow.id });
  assert.equal((await slow).kind, 'cancelled');
  const count = said.length;
  await new Promise((turn) => setTimeout(turn, 100));
  assert.equal(said.length, count, 'nothing more is said of it');
  assert.equal(freed, before + 1);
});

test('without a worker the page plans in portions too: a plan is stopped, another asker served meanwhile', async () => {
  globalThis.Worker = class {
    constructor() {
      throw new Error('forbidden');
    }
  };
  const queue = new Queue();
  const [one, two] = [new Planner(queue), new Planner(queue)];
  const stop = new AbortController();
  const seen = [];
  const slow = one.plan(long, { stop: stop.signal, onProgress: (progress) => seen.push(progress) });
  const quick = await two.plan(short);
  assert.equal(quick.frames, 129);
  await two.explain(short, quick.joints.slice(0, 15), quick.goal.slice(0, 7));
  stop.abort();
  const part = await slow;
  assert.ok(part.partial && part.frames < 2000 && seen.length > 0);
});

test('what the smaller package refuses is read by the whole one: expressions, and their faults', async () => {
  const { ask } = made();
  const first = sample.motion.key_frames[0];
  const typed = (/** @type {any} */ z) =>
    JSON.stringify({ ...sample, parameters: { lift: 0.1 }, motion: { ...sample.motion, key_frames: [first, { ...first, z }] } });
  const planned = await ask('plan', [], { doc: 11, text: typed(`${first.z}+lift/2`) });
  assert.equal(planned.kind, 'value');
  assert.ok(Math.abs(planned.value.plain.motion.key_frames[1].z - first.z - 0.05) < 1e-12);
  assert.deepEqual(planned.value.parameters, [{ name: 'lift', value: 0.1, input: true }]);
  const text = JSON.parse((await ask('text', [], { doc: 11 })).value);
  assert.equal(text.motion.key_frames[1].z, `${first.z}+lift/2`);
  const refused = await ask('plan', [], { doc: 12, text: typed('lfit') });
  assert.equal(refused.kind, 'fault');
  assert.equal(refused.fault.where, 'motion.key_frames[1].z');
  assert.match(refused.fault.what, /no parameter “lfit”/);
  assert.match(refused.fault.accepted, /lift/);
  const plain = await ask('plan', [], { doc: 13, text: short });
  assert.equal(plain.value.plain, undefined);
});

// The why belongs to what is shown now; an answer that comes too late is dropped.
import assert from 'node:assert/strict';
import { afterEach, beforeEach, mock, test } from 'node:test';
import { createExplainer } from '../../www/core/explain.js';
import { createStore } from '../../www/core/store.js';

beforeEach(() => mock.timers.enable({ apis: ['setTimeout'] }));
afterEach(() => mock.timers.reset());

const settled = () => new Promise((done) => setImmediate(done));

function made() {
  const questions = [];
  const explain = (text, joints, goal) =>
    new Promise((resolve, reject) => questions.push({ text, joints: [...joints], goal: [...goal], resolve, reject }));
  const doc = { version: 1, name: 'a', chains: [], motion: { key_frames: [] } };
  const store = createStore(doc);
  createExplainer({ store, planner: { explain } });
  const motion = { frames: 2, joints: new Float64Array([1, 2, 3, 4]), goal: new Float64Array(14).map((_, i) => i) };
  store.setResult({ motion, doc });
  mock.timers.tick(1000);
  return { store, questions, doc };
}

test('asks for the shown frame, and again when another is shown', async () => {
  const { store, questions } = made();
  assert.deepEqual(questions[0].joints, [1, 2]);
  assert.equal(JSON.parse(questions[0].text).name, 'a');
  questions[0].resolve({ answer: 'first' });
  await settled();
  const { joints, goal } = store.result.motion;
  assert.deepEqual(store.why, { answer: 'first', of: { doc: store.doc, joints, goal, index: 0 } }, 'with what it is the answer of');
  store.setView({ hovered: 'workpiece' });
  mock.timers.tick(1000);
  assert.equal(questions.length, 1, 'the same frame is not asked for twice');
  store.setView({ frame: 1 });
  mock.timers.tick(1000);
  assert.deepEqual(questions[1].joints, [3, 4]);
  assert.deepEqual(questions[1].goal, [7, 8, 9, 10, 11, 12, 13]);
});

test('drops an answer that is no longer about what is shown', async () => {
  const { store, questions } = made();
  store.setView({ frame: 1 });
  mock.timers.tick(1000);
  questions[1].resolve({ answer: 'second' });
  await settled();
  questions[0].resolve({ answer: 'first' });
  await settled();
  assert.equal(store.why.answer, 'second');
});

test('while the motion plays it asks now and then, not at every frame', () => {
  const { store, questions } = made();
  for (let i = 0; i < 20; i++) store.setView({ frame: i % 2 });
  assert.ok(questions.length <= 2);
});

test('while a hand moves something it asks nothing, and asks for what is shown then', () => {
  const { store, questions } = made();
  store.setView({ moving: 'workpiece' });
  store.setView({ frame: 1 });
  mock.timers.tick(5000);
  assert.equal(questions.length, 1);
  store.setView({ moving: '' });
  mock.timers.tick(1000);
  assert.deepEqual(questions[1].joints, [3, 4]);
});

test('a posture in place of the frame', () => {
  const { store, questions } = made();
  store.setView({ posture: { joints: new Float64Array([9, 9]), goal: new Float64Array(7), pose: new Float64Array(7), rows: new Float64Array(0) } });
  mock.timers.tick(1000);
  assert.deepEqual(questions[1].joints, [9, 9]);
});

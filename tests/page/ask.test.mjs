// How a question to the planner ends, as one plain value.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { ask, untilAnswered } from '../../www/core/ask.js';
import { createStore } from '../../www/core/store.js';
import { DocumentFault, PlannerFailure, PlannerNotLoaded, Superseded } from '../../www/planner/errors.js';

const failing = (error) => ask(() => Promise.reject(error), 'plan the motion');
const settled = () => new Promise((done) => setImmediate(done));

test('a question has an answer, a fault of the document, trouble, or is late', async () => {
  assert.deepEqual(await ask(async () => 3, 'count'), { is: 'answer', value: 3 });
  const fault = { code: 'out-of-range', message: 'a is 7', where: 'a', accepted: '1' };
  assert.deepEqual(await failing(new DocumentFault(fault)), { is: 'fault', fault, message: 'A is 7.' });
  assert.deepEqual(await failing(new PlannerFailure('unreachable')), {
    is: 'trouble',
    notLoaded: false,
    message: 'The planner failed to plan the motion and was started afresh (unreachable).',
  });
  assert.deepEqual(await failing(new PlannerNotLoaded('503')), { is: 'trouble', notLoaded: true, message: 'The planner could not be loaded (503).' });
  const taken = new AbortController();
  taken.abort();
  for (const late of [new Superseded(), taken.signal.reason]) assert.equal((await failing(late)).is, 'late');
});

test('a mistake of ours is neither', async () => {
  await assert.rejects(failing(new TypeError('x is undefined')), TypeError);
  await assert.rejects(
    ask(() => {
      throw new RangeError('at once');
    }, 'fail'),
    RangeError,
  );
});

test('all who wait for an answer ask again when the trouble is over', async () => {
  const store = createStore({ version: 1, chains: [], motion: { key_frames: [] } });
  let down = true;
  let questions = 0;
  const question = async () => {
    questions++;
    return down ? ask(() => Promise.reject(new PlannerNotLoaded('503')), 'answer') : { is: 'answer', value: questions };
  };
  const answers = Promise.all([untilAnswered(store, question), untilAnswered(store, question)]);
  await settled();
  assert.deepEqual([questions, store.result.trouble, store.result.again], [2, 'The planner could not be loaded (503).', true]);
  // Other results change nothing.
  store.setResult({ fault: null });
  await settled();
  assert.equal(questions, 2);
  store.setResult({ trouble: '' });
  await settled();
  assert.deepEqual([questions, store.result.again], [4, true]);
  down = false;
  store.setResult({ trouble: '' });
  assert.deepEqual((await answers).map(({ value }) => value), [5, 6]);
  assert.equal(store.result.trouble, '');
});

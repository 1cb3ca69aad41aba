// A worker that was ended from outside: noticed by its lock where there are locks, else by its silence, and made anew.
import assert from 'node:assert/strict';
import { afterEach, beforeEach, mock, test } from 'node:test';
import { Queue } from '../../www/planner/queue.js';
import { Planner, PlannerFailure } from '../../www/planner/planner.js';

/** @type {{requests: any[], ended: boolean, says: (message: object) => void}[]} */
let workers;
/** Who waits for a lock, by its name. @type {Map<string, () => void>} */
let waiting;
let now = 0;

beforeEach(() => {
  workers = [];
  waiting = new Map();
  mock.timers.enable({ apis: ['setTimeout'] });
  mock.method(performance, 'now', () => now);
  globalThis.Worker = class {
    requests = [];
    ended = false;
    constructor() {
      workers.push(this);
    }
    says(message) {
      this.onmessage({ data: message });
    }
    postMessage(message) {
      if (message.kind === 'ask') this.requests.push(message);
    }
    terminate() {
      this.ended = true;
    }
  };
  const locks = {
    request: (name, { signal }, granted) =>
      new Promise((_, reject) => {
        waiting.set(name, granted);
        signal.addEventListener('abort', () => {
          waiting.delete(name);
          reject(signal.reason);
        });
      }),
  };
  Object.defineProperty(globalThis, 'navigator', { value: { locks }, configurable: true, writable: true });
});
afterEach(() => {
  mock.timers.reset();
  mock.restoreAll();
});

/** Time goes by, for the clock too. */
function pass(milliseconds) {
  now += milliseconds;
  mock.timers.tick(milliseconds);
}

/** Says something of a question, the last one unless told. */
const says = (worker, kind, more = {}, { id } = worker.requests.at(-1)) => worker.says({ id, kind, ...more });
const calls = (worker) => worker.requests.map(({ call, text }) => [call, text]);

/** A planner whose worker has answered a question. */
async function made(queue = new Queue()) {
  const planner = new Planner(queue);
  const first = planner.normalise('a');
  for (const kind of ['received', 'begun']) says(workers[0], kind);
  says(workers[0], 'value', { value: 'a' });
  await first;
  return planner;
}

test('by its lock it is noticed at once, and all that it had is asked again', async () => {
  const planner = await made();
  workers[0].says({ kind: 'holds', lock: 'one' });
  const [plan, explained] = [planner.plan('a'), planner.explain('a', new Float64Array(1), new Float64Array(7))];
  says(workers[0], 'begun', {}, workers[0].requests[1]);
  waiting.get('one')();
  assert.deepEqual([workers.length, workers[0].ended, waiting.size], [2, true, 0]);
  assert.deepEqual(calls(workers[1]), [['plan', 'a'], ['explain', undefined]], 'its documents went with it');
  says(workers[1], 'value', { value: 1 }, workers[1].requests[0]);
  says(workers[1], 'value', { value: 2 });
  assert.deepEqual([await plan, await explained], [1, 2]);
});

test('while nothing is asked it is noticed too; the next question begins a new one', async () => {
  const planner = await made();
  workers[0].says({ kind: 'holds', lock: 'one' });
  waiting.get('one')();
  assert.equal(workers.length, 1);
  const plan = planner.plan('a');
  assert.deepEqual(calls(workers[1]), [['plan', 'a']]);
  says(workers[1], 'value', { value: 1 });
  assert.equal(await plan, 1);
});

test('what ended two workers is not asked a third time', async () => {
  const planner = await made();
  const lost = assert.rejects(planner.plan('a'), (error) => error instanceof PlannerFailure && /worker was ended/.test(error.message));
  for (const name of ['one', 'two']) {
    workers.at(-1).says({ kind: 'holds', lock: name });
    waiting.get(name)();
  }
  await lost;
  assert.equal(workers.length, 2);
});

test('without locks a question that is not heard within 1.5 s tells it', async () => {
  const planner = await made();
  const plan = planner.plan('a');
  pass(1400);
  assert.equal(workers.length, 1);
  pass(100);
  assert.deepEqual([workers[0].ended, calls(workers[1])], [true, [['plan', 'a']]]);
  // The new one may take as long to load as it takes, before it says something and after.
  pass(600_000);
  says(workers[1], 'received');
  pass(600_000);
  assert.equal(workers.length, 2);
  says(workers[1], 'value', { value: 1 });
  assert.equal(await plan, 1);
});

test('what is computed at the time may take as long as it takes; between the portions of a plan the silence is longer', async () => {
  const planner = await made(new Queue(Infinity));
  const explained = planner.explain('a', new Float64Array(1), new Float64Array(7));
  const [, question] = workers[0].requests;
  says(workers[0], 'begun', {}, question);
  const plan = planner.plan('a');
  pass(600_000);
  assert.equal(workers.length, 1);
  says(workers[0], 'value', { value: 1 }, question);
  assert.equal(await explained, 1);
  for (const kind of ['received', 'begun', 'progress']) says(workers[0], kind, { progress: { done: 1, frames: 9 } });
  const trace = planner.trace('a', 0, new Float64Array());
  pass(9000);
  assert.equal(workers.length, 1);
  pass(1000);
  assert.deepEqual(calls(workers[1]).map(([call]) => call), ['plan', 'trace']);
  says(workers[1], 'value', { value: 2 }, workers[1].requests[0]);
  says(workers[1], 'value', { value: 3 });
  assert.deepEqual([await plan, await trace], [2, 3]);
});

test('without locks a plan that is asked to stop tells it too', async () => {
  const planner = await made();
  const stop = new AbortController();
  const plan = planner.plan('a', { stop: stop.signal });
  for (const kind of ['received', 'begun', 'progress']) says(workers[0], kind, { progress: { done: 1, frames: 9 } });
  pass(600_000);
  assert.equal(workers.length, 1, 'a silent plan alone tells nothing');
  stop.abort();
  pass(9900);
  assert.equal(workers.length, 1);
  pass(100);
  assert.deepEqual(calls(workers[1]), [['plan', 'a']]);
  says(workers[1], 'value', { value: 1 });
  assert.equal(await plan, 1);
});

test('after the page was asleep the worker has its time again', async () => {
  const planner = await made();
  const plan = planner.plan('a');
  now += 3_600_000;
  pass(1500);
  assert.equal(workers.length, 1);
  says(workers[0], 'received');
  pass(60_000);
  says(workers[0], 'value', { value: 1 });
  assert.deepEqual([await plan, workers.length], [1, 1]);
});

test('a lock that the page may not ask for leaves the silence to tell it', async () => {
  const planner = await made();
  navigator.locks.request = () => Promise.reject(new DOMException('no origin', 'SecurityError'));
  workers[0].says({ kind: 'holds', lock: 'one' });
  await Promise.resolve();
  await Promise.resolve();
  const plan = planner.plan('a');
  pass(1500);
  assert.equal(workers.length, 2);
  says(workers[1], 'value', { value: 1 });
  assert.equal(await plan, 1);
});

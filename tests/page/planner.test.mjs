// The promises in front of the worker, with a worker that answers on command.
import assert from 'node:assert/strict';
import { afterEach, beforeEach, mock, test } from 'node:test';
import { Desk } from '../../www/desk.js';
import { DocumentFault, Planner, PlannerFailure, Superseded } from '../../www/planner.js';

/** @type {{requests: {id: number, call: string, args: unknown[]}[], ended: boolean, onmessage: Function, onerror: Function}[]} */
let workers;

beforeEach(() => {
  workers = [];
  globalThis.Worker = class {
    requests = [];
    ended = false;
    constructor() {
      workers.push(this);
    }
    postMessage(request) {
      this.requests.push(request);
    }
    terminate() {
      this.ended = true;
    }
  };
});
afterEach(() => mock.timers.reset());

const answer = (worker, message) => worker.onmessage({ data: { id: worker.requests.at(-1).id, ...message } });

test('an answer comes back to its question', async () => {
  const planner = new Planner(new Desk());
  const motion = planner.plan('a');
  answer(workers[0], { kind: 'value', value: 'motion of a' });
  assert.equal(await motion, 'motion of a');
});

test('the latest edit wins: of the waiting plans only the newest is made', async () => {
  const planner = new Planner(new Desk());
  const plans = ['a', 'b', 'c'].map((text) => planner.plan(text));
  const overtaken = assert.rejects(plans[1], Superseded);
  answer(workers[0], { kind: 'value', value: 1 });
  answer(workers[0], { kind: 'value', value: 3 });
  assert.deepEqual([await plans[0], await plans[2]], [1, 3]);
  await overtaken;
  assert.deepEqual(workers[0].requests.map((r) => r.args[0]), ['a', 'c']);
});

test('the linkage follows the latest hand: of the waiting pulls, drives and explanations only the newest of each is asked', async () => {
  const planner = new Planner(new Desk());
  const joints = new Float64Array(3);
  const goal = new Float64Array(7);
  const first = planner.plan('a');
  const old = [planner.pull('a', joints, goal), planner.drive('a', joints, 1, 0.1), planner.explain('a', joints, goal)];
  const overtaken = Promise.all(old.map((promise) => assert.rejects(promise, Superseded)));
  const calls = [planner.pull('b', joints, goal), planner.drive('b', joints, 2, 0.2), planner.explain('b', joints, goal)];
  await overtaken;
  for (const value of ['motion', 'pulled', 'driven', 'explained']) answer(workers[0], { kind: 'value', value });
  assert.deepEqual(await Promise.all([first, ...calls]), ['motion', 'pulled', 'driven', 'explained']);
  assert.deepEqual(
    workers[0].requests.map(({ call, args }) => [call, ...args]),
    [['plan', 'a'], ['pull', 'b', joints, goal], ['drive', 'b', joints, 2, 0.2], ['explain', 'b', joints, goal]],
  );
});

test('a fault of the document is told with its place, and the worker lives', async () => {
  const planner = new Planner(new Desk());
  const plan = planner.plan('a');
  const fault = { code: 'x', message: 'no number', where: 'chains[0]', accepted: 'a number' };
  answer(workers[0], { kind: 'fault', fault });
  await assert.rejects(plan, (error) => error instanceof DocumentFault && error.fault === fault);
  assert.equal(workers[0].ended, false);
});

test('a failed worker is discarded, and the next plan gets a new one', async () => {
  const planner = new Planner(new Desk());
  const first = planner.plan('a');
  const second = planner.plan('b');
  answer(workers[0], { kind: 'failure', message: 'unreachable' });
  await assert.rejects(first, PlannerFailure);
  assert.equal(workers[0].ended, true);
  answer(workers[1], { kind: 'value', value: 2 });
  assert.equal(await second, 2);
});

test('a worker that cannot be loaded is not tried for ever', async () => {
  const planner = new Planner(new Desk());
  const plan = planner.plan('a');
  workers[0].onerror({ preventDefault() {}, message: 'gone' });
  await assert.rejects(plan, PlannerFailure);
  assert.equal(workers.length, 1);
});

test('a plan that hangs gives way to a newer edit, not before one comes', async () => {
  mock.timers.enable({ apis: ['setTimeout'] });
  const planner = new Planner(new Desk());
  const slow = planner.plan('a');
  mock.timers.tick(60_000);
  assert.equal(workers[0].ended, false);
  const next = planner.plan('b');
  const given = assert.rejects(slow, PlannerFailure);
  mock.timers.tick(60_000);
  await given;
  answer(workers[1], { kind: 'value', value: 2 });
  assert.equal(await next, 2);
});

test('a program’s desk waits for what takes long, and others wait behind it', async () => {
  mock.timers.enable({ apis: ['setTimeout'] });
  const planner = new Planner(new Desk(Infinity));
  const slow = planner.plan('a');
  const next = planner.normalise('b');
  mock.timers.tick(600_000);
  assert.equal(workers[0].ended, false);
  answer(workers[0], { kind: 'value', value: 1 });
  answer(workers[0], { kind: 'value', value: 'c' });
  assert.deepEqual([await slow, await next], [1, 'c']);
});

test('a question that is taken back ends: one that waits is not asked, one that is being answered ends its worker', async () => {
  const desk = new Desk(Infinity);
  const asked = [new AbortController(), new AbortController()];
  const answers = [...asked.map(({ signal }) => signal), undefined].map((signal, index) => desk.ask({ asker: desk, latest: false, call: 'plan', args: [index], signal }));
  const ended = answers.slice(0, 2).map((promise) => assert.rejects(promise, { name: 'AbortError' }));
  asked[1].abort();
  await ended[1];
  assert.equal(workers[0].ended, false);
  asked[0].abort();
  await ended[0];
  assert.equal(workers[0].ended, true);
  assert.deepEqual(workers[1].requests.map(({ args }) => args), [[2]]);
  answer(workers[1], { kind: 'value', value: 2 });
  assert.equal(await answers[2], 2);
});

test('two linkages share a worker: neither overtakes the other, and what is slow in one is waited for by the other', async () => {
  mock.timers.enable({ apis: ['setTimeout'] });
  const desk = new Desk();
  const [one, two] = [new Planner(desk), new Planner(desk)];
  const slow = one.plan('slow');
  const others = [two.plan('a'), two.plan('b')];
  const overtaken = assert.rejects(others[0], Superseded);
  mock.timers.tick(60_000);
  await overtaken;
  assert.equal(workers.length, 1);
  assert.equal(workers[0].ended, false, 'the other waits');
  answer(workers[0], { kind: 'value', value: 1 });
  answer(workers[0], { kind: 'value', value: 2 });
  assert.deepEqual([await slow, await others[1]], [1, 2]);
  // Its own newer edit ends it, and the other's request is answered by a new worker.
  const hangs = assert.rejects(one.plan('hangs'), PlannerFailure);
  const newer = one.plan('newer');
  const theirs = two.plan('theirs');
  mock.timers.tick(60_000);
  await hangs;
  answer(workers[1], { kind: 'value', value: 3 });
  answer(workers[1], { kind: 'value', value: 4 });
  assert.deepEqual([await newer, await theirs], [3, 4]);
});

test('a question that cannot be copied is refused, and the next is answered', async () => {
  const planner = new Planner(new Desk());
  const first = planner.plan('a');
  answer(workers[0], { kind: 'value', value: 1 });
  await first;
  const { postMessage } = workers[0];
  workers[0].postMessage = () => {
    throw new DOMException('it cannot be cloned', 'DataCloneError');
  };
  await assert.rejects(planner.plan('b'), /cannot be cloned/);
  workers[0].postMessage = postMessage;
  const next = planner.plan('c');
  answer(workers[0], { kind: 'value', value: 3 });
  assert.equal(await next, 3);
});

// The promises in front of the worker, with a worker that answers on command.
import assert from 'node:assert/strict';
import { getEventListeners } from 'node:events';
import { afterEach, beforeEach, mock, test } from 'node:test';
import { Queue } from '../../www/planner/queue.js';
import { DocumentFault, Planner, PlannerFailure, PlannerNotLoaded, Superseded } from '../../www/planner/planner.js';

/** `requests` are the questions, `messages` all that was posted. @type {{requests: {id: number, call: string, args: unknown[], document?: number, text?: string}[], messages: any[], ended: boolean, onmessage: Function, onerror: Function}[]} */
let workers;

beforeEach(() => {
  workers = [];
  globalThis.Worker = class {
    messages = [];
    ended = false;
    constructor() {
      workers.push(this);
    }
    get requests() {
      return this.messages.filter(({ kind }) => kind === 'ask');
    }
    postMessage(message) {
      this.messages.push(message);
    }
    terminate() {
      this.ended = true;
    }
  };
});
afterEach(() => mock.timers.reset());

/** Answers a question, the last one unless told. */
const answer = (worker, message, { id } = worker.requests.at(-1)) => worker.onmessage({ data: { id, ...message } });
/** Says that a question is computed now, the last one unless told. */
const begin = (worker, question) => answer(worker, { kind: 'begun' }, question);
const others = (worker) => worker.messages.filter(({ kind }) => kind !== 'ask');
const textsOf = (worker) => worker.requests.map(({ text }) => text);

test('an answer comes back to its question', async () => {
  const planner = new Planner(new Queue());
  const motion = planner.plan('a');
  answer(workers[0], { kind: 'value', value: 'motion of a' });
  assert.equal(await motion, 'motion of a');
});

test('the latest edit wins: of the waiting plans only the newest is made', async () => {
  const planner = new Planner(new Queue());
  const plans = ['a', 'b', 'c'].map((text) => planner.plan(text));
  const overtaken = assert.rejects(plans[1], Superseded);
  answer(workers[0], { kind: 'value', value: 1 });
  answer(workers[0], { kind: 'value', value: 3 });
  assert.deepEqual([await plans[0], await plans[2]], [1, 3]);
  await overtaken;
  assert.deepEqual(textsOf(workers[0]), ['a', 'c']);
});

test('the linkage follows the latest hand: of the waiting pulls, drives and explanations only the newest of each is asked, one at a time', async () => {
  const planner = new Planner(new Queue());
  const joints = new Float64Array(3);
  const goal = new Float64Array(7);
  const first = planner.normalise('a');
  const old = [planner.pull('a', joints, goal), planner.drive('a', joints, 1, 0.1), planner.explain('a', joints, goal)];
  const overtaken = Promise.all(old.map((promise) => assert.rejects(promise, Superseded)));
  const calls = [planner.pull('b', joints, goal), planner.drive('b', joints, 2, 0.2), planner.explain('b', joints, goal)];
  await overtaken;
  for (const value of ['whole', 'pulled', 'driven', 'explained']) answer(workers[0], { kind: 'value', value });
  assert.deepEqual(await Promise.all([first, ...calls]), ['whole', 'pulled', 'driven', 'explained']);
  assert.deepEqual(
    workers[0].requests.map(({ call, text, args }) => [call, text, ...args]),
    [['text', 'a'], ['pull', 'b', joints, goal], ['drive', undefined, joints, 2, 0.2], ['explain', undefined, joints, goal]],
  );
});

test('a document is opened once and asked many times; of five the one that was not asked about longest is closed', async () => {
  const queue = new Queue();
  const [one, two] = [new Planner(queue), new Planner(queue)];
  const asked = async (planner, text) => {
    const answered = planner.normalise(text);
    answer(workers[0], { kind: 'value', value: '' });
    await answered;
    return workers[0].requests.at(-1);
  };
  assert.deepEqual([await asked(one, 'a'), await asked(one, 'a')].map(({ doc, text }) => [doc, text]), [[1, 'a'], [1, undefined]]);
  // Another asker has a document of its own, and so a plan of its own.
  assert.deepEqual((await asked(two, 'a')).doc, 2);
  await asked(one, 'b');
  await asked(one, 'c');
  await asked(one, 'a');
  assert.deepEqual(others(workers[0]), []);
  await asked(one, 'd');
  assert.deepEqual(others(workers[0]), [{ kind: 'close', doc: 2 }]);
  assert.equal((await asked(two, 'a')).text, 'a', 'it is opened anew');
  queue.close(one, 'd');
  assert.deepEqual(others(workers[0]).at(-1), { kind: 'close', doc: 5 });
});

test('while a plan goes on, short questions are asked beside it, of its own asker too', async () => {
  const queue = new Queue();
  const [one, two] = [new Planner(queue), new Planner(queue)];
  const seen = [];
  const slow = one.plan('a', { onProgress: (progress) => seen.push(progress) });
  const [plan] = workers[0].requests;
  for (const planner of [one, two]) {
    const explained = planner.explain('a', new Float64Array(1), new Float64Array(7));
    answer(workers[0], { kind: 'value', value: 'explained' });
    assert.equal(await explained, 'explained');
    answer(workers[0], { kind: 'progress', progress: { done: 1, frames: 9 } }, plan);
  }
  // Another asker's plan too: the worker makes portions of each in turn.
  const quick = two.plan('b');
  answer(workers[0], { kind: 'value', value: 2 });
  assert.equal(await quick, 2);
  answer(workers[0], { kind: 'value', value: 1 }, plan);
  assert.equal(await slow, 1);
  assert.deepEqual(seen, [{ done: 1, frames: 9 }, { done: 1, frames: 9 }]);
});

test('a plan that is stopped ends with what there is so far', async () => {
  const planner = new Planner(new Queue());
  const stop = new AbortController();
  const plan = planner.plan('a', { stop: stop.signal });
  stop.abort();
  assert.deepEqual(others(workers[0]), [{ kind: 'stop', id: workers[0].requests[0].id }]);
  answer(workers[0], { kind: 'value', value: 'a part' });
  assert.equal(await plan, 'a part');
  // Stopped before it began: as far as one portion goes.
  const next = planner.plan('b', { stop: stop.signal });
  assert.deepEqual(others(workers[0]).at(-1), { kind: 'stop', id: workers[0].requests[1].id });
  answer(workers[0], { kind: 'value', value: 'a portion' });
  assert.equal(await next, 'a portion');
});

test('a fault of the document is told with its place, and the worker lives', async () => {
  const planner = new Planner(new Queue());
  const plan = planner.plan('a');
  const fault = { code: 'x', message: 'no number', where: 'chains[0]', accepted: 'a number' };
  answer(workers[0], { kind: 'fault', fault });
  await assert.rejects(plan, (error) => error instanceof DocumentFault && error.fault === fault);
  assert.equal(workers[0].ended, false);
});

test('a failed worker is discarded, and the next plan gets a new one', async () => {
  const planner = new Planner(new Queue());
  const first = planner.plan('a');
  const second = planner.plan('b');
  answer(workers[0], { kind: 'failure', message: 'unreachable' });
  await assert.rejects(first, PlannerFailure);
  assert.equal(workers[0].ended, true);
  answer(workers[1], { kind: 'value', value: 2 });
  assert.equal(await second, 2);
});

test('where no worker starts the page plans by itself; where that cannot be loaded either, the next question begins with a worker', async () => {
  const planner = new Planner(new Queue());
  for (const count of [1, 2, 3]) {
    const [plan, waits] = [planner.plan('a'), planner.plan('b')].map((promise) => assert.rejects(promise, PlannerNotLoaded));
    workers.at(-1).onerror({ preventDefault() {}, message: 'gone' });
    await Promise.all([plan, waits]);
    assert.equal(workers.length, count);
  }
});

test('what could not be loaded fails all that waited for it, and is not kept', async () => {
  const queue = new Queue();
  const [one, two] = [new Planner(queue), new Planner(queue)];
  const lost = [one.plan('a'), one.ready(), two.normalise('b')].map((promise) => assert.rejects(promise, PlannerNotLoaded));
  answer(workers[0], { kind: 'failure', message: '503', loading: true });
  await Promise.all(lost);
  assert.deepEqual([workers.length, workers[0].ended], [1, true]);
  const next = one.ready();
  answer(workers[1], { kind: 'value', value: 1 });
  assert.equal(await next, 1);
});

test('where the rest of the package could not be loaded plans go on; a new worker tries again as soon as none does', async () => {
  const planner = new Planner(new Queue());
  const plan = planner.plan('a');
  const [asked] = workers[0].requests;
  begin(workers[0], asked);
  const trace = () => planner.trace('a', 0, new Float64Array());
  for (const _ of [1, 2]) {
    const lost = assert.rejects(trace(), PlannerNotLoaded);
    answer(workers[0], { kind: 'failure', message: '503', loading: true });
    await lost;
  }
  answer(workers[0], { kind: 'value', value: 1 }, asked);
  assert.equal(await plan, 1);
  const traced = trace();
  assert.deepEqual([workers.length, textsOf(workers[1])], [2, ['a']]);
  answer(workers[1], { kind: 'value', value: 2 });
  assert.equal(await traced, 2);
});

test('a plan gives way to a newer edit, not before one comes, nor before half a second', async () => {
  mock.timers.enable({ apis: ['setTimeout'] });
  const planner = new Planner(new Queue());
  const slow = planner.plan('a');
  mock.timers.tick(60_000);
  assert.deepEqual(others(workers[0]), []);
  const overtaken = assert.rejects(slow, Superseded);
  const next = planner.plan('b');
  await overtaken;
  assert.deepEqual(others(workers[0]), [{ kind: 'cancel', id: workers[0].requests[0].id }]);
  // The next is asked for when the first has ended.
  assert.deepEqual(textsOf(workers[0]), ['a']);
  answer(workers[0], { kind: 'cancelled' });
  assert.deepEqual(textsOf(workers[0]), ['a', 'b']);
  const third = planner.plan('c');
  mock.timers.tick(400);
  assert.equal(others(workers[0]).length, 1);
  answer(workers[0], { kind: 'value', value: 2 });
  answer(workers[0], { kind: 'value', value: 3 });
  assert.deepEqual([await next, await third], [2, 3], 'what is quick is shown on the way');
  assert.equal(workers[0].ended, false);
});

test('a plan that does not end when it is taken back ends with its worker; the others are asked again', async () => {
  mock.timers.enable({ apis: ['setTimeout'] });
  const queue = new Queue();
  const [planner, other] = [new Planner(queue), new Planner(queue)];
  const hangs = assert.rejects(planner.plan('a'), Superseded);
  const theirs = other.plan('theirs');
  begin(workers[0], workers[0].requests[0]);
  mock.timers.tick(1000);
  const next = planner.plan('b');
  await hangs;
  mock.timers.tick(3000);
  assert.equal(workers[0].ended, false);
  mock.timers.tick(1000);
  assert.equal(workers[0].ended, true);
  assert.deepEqual(textsOf(workers[1]), ['theirs', 'b']);
  answer(workers[1], { kind: 'value', value: 1 }, workers[1].requests[0]);
  answer(workers[1], { kind: 'value', value: 2 });
  assert.deepEqual([await theirs, await next], [1, 2]);
});

test('a question that hangs gives way to a newer one of the same asker', async () => {
  mock.timers.enable({ apis: ['setTimeout'] });
  const planner = new Planner(new Queue());
  const slow = planner.trace('a', 0, new Float64Array());
  begin(workers[0]);
  mock.timers.tick(60_000);
  assert.equal(workers[0].ended, false);
  const given = assert.rejects(slow, PlannerFailure);
  const next = planner.normalise('b');
  mock.timers.tick(4000);
  await given;
  answer(workers[1], { kind: 'value', value: 2 });
  assert.equal(await next, 2);
});

test('a question that hangs gives way to one of another asker, which is answered', async () => {
  mock.timers.enable({ apis: ['setTimeout'] });
  const queue = new Queue();
  const [one, two] = [new Planner(queue), new Planner(queue)];
  const given = assert.rejects(one.trace('a', 0, new Float64Array()), PlannerFailure);
  begin(workers[0]);
  mock.timers.tick(60_000);
  assert.equal(workers[0].ended, false);
  const [plan, next] = [two.plan('b'), two.normalise('b')];
  mock.timers.tick(3900);
  assert.equal(workers[0].ended, false);
  mock.timers.tick(100);
  await given;
  assert.deepEqual(workers[1].requests.map(({ call }) => call), ['plan', 'text']);
  answer(workers[1], { kind: 'value', value: 1 }, workers[1].requests[0]);
  answer(workers[1], { kind: 'value', value: 2 });
  assert.deepEqual([await plan, await next], [1, 2]);
});

test('an asker that leaves takes all of its questions back, and its documents are closed; the others stay', async () => {
  const queue = new Queue();
  const [one, two] = [new Planner(queue), new Planner(queue)];
  const gone = [one.plan('a'), one.exportMotion('b', 'csv'), one.normalise('a'), one.explain('a', new Float64Array(1), new Float64Array(7))].map((promise) => assert.rejects(promise, Superseded));
  const theirs = [two.plan('a'), two.normalise('a')];
  const [plan, file, short] = workers[0].requests;
  for (const question of [plan, file, short]) begin(workers[0], question);
  assert.equal(one.leave(), true, 'a plan was under way');
  await Promise.all(gone);
  assert.deepEqual(others(workers[0]), [...[plan, file, short].map(({ id }) => ({ kind: 'cancel', id })), ...[file, plan].map(({ doc }) => ({ kind: 'close', doc }))]);
  for (const question of [plan, file, short]) answer(workers[0], { kind: 'cancelled' }, question);
  assert.deepEqual(workers[0].requests.map(({ call }) => call), ['plan', 'export_motion', 'text', 'plan', 'text'], 'what waited is not asked');
  answer(workers[0], { kind: 'value', value: 1 }, workers[0].requests[3]);
  answer(workers[0], { kind: 'value', value: 2 });
  assert.deepEqual(await Promise.all(theirs), [1, 2]);
  assert.equal(two.leave(), false);
  // It may come back.
  const again = one.plan('a');
  assert.equal(workers[0].requests.at(-1).text, 'a');
  answer(workers[0], { kind: 'value', value: 3 });
  assert.deepEqual([await again, workers.length], [3, 1]);
});

test('on a slow network the planner may take as long to load as it takes, also for what is taken back', async () => {
  mock.timers.enable({ apis: ['setTimeout'] });
  const planner = new Planner(new Queue());
  const first = planner.ready();
  const waits = planner.normalise('a');
  const old = assert.rejects(planner.plan('a'), Superseded);
  mock.timers.tick(1000);
  const plan = planner.plan('b');
  await old;
  mock.timers.tick(600_000);
  assert.deepEqual([workers.length, workers[0].ended], [1, false]);
  answer(workers[0], { kind: 'cancelled' });
  const [ready] = workers[0].requests;
  begin(workers[0], ready);
  mock.timers.tick(1000);
  answer(workers[0], { kind: 'value', value: 1 }, ready);
  answer(workers[0], { kind: 'value', value: 2 });
  answer(workers[0], { kind: 'value', value: 3 }, workers[0].requests[2]);
  assert.deepEqual(await Promise.all([first, waits, plan]), [1, 2, 3]);
  assert.deepEqual(workers[0].requests.map(({ call }) => call), ['ready', 'plan', 'plan', 'text']);
});

test('what is taken back on its way into the worker is ended with it where it hangs there', async () => {
  mock.timers.enable({ apis: ['setTimeout'] });
  const planner = new Planner(new Queue());
  const old = assert.rejects(planner.plan('a'), Superseded);
  mock.timers.tick(1000);
  const next = planner.plan('b');
  await old;
  begin(workers[0]);
  mock.timers.tick(4000);
  assert.equal(workers[0].ended, true);
  answer(workers[1], { kind: 'value', value: 2 });
  assert.equal(await next, 2);
});

test('a program’s queue waits for what takes long, and others wait behind it', async () => {
  mock.timers.enable({ apis: ['setTimeout'] });
  const planner = new Planner(new Queue(Infinity));
  const slow = planner.trace('a', 0, new Float64Array());
  begin(workers[0]);
  const next = planner.normalise('b');
  mock.timers.tick(600_000);
  assert.equal(workers[0].ended, false);
  answer(workers[0], { kind: 'value', value: 1 });
  answer(workers[0], { kind: 'value', value: 'c' });
  assert.deepEqual([await slow, await next], [1, 'c']);
});

test('a question that is taken back ends: one that waits is not asked, a plan ends at its next portion', async () => {
  const queue = new Queue(Infinity);
  const asked = [new AbortController(), new AbortController()];
  const answers = [...asked.map(({ signal }) => signal), undefined].map((signal, index) => queue.ask({ asker: queue, latest: false, call: 'plan', text: `${index}`, args: [], signal }));
  const ended = answers.slice(0, 2).map((promise) => assert.rejects(promise, { name: 'AbortError' }));
  asked[1].abort();
  await ended[1];
  asked[0].abort();
  await ended[0];
  assert.deepEqual(others(workers[0]), [{ kind: 'cancel', id: workers[0].requests[0].id }]);
  answer(workers[0], { kind: 'cancelled' });
  assert.deepEqual(textsOf(workers[0]), ['0', '2']);
  answer(workers[0], { kind: 'value', value: 2 });
  assert.equal(await answers[2], 2);
  assert.equal(workers[0].ended, false);
});

test('two plans of one document wait for each other, as they are made in one place', async () => {
  const queue = new Queue(Infinity);
  const plan = (call) => queue.ask({ asker: queue, latest: false, call, text: 'a', args: [] });
  const both = [plan('plan'), plan('export_motion')];
  assert.deepEqual(workers[0].requests.map(({ call }) => call), ['plan']);
  answer(workers[0], { kind: 'value', value: 1 });
  answer(workers[0], { kind: 'value', value: 2 });
  assert.deepEqual(await Promise.all(both), [1, 2]);
});

test('a failure is its own question’s; the others of its worker are asked again', async () => {
  const queue = new Queue();
  const [one, two] = [new Planner(queue), new Planner(queue)];
  const failing = assert.rejects(one.plan('a'), PlannerFailure);
  const theirs = two.plan('b');
  answer(workers[0], { kind: 'failure', message: 'unreachable' }, workers[0].requests[0]);
  await failing;
  assert.deepEqual([workers[0].ended, textsOf(workers[1])], [true, ['b']]);
  answer(workers[1], { kind: 'value', value: 1 });
  assert.equal(await theirs, 1);
});

test('a question that cannot be copied is refused, and the next is answered', async () => {
  const planner = new Planner(new Queue());
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

test('an answered question leaves no listener on its signals', async () => {
  const [signal, stop] = [new AbortController().signal, new AbortController().signal];
  const queue = new Queue();
  const answered = queue.ask({ asker: {}, latest: false, call: 'plan', args: [], text: 'a', signal, stop });
  assert.deepEqual([signal, stop].map((one) => getEventListeners(one, 'abort').length), [1, 1]);
  answer(workers[0], { kind: 'value', value: 1 });
  await answered;
  assert.deepEqual([signal, stop].map((one) => getEventListeners(one, 'abort').length), [0, 0]);
});

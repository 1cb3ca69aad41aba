/**
 * The queue that all planners of a page share, in front of one worker with one wasm module. The worker has one short
 * question at a time, and beside it plans, which it makes in portions. A worker that fails or hangs is discarded and a new
 * one made; the questions of others are asked again.
 *
 * @typedef {import('./calls.js').Answer} Answer
 * @typedef {import('./calls.js').Call} Call
 * @typedef {import('./calls.js').Message} Message
 * @typedef {import('../core/types.js').Progress} Progress
 *
 * `text` is the document that is asked about. `latest`: takes the place of the same asker's same call. `signal` takes the
 * question back; `stop` asks for what there is so far of a plan.
 * @typedef {{asker: object, latest: boolean, call: Call, args: unknown[], text?: string, signal?: AbortSignal,
 *   stop?: AbortSignal, onProgress?: (progress: Progress) => void}} Request
 *
 * `begun` once the worker computes, which on a slow network it first has to load; `slow` after a while; `cancelled` if its
 * answer is not wanted any more.
 * @typedef {Request & {id: number, resolve: (value: any) => void, reject: (reason: unknown) => void, begun: boolean,
 *   slow: boolean, cancelled: boolean, timer?: ReturnType<typeof setTimeout>}} Job
 */
import { DocumentFault, PlannerFailure, Superseded } from './errors.js';
import { openChannel } from './channel.js';

/** How long a question that is computed may hold up a newer one of the same asker before its worker is ended, in milliseconds. */
const PATIENCE = 4000;

/** How long a plan goes on while a newer one of the same asker waits, in milliseconds: what changes step by step is seen to. */
const GRACE = 500;

/** How many documents the worker keeps open: those of some elements, or those that undo and redo go through. */
const MAX_OPEN = 4;

/** What goes in portions. @type {Call[]} */
const LONG = ['plan', 'compare_metrics', 'export_motion'];

export class Queue {
  #patience;
  /** @type {import('./channel.js').Channel | null} */
  #channel = null;
  /** @type {Job[]} */
  #waiting = [];
  /** What the worker has. @type {Map<number, Job>} */
  #running = new Map();
  #lastId = 0;
  /** The numbers of open documents by asker and text, the one last asked about at the end. @type {Map<string, number>} */
  #open = new Map();
  #lastDocument = 0;
  /** @type {WeakMap<object, number>} */
  #askers = new WeakMap();
  #lastAsker = 0;

  /** @param {number} [patience] in milliseconds */
  constructor(patience = PATIENCE) {
    this.#patience = patience;
  }

  /** @param {Request} request @returns {Promise<any>} */
  ask(request) {
    const old = request.latest && this.#waiting.find((job) => isSame(job, request));
    if (old) {
      this.#waiting = this.#waiting.filter((job) => job !== old);
      old.reject(new Superseded());
    }
    return new Promise((resolve, reject) => {
      /** @type {Job} */
      const job = { ...request, id: ++this.#lastId, resolve, reject, begun: false, slow: false, cancelled: false };
      this.#waiting.push(job);
      request.signal?.addEventListener('abort', () => this.#takeBack(job), { once: true });
      request.stop?.addEventListener('abort', () => this.#stop(job), { once: true });
      this.#next();
    });
  }

  /** Frees a document that is not asked about any more. @param {object} asker @param {string} text */
  close(asker, text) {
    this.#close(this.#keyOf(asker, text));
  }

  #next() {
    for (const job of this.#running.values()) this.#hurry(job);
    for (const job of [...this.#waiting]) if (this.#isFree(job)) this.#post(job);
  }

  /** Whether the worker can have this job now. @param {Job} job */
  #isFree(job) {
    const running = [...this.#running.values()];
    if (!isLong(job)) return running.every(isLong);
    return running.every((other) => !isLong(other) || !(isSame(other, job) || isOfSamePlan(other, job)));
  }

  /** Only newer questions of the same asker end a job: a slow plan holds up only its own element. @param {Job} job */
  #hurry(job) {
    if (job.cancelled) {
      if (job.begun) job.timer ??= setTimeout(() => this.#discard(new PlannerFailure('a question could not be taken back'), job), PATIENCE);
    } else if (isLong(job)) {
      if (job.slow && this.#waiting.some((other) => other.latest && isSame(other, job))) this.#cancel(job, new Superseded());
    } else if (job.begun && this.#patience < Infinity && this.#waiting.some(({ asker }) => asker === job.asker)) {
      // setTimeout cannot take Infinity.
      job.timer ??= setTimeout(() => this.#discard(new PlannerFailure('a question took too long and was given up'), job), this.#patience);
    }
  }

  /** @param {Job} job */
  #post(job) {
    this.#waiting = this.#waiting.filter((other) => other !== job);
    this.#running.set(job.id, job);
    this.#channel ??= openChannel(
      (answer) => this.#receive(answer),
      (reason) => this.#discard(new PlannerFailure(reason)),
    );
    const { id, call, args, text } = job;
    /** @type {Message & {kind: 'ask'}} */
    const message = { kind: 'ask', id, call, args };
    const key = text === undefined ? '' : this.#keyOf(job.asker, text);
    if (text !== undefined) {
      const known = this.#open.get(key);
      message.doc = known ?? ++this.#lastDocument;
      if (known === undefined) message.text = text;
    }
    try {
      this.#channel.post(message);
    } catch (error) {
      // The structured clone failed: an argument is a function, say.
      this.#settle(job);
      job.reject(error);
      return;
    }
    if (message.doc !== undefined) this.#keepOpen(key, message.doc);
    if (job.stop?.aborted) this.#channel.post({ kind: 'stop', id });
    if (isLong(job) && job.latest) {
      job.timer = setTimeout(() => {
        job.slow = true;
        this.#next();
      }, GRACE);
    }
  }

  /** @param {Answer} answer */
  #receive(answer) {
    const job = this.#running.get(answer.id);
    if (!job) return;
    if (answer.kind === 'begun') {
      job.begun = true;
      this.#hurry(job);
      return;
    }
    if (answer.kind === 'progress') {
      if (!job.cancelled) job.onProgress?.(answer.progress);
      return;
    }
    if (answer.kind === 'failure') return this.#discard(new PlannerFailure(answer.message), job);
    this.#settle(job);
    if (answer.kind === 'fault') job.reject(new DocumentFault(answer.fault));
    else if (answer.kind === 'value') job.resolve(answer.value);
    this.#next();
  }

  /** @param {Job} job */
  #takeBack(job) {
    if (this.#running.has(job.id)) return this.#cancel(job, job.signal?.reason);
    this.#waiting = this.#waiting.filter((other) => other !== job);
    job.reject(job.signal?.reason);
  }

  /** Its promise ends at once, its work at the next portion, or with the worker where that does not come. @param {Job} job @param {unknown} reason */
  #cancel(job, reason) {
    job.reject(reason);
    if (job.cancelled) return;
    job.cancelled = true;
    clearTimeout(job.timer);
    job.timer = undefined;
    this.#channel?.post({ kind: 'cancel', id: job.id });
    this.#hurry(job);
  }

  /** @param {Job} job */
  #stop(job) {
    if (this.#running.has(job.id)) this.#channel?.post({ kind: 'stop', id: job.id });
  }

  /** Ends the worker and fails the job that is to blame, all where none is known; the others are asked again. @param {PlannerFailure} reason @param {Job} [guilty] */
  #discard(reason, guilty) {
    this.#channel?.close();
    this.#channel = null;
    this.#open.clear();
    const jobs = [...this.#running.values()];
    for (const job of jobs) this.#settle(job);
    const others = jobs.filter((job) => guilty && job !== guilty && !job.cancelled);
    this.#waiting.unshift(...others);
    for (const job of jobs) if (!others.includes(job)) job.reject(reason);
    this.#next();
  }

  /** @param {Job} job */
  #settle(job) {
    clearTimeout(job.timer);
    job.timer = undefined;
    job.begun = false;
    job.slow = false;
    this.#running.delete(job.id);
  }

  /** @param {object} asker @param {string} text */
  #keyOf(asker, text) {
    const number = this.#askers.get(asker) ?? ++this.#lastAsker;
    this.#askers.set(asker, number);
    return `${number} ${text}`;
  }

  /** @param {string} key @param {number} doc */
  #keepOpen(key, doc) {
    this.#open.delete(key);
    this.#open.set(key, doc);
    const [oldest] = this.#open.keys();
    if (this.#open.size > MAX_OPEN) this.#close(oldest);
  }

  /** @param {string} key */
  #close(key) {
    const doc = this.#open.get(key);
    this.#open.delete(key);
    if (doc !== undefined) this.#channel?.post({ kind: 'close', doc });
  }
}

/** @param {Job} job */
const isLong = ({ call }) => LONG.includes(call);

/** Whether one of the two goes on with what the other one plans; a comparison makes plans of its own. @param {Request} one @param {Request} other */
const isOfSamePlan = (one, other) =>
  one.asker === other.asker && one.text === other.text && one.call !== 'compare_metrics' && other.call !== 'compare_metrics';

/** @param {Request} one @param {Request} other */
const isSame = (one, other) => one.asker === other.asker && one.call === other.call;

/** The page's own. */
export const queue = new Queue();

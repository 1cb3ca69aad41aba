/**
 * The queue that all planners of a page share, in front of one worker with one wasm module. The worker has one short
 * question at a time, and beside it plans, which it makes in portions. A worker that fails or hangs is discarded and a new
 * one made; the questions of others are asked again. One that was ended from outside (watch.js) is made anew, and each of
 * its questions asked once again.
 *
 * Plans hold up no other question. A short question cannot be interrupted, and while it is computed the worker does nothing
 * else: some seconds after another question was asked, by any asker, it is given up with its worker. Where nothing more is
 * asked it is left to end, and plans under way wait meanwhile: in a new worker they would begin again.
 *
 * @typedef {import('./calls.js').Answer} Answer
 * @typedef {import('./calls.js').Call} Call
 * @typedef {import('./calls.js').Message} Message
 *
 * `text` is the document that is asked about. `latest`: takes the place of the same asker's same call. `signal` takes the
 * question back; `stop` asks for what there is so far of a plan.
 * @typedef {{asker: object, latest: boolean, call: Call, args: unknown[], text?: string, signal?: AbortSignal,
 *   stop?: AbortSignal, onProgress?: (progress: any) => void}} Request
 *
 * `begun` once the worker computes, which on a slow network it first has to load; `slow` after a while; `cancelled` if its
 * answer is not wanted any more; `repeated` if it is asked again because its worker ended.
 * @typedef {Request & {id: number, resolve: (value: any) => void, reject: (reason: unknown) => void, begun: boolean,
 *   slow: boolean, cancelled: boolean, repeated: boolean, timer?: ReturnType<typeof setTimeout>}} Job
 */
import { DocumentFault, PlannerFailure, PlannerNotLoaded, Superseded } from './errors.js';
import { openChannel } from './channel.js';
import { onAbort } from './on-abort.js';
import { OpenDocuments } from './open-documents.js';

/** How long a question that is computed may hold up others before its worker is ended, in milliseconds. */
const PATIENCE = 4000;

/** How long a plan goes on while a newer one of the same asker waits, in milliseconds: what changes step by step is seen to. */
const GRACE = 500;

/** What goes in portions. @type {Call[]} */
const LONG = ['plan', 'compare_metrics', 'export_motion', 'best', 'modes'];

/** What does so with motions of its own. @type {Call[]} */
const APART = ['compare_metrics', 'modes'];

export class Queue {
  #patience;
  /** @type {import('./channel.js').Channel | null} */
  #channel = null;
  /** @type {Job[]} */
  #waiting = [];
  /** What the worker has. @type {Map<number, Job>} */
  #running = new Map();
  #lastId = 0;
  #documents = new OpenDocuments((doc) => this.#channel?.post({ kind: 'close', doc }));
  /** Whether the present worker has computed something: then it is loaded, but for the rest of the package. */
  #isLoaded = false;
  /** Whether the present worker lacks the rest: a browser may remember that a module could not be loaded. */
  #isIncomplete = false;

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
    /** @type {(() => void)[]} */
    const ends = [];
    const answer = new Promise((resolve, reject) => {
      /** @type {Job} */
      const job = { ...request, id: ++this.#lastId, resolve, reject, begun: false, slow: false, cancelled: false, repeated: false };
      this.#waiting.push(job);
      const { signal, stop } = request;
      if (signal) ends.push(onAbort(signal, () => this.#takeBack(job, signal.reason)));
      if (stop) ends.push(onAbort(stop, () => this.#stop(job)));
      this.#next();
    });
    const over = () => ends.forEach((end) => end());
    answer.then(over, over);
    return answer;
  }

  /** Loads all that questions may need, in a worker that is there already. */
  prepare() {
    this.#channel?.post({ kind: 'prepare' });
  }

  /** Frees a document that is not asked about any more. @param {object} asker @param {string} text */
  close(asker, text) {
    this.#documents.close(asker, text);
  }

  /** Whether its worker has a document open. @param {object} asker @param {string} text */
  knows(asker, text) {
    return this.#documents.has(asker, text);
  }

  /** Takes back all that an asker asked, and frees its documents. @param {object} asker @returns {Call[]} what was asked */
  leave(asker) {
    const jobs = [...this.#running.values(), ...this.#waiting].filter((job) => job.asker === asker && !job.cancelled);
    for (const job of jobs) this.#takeBack(job, new Superseded());
    this.#documents.closeAllOf(asker);
    this.#next();
    return jobs.map(({ call }) => call);
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

  /** Ends a plan for a newer one of the same asker, another question for those that it holds up. @param {Job} job */
  #hurry(job) {
    if (job.cancelled) {
      if (job.begun) job.timer ??= setTimeout(() => this.#discard(new PlannerFailure('a question could not be taken back'), (one) => one === job), PATIENCE);
    } else if (isLong(job)) {
      if (job.slow && this.#waiting.some((other) => other.latest && isSame(other, job))) this.#cancel(job, new Superseded());
    } else if (job.begun && this.#patience < Infinity && this.#waiting.length > 0) {
      // setTimeout cannot take Infinity.
      job.timer ??= setTimeout(() => this.#discard(new PlannerFailure('a question took too long and was given up'), (one) => one === job), this.#patience);
    }
  }

  /** @param {Job} job */
  #post(job) {
    if (!this.#running.size && (this.#isIncomplete || this.#channel?.isMakeshift())) this.#closeChannel();
    this.#waiting = this.#waiting.filter((other) => other !== job);
    this.#running.set(job.id, job);
    this.#channel ??= openChannel(
      (answer) => this.#receive(answer),
      (reason) => this.#askAgain(new PlannerFailure(reason)),
    );
    const { id, call, args, asker, text } = job;
    const about = text === undefined ? null : this.#documents.about(asker, text);
    try {
      this.#channel.post({ kind: 'ask', id, call, args, ...about });
    } catch (error) {
      // The structured clone failed: an argument is a function, say.
      this.#settle(job);
      job.reject(error);
      return;
    }
    if (about && text !== undefined) this.#documents.keep(asker, text, about.doc);
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
      job.begun = this.#isLoaded = true;
      this.#hurry(job);
      return;
    }
    if (answer.kind === 'received') return;
    if (answer.kind === 'progress') {
      if (!job.cancelled) job.onProgress?.(answer.progress);
      return;
    }
    if (answer.kind === 'failure') {
      if (answer.loading) this.#notLoaded(job, new PlannerNotLoaded(answer.message));
      else this.#discard(new PlannerFailure(answer.message), (one) => one === job);
      return;
    }
    this.#settle(job);
    if (answer.kind === 'fault') job.reject(new DocumentFault(answer.fault));
    else if (answer.kind === 'value') job.resolve(answer.value);
    this.#next();
  }

  /** @param {Job} job @param {unknown} reason */
  #takeBack(job, reason) {
    if (this.#running.has(job.id)) return this.#cancel(job, reason);
    this.#waiting = this.#waiting.filter((other) => other !== job);
    job.reject(reason);
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

  /** Ends the worker and fails the jobs that are to blame; the others are asked again. @param {PlannerFailure} reason @param {(job: Job) => boolean} isGuilty */
  #discard(reason, isGuilty) {
    this.#closeChannel();
    const jobs = [...this.#running.values()];
    for (const job of jobs) this.#settle(job);
    this.#waiting.unshift(...jobs.filter((job) => !job.cancelled && !isGuilty(job)));
    for (const job of jobs) if (isGuilty(job)) job.reject(reason);
    this.#next();
  }

  /** The worker has ended, by which question is not known: each is asked again once, and fails if its worker ends then too. @param {PlannerFailure} reason */
  #askAgain(reason) {
    const twice = [...this.#running.values()].filter(({ repeated }) => repeated);
    for (const job of this.#running.values()) job.repeated = true;
    this.#discard(reason, (job) => twice.includes(job));
  }

  /** All that waits for the load has failed with it; what needs only the part that is loaded goes on. @param {Job} job @param {PlannerNotLoaded} reason */
  #notLoaded(job, reason) {
    if (this.#isLoaded) {
      this.#settle(job);
      job.reject(reason);
      this.#isIncomplete = true;
      return this.#next();
    }
    const waiting = this.#waiting.splice(0);
    this.#discard(reason, () => true);
    for (const other of waiting) other.reject(reason);
  }

  #closeChannel() {
    this.#channel?.close();
    this.#channel = null;
    this.#isLoaded = this.#isIncomplete = false;
    this.#documents.forget();
  }

  /** @param {Job} job */
  #settle(job) {
    clearTimeout(job.timer);
    job.timer = undefined;
    job.begun = false;
    job.slow = false;
    this.#running.delete(job.id);
  }
}

/** Whether it goes in portions. @param {Request} request */
export const isLong = ({ call }) => LONG.includes(call);

/** Whether one of the two goes on with what the other one plans. @param {Request} one @param {Request} other */
const isOfSamePlan = (one, other) =>
  one.asker === other.asker && one.text === other.text && ![one, other].some(({ call }) => APART.includes(call));

/** @param {Request} one @param {Request} other */
const isSame = (one, other) => one.asker === other.asker && one.call === other.call;

/** The page's own. */
export const queue = new Queue();

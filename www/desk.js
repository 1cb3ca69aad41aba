/**
 * The desk that all planners of a page share: one worker with one wasm module, one request at a time. A worker that
 * fails or hangs is discarded and a new one made; the requests of others wait for it.
 *
 * @typedef {import('./planner.calls.js').Answer} Answer
 * @typedef {import('./planner.calls.js').Call} Call
 * @typedef {{asker: object, latest: boolean, call: Call, args: unknown[], signal?: AbortSignal}} Request
 *   `latest`: takes the place of the same asker's same call that is still waiting; `signal` takes the request back
 * @typedef {Request & {id: number, resolve: (value: any) => void, reject: (reason: Error) => void}} Job
 */
import { DocumentFault, PlannerFailure, Superseded } from './faults.js';
import { openPort } from './port.js';

/** How long a plan may hold up a newer request of the same asker before its worker is ended, in milliseconds. */
const PATIENCE = 4000;

export class Desk {
  #patience;
  /** @type {import('./port.js').Port | null} */
  #port = null;
  /** @type {Job[]} */
  #waiting = [];
  /** @type {Job | null} */
  #running = null;
  #lastId = 0;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #timer;

  /** @param {number} [patience] in milliseconds */
  constructor(patience = PATIENCE) {
    this.#patience = patience;
  }

  /** @param {Request} request @returns {Promise<any>} */
  ask(request) {
    const old = request.latest && this.#waiting.find(({ asker, call }) => asker === request.asker && call === request.call);
    if (old) {
      this.#waiting = this.#waiting.filter((job) => job !== old);
      old.reject(new Superseded());
    }
    return new Promise((resolve, reject) => {
      const job = { ...request, id: ++this.#lastId, resolve, reject };
      this.#waiting.push(job);
      request.signal?.addEventListener('abort', () => this.#takeBack(job), { once: true });
      this.#next();
    });
  }

  #next() {
    if (this.#running) {
      // Only a newer request of the same asker ends it: what is slow in one linkage is no fault of another's.
      const { asker } = this.#running;
      const overtaken = this.#waiting.some((job) => job.asker === asker);
      // A timer knows no infinity.
      if (overtaken && this.#patience < Infinity) this.#timer ??= setTimeout(() => this.#discard(new PlannerFailure('a plan took too long and was given up')), this.#patience);
      return;
    }
    const job = this.#waiting.shift();
    if (!job) return;
    this.#running = job;
    this.#port ??= openPort(
      (answer) => this.#receive(answer),
      (reason) => this.#discard(new PlannerFailure(reason)),
    );
    try {
      this.#port.post({ id: job.id, call: job.call, args: job.args });
    } catch (error) {
      // What cannot be copied, a function for a number, is no question.
      this.#settle();
      job.reject(/** @type {Error} */ (error));
    }
    if (this.#waiting.length) this.#next();
  }

  /** @param {Answer} answer */
  #receive(answer) {
    const job = this.#running;
    if (!job || answer.id !== job.id) return;
    if (answer.kind === 'failure') return this.#discard(new PlannerFailure(answer.message));
    this.#settle();
    if (answer.kind === 'fault') job.reject(new DocumentFault(answer.fault));
    else job.resolve(answer.value);
    this.#next();
  }

  /** @param {Job} job */
  #takeBack(job) {
    if (job === this.#running) return this.#discard(job.signal?.reason);
    this.#waiting = this.#waiting.filter((other) => other !== job);
    job.reject(job.signal?.reason);
  }

  /** Ends the worker and fails its job; the next job makes a new one. @param {Error} reason */
  #discard(reason) {
    this.#port?.close();
    this.#port = null;
    const job = this.#running;
    this.#settle();
    job?.reject(reason);
    this.#next();
  }

  #settle() {
    clearTimeout(this.#timer);
    this.#timer = undefined;
    this.#running = null;
  }
}

/** The page's own. */
export const desk = new Desk();

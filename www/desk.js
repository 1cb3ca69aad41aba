/**
 * The desk that all planners of a page share: one worker with one wasm module, one request at a time. A worker that
 * fails or hangs is discarded and a new one made; the requests of others wait for it.
 *
 * @typedef {import('./planner.calls.js').Answer} Answer
 * @typedef {import('./planner.calls.js').Call} Call
 * @typedef {{asker: object, latest: boolean, call: Call, args: unknown[]}} Request
 *   `latest`: takes the place of the same asker's same call that is still waiting
 * @typedef {Request & {id: number, resolve: (value: any) => void, reject: (reason: Error) => void}} Job
 */
import { openPort } from './port.js';

/** How long a plan may hold up a newer request before its worker is ended, in milliseconds. */
const PATIENCE = 4000;

/** The document is at fault, and a person can mend it. */
export class DocumentFault extends Error {
  /** @param {import('./types.js').Fault} fault */
  constructor(fault) {
    super(fault.message);
    this.fault = fault;
  }
}

/** A newer call of the same kind took this one's place; its answer would have been out of date. */
export class Superseded extends Error {}

/** The planner itself failed: our mistake, not the document's. */
export class PlannerFailure extends Error {}

export class Desk {
  /** @type {import('./port.js').Port | null} */
  #port = null;
  /** @type {Job[]} */
  #waiting = [];
  /** @type {Job | null} */
  #running = null;
  #lastId = 0;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #timer;

  /** @param {Request} request @returns {Promise<any>} */
  ask(request) {
    const old = request.latest && this.#waiting.find(({ asker, call }) => asker === request.asker && call === request.call);
    if (old) {
      this.#waiting = this.#waiting.filter((job) => job !== old);
      old.reject(new Superseded());
    }
    return new Promise((resolve, reject) => {
      this.#waiting.push({ ...request, id: ++this.#lastId, resolve, reject });
      this.#next();
    });
  }

  #next() {
    if (this.#running) {
      this.#timer ??= setTimeout(() => this.#discard('a plan took too long and was given up'), PATIENCE);
      return;
    }
    const job = this.#waiting.shift();
    if (!job) return;
    this.#running = job;
    this.#port ??= openPort(
      (answer) => this.#receive(answer),
      (reason) => this.#discard(reason),
    );
    this.#port.post({ id: job.id, call: job.call, args: job.args });
    if (this.#waiting.length) this.#next();
  }

  /** @param {Answer} answer */
  #receive(answer) {
    const job = this.#running;
    if (!job || answer.id !== job.id) return;
    if (answer.kind === 'failure') return this.#discard(answer.message);
    this.#settle();
    if (answer.kind === 'fault') job.reject(new DocumentFault(answer.fault));
    else job.resolve(answer.value);
    this.#next();
  }

  /** Ends the worker and fails its job; the next job makes a new one. @param {string} reason */
  #discard(reason) {
    this.#port?.close();
    this.#port = null;
    const job = this.#running;
    this.#settle();
    job?.reject(new PlannerFailure(reason));
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

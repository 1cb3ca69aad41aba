/**
 * Several queues, each with a worker of its own, for programs that ask much at once. A worker is started when a question
 * comes and all others have something to do, until there are as many as the machine has processors.
 *
 * A session's questions go to one worker, which has its document open. Of the functions each question goes to a worker that
 * has its document, or to one that is free; a worker plans for one function at a time, and the other functions' plans wait
 * for the first that has done with its own.
 *
 * @typedef {import('./queue.js').Request} Request
 * @typedef {{queue: Queue, open: Set<Request>}} Member `open`: what has no answer yet
 * @typedef {{request: Request, resolve: (answer: Promise<any>) => void}} Waiting
 */
import { onAbort } from './on-abort.js';
import { isLong, Queue } from './queue.js';
import { atMost } from './start-worker.js';

export class Pool {
  #patience;
  #size = atMost();
  /** @type {Member[]} */
  #members = [];
  /** Of each session. @type {WeakMap<object, Member>} */
  #of = new WeakMap();
  /** @type {Waiting[]} */
  #waiting = [];

  /** @param {number} patience of each queue */
  constructor(patience) {
    this.#patience = patience;
  }

  /** Asked by the pool itself, it is a function's question. @param {Request} request @returns {Promise<any>} */
  ask(request) {
    const { signal } = request;
    return new Promise((resolve, reject) => {
      const waiting = { request, resolve };
      this.#waiting.push(waiting);
      this.#next();
      if (!signal || !this.#waiting.includes(waiting)) return;
      const end = onAbort(signal, () => {
        end();
        this.#waiting = this.#waiting.filter((other) => other !== waiting);
        reject(signal.reason);
      });
      waiting.resolve = (answer) => {
        end();
        resolve(answer);
      };
    });
  }

  /** Frees a document that is not asked about any more. @param {object} asker @param {string} text */
  close(asker, text) {
    this.#of.get(asker)?.queue.close(asker, text);
  }

  #next() {
    for (const waiting of [...this.#waiting]) {
      const member = this.#memberFor(waiting.request);
      if (!member) continue;
      this.#waiting = this.#waiting.filter((other) => other !== waiting);
      waiting.resolve(this.#give(waiting.request, member));
    }
  }

  /** @param {Request} request @param {Member} member */
  #give(request, member) {
    member.open.add(request);
    const answer = member.queue.ask(request);
    const end = () => {
      member.open.delete(request);
      this.#next();
    };
    answer.then(end, end);
    return answer;
  }

  /** @param {Request} request @returns {Member | undefined} undefined where it has to wait */
  #memberFor(request) {
    const { asker, text } = request;
    if (asker !== this) {
      const member = this.#of.get(asker) ?? this.#idle() ?? this.#leastAsked();
      this.#of.set(asker, member);
      return member;
    }
    const plansOther = (/** @type {Member} */ { open }) => isLong(request) && [...open].some((other) => other.asker === this && isLong(other) && other.text !== text);
    const free = this.#members.filter((member) => !plansOther(member));
    const knowing = text === undefined ? undefined : free.find(({ queue, open }) => queue.knows(this, text) || [...open].some((other) => other.asker === this && other.text === text));
    return knowing ?? this.#idle() ?? (isLong(request) && free.length === 0 ? undefined : this.#leastAsked(free));
  }

  /** One that has nothing to do, a new one if there may be one more. */
  #idle() {
    const idle = this.#members.find(({ open }) => open.size === 0);
    if (idle || this.#members.length >= this.#size) return idle;
    const member = { queue: new Queue(this.#patience), open: new Set() };
    this.#members.push(member);
    return member;
  }

  #leastAsked(among = this.#members) {
    return among.reduce((best, member) => (member.open.size < best.open.size ? member : best));
  }
}

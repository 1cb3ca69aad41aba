/**
 * The planner's searches, which take long: for the best motion, and for all ways to assemble at a key frame. In a worker of
 * their own, so that no plan waits for one. What is found so far is told while they go on; asked again, a search goes on
 * where it was.
 *
 * @typedef {import('../core/types.js').Best} Best
 * @typedef {import('../core/types.js').CalmMotion} CalmMotion
 * @typedef {import('../core/types.js').Modes} Modes
 * @typedef {import('../core/types.js').Motion} Motion
 * @typedef {import('./calls.js').Call} Call
 */
import { Queue } from './queue.js';

/** Nothing is held up by what it is asked: it waits for all. */
const own = new Queue(Infinity);

export class Search {
  #queue;

  constructor(where = own) {
    this.#queue = where;
  }

  /** The best motion, its branches and switches, in numbers. @param {string} text a document @param {{signal: AbortSignal, onProgress: (soFar: Best) => void}} options @returns {Promise<Best>} */
  best(text, options) {
    return this.#ask('best', text, [], options);
  }

  /** The best motion found so far. @param {string} text a document @returns {Promise<Motion>} */
  bestMotion(text) {
    return this.#ask('best_motion', text, []);
  }

  /** The calm form under a price for the motion of joints, once the search is complete. @param {string} text a document @param {number} price @returns {Promise<CalmMotion>} */
  calmMotion(text, price) {
    return this.#ask('calm_motion', text, [price]);
  }

  /** The best motion found so far, or its calm form at a price, for other programs. @param {string} text a document @param {import('../core/types.js').ExportFormat} format @param {import('../core/types.js').ExportOptions} options @param {number} [price] @returns {Promise<string>} */
  exportBest(text, format, options, price) {
    return this.#ask('export_best', text, [format, JSON.stringify(options), price]);
  }

  /** All ways to assemble at a key frame, and what the motion from each costs. @param {string} text a document @param {number} key from 0 @param {{signal: AbortSignal, onProgress: (soFar: Modes) => void}} options @returns {Promise<Modes>} */
  modes(text, key, options) {
    return this.#ask('modes', text, [key], options);
  }

  /** The document that starts as one of them. @param {string} text a document @param {number} index @returns {Promise<string>} */
  textWithMode(text, index) {
    return this.#ask('text_with_mode', text, [index]);
  }

  /** Takes back all that it asked, and frees its documents. */
  leave() {
    this.#queue.leave(this);
  }

  /** @param {Call} call @param {string} text @param {unknown[]} args @param {{signal?: AbortSignal, onProgress?: (soFar: any) => void}} [options] */
  #ask(call, text, args, options) {
    return this.#queue.ask({ asker: this, latest: true, call, text, args, ...options });
  }
}

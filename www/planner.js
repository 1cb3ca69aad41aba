/**
 * The page's planner: promises in front of a worker. The latest edit wins; a planner that fails or hangs is
 * discarded and a new one made, and the document survives.
 *
 * @typedef {import('./types.js').Motion} Motion
 * @typedef {import('./types.js').Fault} Fault
 * @typedef {import('./types.js').Defaults} Defaults
 * @typedef {import('./types.js').Posture} Posture
 * @typedef {import('./types.js').Insight} Insight
 * @typedef {import('./planner.worker.js').Answer} Answer
 * @typedef {import('./planner.worker.js').Call} Call
 * @typedef {{id: number, call: Call, args: unknown[], resolve: (value: any) => void, reject: (reason: Error) => void}} Job
 */

/** How long a plan may hold up a newer edit before its worker is ended, in milliseconds. */
const PATIENCE = 4000;

/** The document is at fault, and a person can mend it. */
export class DocumentFault extends Error {
  /** @param {Fault} fault */
  constructor(fault) {
    super(fault.message);
    this.fault = fault;
  }
}

/** A newer call of the same kind took this one's place; its answer would have been out of date. */
export class Superseded extends Error {}

/** The planner itself failed: our mistake, not the document's. */
export class PlannerFailure extends Error {}

export class Planner {
  /** @type {Worker | null} */
  #worker = null;
  /** @type {Job[]} */
  #waiting = [];
  /** @type {Job | null} */
  #running = null;
  #lastId = 0;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #timer;

  /** @param {string} text a document @returns {Promise<Motion>} */
  plan(text) {
    return this.#askLatest('plan', text);
  }

  /**
   * The closest reachable pose to a goal, on the branch of the joint values.
   * @param {string} text a document
   * @param {Float64Array} joints rad or lengths
   * @param {Float64Array} goal x y z, then the quaternion x y z w
   * @returns {Promise<Posture>}
   */
  pull(text, joints, goal) {
    return this.#askLatest('pull', text, joints, goal);
  }

  /**
   * One joint variable driven to a value; the loops stay closed and the other joints follow.
   * @param {string} text a document
   * @param {Float64Array} joints rad or lengths
   * @param {number} variable counted through all chains
   * @param {number} value rad or length
   * @returns {Promise<Posture>}
   */
  drive(text, joints, variable, value) {
    return this.#askLatest('drive', text, joints, variable, value);
  }

  /**
   * What holds the workpiece at the joint values against the pull of the goal, and what leaves it free.
   * @param {string} text a document
   * @param {Float64Array} joints rad or lengths
   * @param {Float64Array} goal x y z, then the quaternion x y z w
   * @returns {Promise<Insight>}
   */
  explain(text, joints, goal) {
    return this.#askLatest('explain', text, joints, goal);
  }

  /** The document with every default written out. @param {string} text @returns {Promise<string>} */
  normalise(text) {
    return this.#ask('normalise', text);
  }

  /** The document with start values that close its loops. @param {string} text @returns {Promise<string>} */
  findStart(text) {
    return this.#ask('find_start', text);
  }

  /**
   * The planned motion as a text for other programs.
   * @param {string} text a document @param {'csv' | 'json' | 'mjcf'} format @returns {Promise<string>}
   */
  exportMotion(text, format) {
    return this.#ask('export_motion', text, format);
  }

  /**
   * The iterations of both methods at one frame. @param {string} text a document @param {number} frame
   * @param {Float64Array} joints where to start: the answer of the frame before; empty for the document's start
   * @returns {Promise<import('./types.js').Trace>}
   */
  trace(text, frame, joints) {
    return this.#askLatest('trace', text, frame, joints);
  }

  /** The matrix [A] at a position. @param {string} text a document @param {Float64Array} joints @returns {Promise<import('./types.js').Matrix>} */
  matrix(text, joints) {
    return this.#askLatest('matrix', text, joints);
  }

  /** @returns {Promise<Defaults>} */
  defaults() {
    return this.#ask('defaults');
  }

  /** Tables 2 and 3. @returns {Promise<import('./pkg/synthetica.js').Enumeration>} */
  enumeration() {
    return this.#ask('enumeration');
  }

  /** Takes the place of the same call that is still waiting: its answer would be out of date. @param {Call} call @param {...unknown} args */
  #askLatest(call, ...args) {
    const old = this.#waiting.find((job) => job.call === call);
    if (old) {
      this.#waiting = this.#waiting.filter((job) => job !== old);
      old.reject(new Superseded());
    }
    return this.#ask(call, ...args);
  }

  /** @param {Call} call @param {...unknown} args @returns {Promise<any>} */
  #ask(call, ...args) {
    return new Promise((resolve, reject) => {
      this.#waiting.push({ id: ++this.#lastId, call, args, resolve, reject });
      this.#next();
    });
  }

  #start() {
    const worker = new Worker(new URL('./planner.worker.js', import.meta.url), { type: 'module' });
    worker.onmessage = ({ data }) => this.#receive(data);
    worker.onerror = (event) => {
      event.preventDefault();
      this.#discard(event.message || 'the planner could not be loaded');
    };
    return worker;
  }

  #next() {
    if (this.#running) {
      this.#timer ??= setTimeout(() => this.#discard('a plan took too long and was given up'), PATIENCE);
      return;
    }
    const job = this.#waiting.shift();
    if (!job) return;
    this.#running = job;
    this.#worker ??= this.#start();
    this.#worker.postMessage({ id: job.id, call: job.call, args: job.args });
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
    this.#worker?.terminate();
    this.#worker = null;
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

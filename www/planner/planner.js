/**
 * A linkage's planner: promises in front of the page's one worker (queue.js). The latest edit wins.
 *
 * @typedef {import('../core/types.js').Motion} Motion
 * @typedef {import('../core/types.js').Fault} Fault
 * @typedef {import('../core/types.js').Posture} Posture
 * @typedef {import('../core/types.js').Insight} Insight
 * @typedef {import('./calls.js').Call} Call
 * @typedef {Pick<import('./queue.js').Request, 'stop' | 'onProgress'>} PlanOptions `stop` asks for what there is so far
 */
import { queue } from './queue.js';

export { DocumentFault, PlannerFailure, PlannerNotLoaded, Superseded } from './errors.js';

export class Planner {
  #queue;
  /** @type {Promise<void> | null} */
  #ready = null;
  /** @type {Promise<void> | null} */
  #held = null;

  constructor(where = queue) {
    this.#queue = where;
  }

  /** @param {string} text a document @param {PlanOptions} [options] @returns {Promise<Motion>} */
  plan(text, options) {
    return this.#queue.ask({ asker: this, latest: true, call: 'plan', text, args: [], ...options });
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
    return this.#ask('text', text);
  }

  /** The document with start values that close its loops. @param {string} text @returns {Promise<string>} */
  findStart(text) {
    return this.#ask('find_start', text);
  }

  /**
   * The planned motion as a text for other programs.
   * @param {string} text a document @param {import('../core/types.js').ExportFormat} format
   * @param {import('../core/types.js').ExportOptions} [options] @returns {Promise<string>}
   */
  exportMotion(text, format, options = {}) {
    return this.#ask('export_motion', text, format, JSON.stringify(options));
  }

  /**
   * The iterations of both methods at one frame. @param {string} text a document @param {number} frame
   * @param {Float64Array} joints where to start: the answer of the frame before; empty for the document's start
   * @returns {Promise<import('../core/types.js').Trace>}
   */
  trace(text, frame, joints) {
    return this.#askLatest('trace', text, frame, joints);
  }

  /** The matrix [A] at a position. @param {string} text a document @param {Float64Array} joints @returns {Promise<import('../core/types.js').Matrix>} */
  matrix(text, joints) {
    return this.#askLatest('matrix', text, joints);
  }

  /**
   * The largest gaps of the motion with either metric. @param {string} text a document @param {AbortSignal} signal takes the question back
   * @returns {Promise<[import('../core/types.js').MetricGaps, import('../core/types.js').MetricGaps]>}
   */
  compareMetrics(text, signal) {
    return this.#queue.ask({ asker: this, latest: true, call: 'compare_metrics', text, args: [], signal });
  }

  /** A chain given by its axes: `{chain, home}` as JSON. @param {string} text a document @param {number} chain @returns {Promise<string>} */
  byAxes(text, chain) {
    return this.#ask('by_axes', text, chain);
  }

  /** Whether the tables are closed at their start if they are standard ones, and not as they are read. @param {string} text a document @returns {Promise<boolean>} */
  looksStandard(text) {
    return this.#askLatest('looks_standard', text);
  }

  /** It is loaded, and answers. @returns {Promise<void>} */
  ready() {
    const asked = () => this.#askNoDocument('ready');
    this.#ready ??= (this.#held ? this.#held.then(asked) : asked()).catch((error) => {
      this.#ready = null;
      throw error;
    });
    return this.#ready;
  }

  /**
   * `ready` is not asked until it is known whether the whole package is needed: then the smaller one need not be loaded.
   * @returns {() => void} it is known
   */
  hold() {
    /** @type {() => void} */
    let known = () => {};
    this.#held = new Promise((resolve) => (known = resolve));
    return known;
  }

  /** A document with a linkage of a type, such as 3RPS or RPS+2TS, or of a maker, delta?base=400. @param {string} type @returns {Promise<string>} */
  assemble(type) {
    return this.#askNoDocument('assemble', type);
  }

  /** A document with a linkage of a type in a person's sizes. @param {string} request a MakeRequest as JSON @returns {Promise<string>} */
  make(request) {
    return this.#queue.ask({ asker: this, latest: true, call: 'make', args: [request] });
  }

  /**
   * Key frames from a table of poses.
   * @param {string} table its text @param {import('../core/types.js').PoseTableRequest} request @returns {Promise<import('../core/types.js').PoseTable>}
   */
  async readPoses(table, request) {
    return JSON.parse(await this.#queue.ask({ asker: this, latest: true, call: 'read_poses', args: [table, JSON.stringify(request)] }));
  }

  /** What can be made from the few numbers of its paper. @returns {Promise<import('../core/types.js').Maker[]>} */
  makers() {
    return this.#askNoDocument('makers');
  }

  /**
   * A document made by a maker.
   * @param {string} name @param {Record<string, string | number | number[]>} inputs those that are not to have their default
   * @param {string} [unit] of the lengths; the maker's where there is none
   * @returns {Promise<string>}
   */
  makeNamed(name, inputs, unit) {
    return this.#queue.ask({ asker: this, latest: true, call: 'make_named', args: [name, JSON.stringify(inputs), unit] });
  }

  /** A small document that plans. @returns {Promise<string>} */
  async small() {
    return (await this.#askNoDocument('defaults')).document;
  }

  /** Tables 2 and 3. @returns {Promise<import('../core/types.js').Enumeration>} */
  enumeration() {
    return this.#askNoDocument('enumeration');
  }

  /** A person may ask for anything soon: what answers it is loaded meanwhile. */
  prepare() {
    this.#queue.prepare();
  }

  /** Takes back all that it asked, and frees its documents. It may ask again. @returns {boolean} whether a plan was under way */
  leave() {
    return this.#queue.leave(this).includes('plan');
  }

  /** Takes the place of the same call that is still waiting: its answer would be out of date. @param {Call} call @param {string} text @param {...unknown} args */
  #askLatest(call, text, ...args) {
    return this.#queue.ask({ asker: this, latest: true, call, text, args });
  }

  /** @param {Call} call @param {string} text @param {...unknown} args */
  #ask(call, text, ...args) {
    return this.#queue.ask({ asker: this, latest: false, call, text, args });
  }

  /** @param {Call} call @param {...unknown} args */
  #askNoDocument(call, ...args) {
    return this.#queue.ask({ asker: this, latest: false, call, args });
  }
}

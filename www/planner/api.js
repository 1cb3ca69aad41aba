/**
 * The planner for programs: every question a function that promises its answer. Planned in a worker where there is one,
 * apart from that of the elements on the same page.
 *
 * @typedef {import('../core/types.js').MechanismDocument} MechanismDocument
 * @typedef {import('../core/types.js').Motion} Motion
 * @typedef {import('../core/types.js').Posture} Posture
 * @typedef {import('../core/types.js').Insight} Insight
 * @typedef {import('../core/types.js').Trace} Trace
 * @typedef {import('../core/types.js').Matrix} Matrix
 * @typedef {import('../core/types.js').MetricGaps} MetricGaps
 * @typedef {import('../core/types.js').Enumeration} Enumeration
 *
 * @typedef {import('../core/types.js').Progress} Progress
 *
 * @typedef {{signal?: AbortSignal}} Options `signal` ends wait and planning
 * @typedef {Options & {stop?: AbortSignal, onProgress?: (progress: Progress) => void}} PlanOptions `stop` ends the planning
 *   with what there is so far, a motion whose `partial` is true; `onProgress` is told how far the planning is
 * @typedef {Pick<PlanOptions, 'signal' | 'onProgress'> & import('../core/types.js').ExportOptions} ExportOptions
 */
import { Queue } from './queue.js';
import { DocumentFault } from './errors.js';
import { groupAt } from '../core/shown.js';

export { DocumentFault, PlannerFailure, PlannerNotLoaded } from './errors.js';

/** A program may ask for what takes minutes, and waits for all that it asked for. */
const queue = new Queue(Infinity);

/** Written anew each time: a program may have changed it. @param {MechanismDocument | string} doc */
const written = (doc) => (typeof doc === 'string' ? doc : JSON.stringify(doc));

/** @param {ArrayLike<number>} numbers */
const column = (numbers) => Float64Array.from(numbers);

/** @param {import('./calls.js').Call} call @param {...unknown} args @returns {Promise<any>} */
const ask = (call, ...args) => queue.ask({ asker: queue, latest: false, call, args });

/**
 * A document as it was when it was opened, of which many questions are asked. It is read and checked once. What is asked
 * of two sessions is answered side by side; one function after the other asks as if of one session.
 */
export class Session {
  #text;
  /** @type {object} */
  #asker;
  #closed = false;

  /**
   * For `open`, which checks the document too.
   * @param {string} text
   * @param {object} [asker] whose plans wait for each other
   */
  constructor(text, asker) {
    this.#text = text;
    this.#asker = asker ?? this;
  }

  /** The closest reachable motion; made once. @param {PlanOptions} [options] @returns {Promise<Motion>} */
  plan(options) {
    return this.#ask('plan', [], options);
  }

  /** The document with every default written out. @returns {Promise<MechanismDocument>} */
  async normalise() {
    return JSON.parse(await this.#ask('text', []));
  }

  /** The document with the start that the planner uses written into it. @returns {Promise<MechanismDocument>} */
  async findStart() {
    return JSON.parse(await this.#ask('find_start', []));
  }

  /**
   * The closest reachable pose to one goal, from joint values along their branch.
   * @param {ArrayLike<number>} joints rad or lengths, chain by chain
   * @param {ArrayLike<number>} goal x y z, then the rotation's quaternion x y z w
   * @returns {Promise<Posture>}
   */
  pull(joints, goal) {
    return this.#ask('pull', [column(joints), column(goal)]);
  }

  /**
   * One joint variable driven to a value; the loops stay closed and the other joints follow.
   * @param {ArrayLike<number>} joints rad or lengths, chain by chain
   * @param {number} variable counted from 0 through all chains
   * @param {number} value rad or length
   * @returns {Promise<Posture>}
   */
  drive(joints, variable, value) {
    return this.#ask('drive', [column(joints), variable, value]);
  }

  /**
   * What holds the workpiece at a position against the pull of a goal, and what leaves it free.
   * @param {ArrayLike<number>} joints rad or lengths, chain by chain
   * @param {ArrayLike<number>} goal x y z, then the rotation's quaternion x y z w
   * @returns {Promise<Insight>}
   */
  explain(joints, goal) {
    return this.#ask('explain', [column(joints), column(goal)]);
  }

  /**
   * The iterations of both methods at one frame.
   * @param {number} frame counted from 0
   * @param {ArrayLike<number>} [joints] those of the frame before; without them the document's start
   * @returns {Promise<Trace>}
   */
  trace(frame, joints = []) {
    return this.#ask('trace', [frame, column(joints)]);
  }

  /** The matrix [A] at a position, with its singular values. @param {ArrayLike<number>} joints rad or lengths, chain by chain @returns {Promise<Matrix>} */
  matrix(joints) {
    return this.#ask('matrix', [column(joints)]);
  }

  /**
   * The largest gaps of the motion planned with the metric `pose` and with `dual-quaternion`.
   * @param {Options} [options] @returns {Promise<[MetricGaps, MetricGaps]>}
   */
  compareMetrics(options) {
    return this.#ask('compare_metrics', [], options);
  }

  /**
   * The planned motion as text for other programs.
   * @param {'csv' | 'json' | 'mjcf'} format `mjcf` is a model for MuJoCo
   * @param {ExportOptions} [options]
   * @returns {Promise<string>}
   */
  exportMotion(format, { signal, onProgress, ...wished } = {}) {
    return this.#ask('export_motion', [format, JSON.stringify(wished)], { signal, onProgress });
  }

  /** Frees what the planner keeps of it; nothing more can be asked. */
  close() {
    this.#closed = true;
    queue.close(this.#asker, this.#text);
  }

  /** @param {import('./calls.js').Call} call @param {unknown[]} args @param {PlanOptions} [options] @returns {Promise<any>} */
  async #ask(call, args, { signal, stop, onProgress } = {}) {
    if (this.#closed) throw new Error('the session is closed');
    signal?.throwIfAborted();
    return queue.ask({ asker: this.#asker, latest: false, call, args, text: this.#text, signal, stop, onProgress });
  }
}

/** @param {MechanismDocument | string} doc */
const once = (doc) => new Session(written(doc), queue);

/**
 * A document that is asked about more than once.
 * @param {MechanismDocument | string} doc an object or its text
 * @returns {Promise<Session>}
 * @throws {DocumentFault} where the document is at fault
 */
export async function open(doc) {
  const session = new Session(written(doc));
  await session.normalise();
  return session;
}

/**
 * The closest reachable motion.
 * @param {MechanismDocument | string} doc an object or its text
 * @param {PlanOptions} [options]
 * @returns {Promise<Motion>}
 * @throws {DocumentFault} where the document is at fault; so do all functions that take one
 */
export async function plan(doc, options) {
  return once(doc).plan(options);
}

/**
 * What is wrong with a document; null where nothing is.
 * @param {MechanismDocument | string} doc @returns {Promise<DocumentFault | null>}
 */
export async function check(doc) {
  try {
    await normalise(doc);
    return null;
  } catch (error) {
    if (error instanceof DocumentFault) return error;
    throw error;
  }
}

/** The document with every default written out. @param {MechanismDocument | string} doc @returns {Promise<MechanismDocument>} */
export async function normalise(doc) {
  return once(doc).normalise();
}

/** The document with the start that the planner uses written into it. @param {MechanismDocument | string} doc @returns {Promise<MechanismDocument>} */
export async function findStart(doc) {
  return once(doc).findStart();
}

/**
 * The closest reachable pose to one goal, from joint values along their branch.
 * @param {MechanismDocument | string} doc
 * @param {ArrayLike<number>} joints rad or lengths, chain by chain
 * @param {ArrayLike<number>} goal x y z, then the rotation's quaternion x y z w
 * @returns {Promise<Posture>}
 */
export async function pull(doc, joints, goal) {
  return once(doc).pull(joints, goal);
}

/**
 * One joint variable driven to a value; the loops stay closed and the other joints follow.
 * @param {MechanismDocument | string} doc
 * @param {ArrayLike<number>} joints rad or lengths, chain by chain
 * @param {number} variable counted from 0 through all chains
 * @param {number} value rad or length
 * @returns {Promise<Posture>}
 */
export async function drive(doc, joints, variable, value) {
  return once(doc).drive(joints, variable, value);
}

/**
 * What holds the workpiece at a position against the pull of a goal, and what leaves it free.
 * @param {MechanismDocument | string} doc
 * @param {ArrayLike<number>} joints rad or lengths, chain by chain
 * @param {ArrayLike<number>} goal x y z, then the rotation's quaternion x y z w
 * @returns {Promise<Insight>}
 */
export async function explain(doc, joints, goal) {
  return once(doc).explain(joints, goal);
}

/**
 * The iterations of both methods at one frame.
 * @param {MechanismDocument | string} doc
 * @param {number} frame counted from 0
 * @param {ArrayLike<number>} [joints] those of the frame before; without them the document's start
 * @returns {Promise<Trace>}
 */
export async function trace(doc, frame, joints = []) {
  return once(doc).trace(frame, joints);
}

/**
 * The matrix [A] at a position, with its singular values.
 * @param {MechanismDocument | string} doc @param {ArrayLike<number>} joints rad or lengths, chain by chain
 * @returns {Promise<Matrix>}
 */
export async function matrix(doc, joints) {
  return once(doc).matrix(joints);
}

/**
 * The largest gaps of the motion planned with the metric `pose` and with `dual-quaternion`.
 * @param {MechanismDocument | string} doc @param {Options} [options] @returns {Promise<[MetricGaps, MetricGaps]>}
 */
export async function compareMetrics(doc, options) {
  return once(doc).compareMetrics(options);
}

/**
 * The planned motion as text for other programs.
 * @param {MechanismDocument | string} doc
 * @param {'csv' | 'json' | 'mjcf'} format `mjcf` is a model for MuJoCo
 * @param {ExportOptions} [options]
 * @returns {Promise<string>}
 */
export async function exportMotion(doc, format, options) {
  return once(doc).exportMotion(format, options);
}

/**
 * A document with a linkage of a type, closed at its start, or one of a maker.
 * @param {string} type such as `3RRS` or `RPS+2TS`, or `delta?base=400&platform=50` @returns {Promise<MechanismDocument>}
 */
export async function assemble(type) {
  return JSON.parse(await ask('assemble', type));
}

/**
 * A document with a linkage of a type in given sizes: equal legs between two circles, closed at its start.
 * @param {import('../core/types.js').MakeRequest} request @returns {Promise<MechanismDocument>}
 */
export async function make(request) {
  return JSON.parse(await ask('make', JSON.stringify(request)));
}

/**
 * Key frames from a table of poses: CSV, or fields parted by tabs, semicolons or blanks. What cannot be taken over is listed
 * by its row.
 * @param {string} table its text
 * @param {import('../core/types.js').PoseTableRequest} [request] what is known of it; the rest is told from its headings and columns
 * @returns {Promise<import('../core/types.js').PoseTable>}
 */
export async function readPoses(table, request = {}) {
  return JSON.parse(await ask('read_poses', table, JSON.stringify(request)));
}

/** What can be made from the few numbers of its paper: names, inputs with their defaults, sources. @returns {Promise<import('../core/types.js').Maker[]>} */
export function makers() {
  return ask('makers');
}

/**
 * A document made by a maker; its numbers are parameters and expressions of them.
 * @param {string} name such as `delta`
 * @param {Record<string, string | number | number[]>} [inputs] those that are not to have their default
 * @param {string} [unit] of the lengths: `m`, `cm`, `mm`, `µm` or `in`; the maker's where there is none
 * @returns {Promise<MechanismDocument>}
 */
export async function makeNamed(name, inputs = {}, unit) {
  return JSON.parse(await ask('make_named', name, JSON.stringify(inputs), unit));
}

/** The JSON Schema of a document. @returns {Promise<Record<string, unknown>>} */
export async function schema() {
  return JSON.parse(await ask('schema'));
}

/** Chain classes and assemblies with their counts: Tables 2 and 3 of the paper. @returns {Promise<Enumeration>} */
export function enumeration() {
  return ask('enumeration');
}

/**
 * The k-th chain with this degree of constraint, such as `RPS`; undefined where there is none.
 * @param {number} constraints @param {number} k counted from 0 @returns {Promise<string | undefined>}
 */
export function chainByIndex(constraints, k) {
  return ask('chain_by_index', constraints, k);
}

/**
 * The k-th assembly with this total degree of constraint, as chain names; undefined where there is none.
 * @param {number} constraints @param {number} k counted from 0 @returns {Promise<string[] | undefined>}
 */
export function assemblyByIndex(constraints, k) {
  return ask('assembly_by_index', constraints, k);
}

/**
 * One frame's numbers of a motion's column: `at(motion, 'joints', 12)`.
 * @param {Motion} motion
 * @param {'joints' | 'pose' | 'goal' | 'rows'} name
 * @param {number} frame counted from 0
 */
export function at(motion, name, frame) {
  return groupAt(motion[name], { index: frame, frames: motion.frames });
}

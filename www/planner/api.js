/**
 * The planner for programs: every question a function that promises its answer. Planned in workers where there are any,
 * apart from that of the elements on the same page. Frames are counted from 0.
 *
 * @typedef {import('../core/types.js').MechanismDocument} MechanismDocument
 * @typedef {import('../core/types.js').Motion} Motion
 * @typedef {import('../core/types.js').Posture} Posture
 * @typedef {import('../core/types.js').Insight} Insight
 * @typedef {import('../core/types.js').Trace} Trace
 * @typedef {import('../core/types.js').Matrix} Matrix
 * @typedef {import('../core/types.js').MetricGaps} MetricGaps
 * @typedef {import('../core/types.js').Enumeration} Enumeration
 * @typedef {import('../core/types.js').Best} Best
 * @typedef {import('../core/types.js').BestPath} BestPath
 * @typedef {import('../core/types.js').CalmMotion} CalmMotion
 * @typedef {import('../core/types.js').Modes} Modes
 *
 * @typedef {import('../core/types.js').Progress} Progress
 *
 * @typedef {{signal?: AbortSignal}} Options `signal` ends wait and planning
 * @typedef {Options & {stop?: AbortSignal, onProgress?: (progress: Progress) => void}} PlanOptions `stop` ends the planning
 *   with what there is so far, a motion whose `partial` is true; `onProgress` is told how far the planning is
 * @typedef {Pick<PlanOptions, 'signal' | 'onProgress'> & import('../core/types.js').ExportOptions} ExportOptions
 * @typedef {Options & {stop?: AbortSignal, onProgress?: (soFar: Best) => void}} BestOptions `stop` ends a search with what is
 *   found so far; `onProgress` is told that while it goes on
 * @typedef {Options & {stop?: AbortSignal, onProgress?: (soFar: Modes) => void}} ModesOptions likewise
 */
import { column, number, object, options as optionsOf, text as textOf, wrong, written } from './arguments.js';
import { DocumentFault } from './errors.js';
import { Pool } from './pool.js';
import { groupAt } from '../core/shown.js';

export { configure } from './configure.js';
export { DocumentFault, PlannerFailure, PlannerNotLoaded } from './errors.js';

/** A program may ask for what takes minutes, and waits for all that it asked for. */
const pool = new Pool(Infinity);

const JOINTS = 'an array of numbers: rad or lengths, chain by chain';
const GOAL = 'an array of 7 numbers: x y z, then the rotation’s quaternion x y z w';

/** The options of a question. @type {Record<string, (keyof PlanOptions | keyof ExportOptions)[]>} */
const KNOWN = { plan: ['signal', 'stop', 'onProgress'], compare_metrics: ['signal'], export_motion: ['signal', 'onProgress', 'headings', 'gravity'], best: ['signal', 'stop', 'onProgress'], modes: ['signal', 'stop', 'onProgress'] };

/** Columns that `at` reads. @type {('joints' | 'pose' | 'goal' | 'rows')[]} */
const GROUPS = ['joints', 'pose', 'goal', 'rows'];

/** @param {import('./calls.js').Call} call @param {...unknown} args @returns {Promise<any>} */
const ask = (call, ...args) => pool.ask({ asker: pool, latest: false, call, args });

/**
 * A document as it was when it was opened, of which many questions are asked. It is read and checked once. What is asked
 * of two sessions is answered side by side; of the functions' plans each worker makes one after the other.
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
    return this.#ask('plan', () => [], options);
  }

  /** The document with every default written out. @returns {Promise<MechanismDocument>} */
  async normalise() {
    return JSON.parse(await this.#ask('text', () => []));
  }

  /** The document with the start that the planner uses written into it. @returns {Promise<MechanismDocument>} */
  async findStart() {
    return JSON.parse(await this.#ask('find_start', () => []));
  }

  /**
   * The closest reachable pose to one goal, from joint values along their branch.
   * @param {ArrayLike<number>} joints rad or lengths, chain by chain
   * @param {ArrayLike<number>} goal x y z, then the rotation's quaternion x y z w
   * @returns {Promise<Posture>}
   */
  pull(joints, goal) {
    return this.#ask('pull', () => [column('joints', joints, JOINTS), column('goal', goal, GOAL)]);
  }

  /**
   * One joint variable driven to a value; the loops stay closed and the other joints follow.
   * @param {ArrayLike<number>} joints rad or lengths, chain by chain
   * @param {number} variable counted from 0 through all chains
   * @param {number} value rad or length
   * @returns {Promise<Posture>}
   */
  drive(joints, variable, value) {
    return this.#ask('drive', () => [column('joints', joints, JOINTS), number('variable', variable, 'a whole number, counted from 0 through all chains'), number('value', value, 'a number: rad or length')]);
  }

  /**
   * What holds the workpiece at a position against the pull of a goal, and what leaves it free.
   * @param {ArrayLike<number>} joints rad or lengths, chain by chain
   * @param {ArrayLike<number>} goal x y z, then the rotation's quaternion x y z w
   * @returns {Promise<Insight>}
   */
  explain(joints, goal) {
    return this.#ask('explain', () => [column('joints', joints, JOINTS), column('goal', goal, GOAL)]);
  }

  /**
   * The iterations of both methods at one frame.
   * @param {number} frame counted from 0
   * @param {ArrayLike<number>} [joints] those of the frame before; without them the document's start
   * @returns {Promise<Trace>}
   */
  trace(frame, joints = []) {
    return this.#ask('trace', () => [number('frame', frame, 'a whole number, counted from 0'), column('joints', joints, JOINTS)]);
  }

  /** The matrix [A] at a position, with its singular values. @param {ArrayLike<number>} joints rad or lengths, chain by chain @returns {Promise<Matrix>} */
  matrix(joints) {
    return this.#ask('matrix', () => [column('joints', joints, JOINTS)]);
  }

  /**
   * The largest gaps of the motion planned with the metric `pose` and with `dual-quaternion`.
   * @param {Options} [options] @returns {Promise<[MetricGaps, MetricGaps]>}
   */
  compareMetrics(options) {
    return this.#ask('compare_metrics', () => [], options);
  }

  /**
   * Searches for the best motion over all branches, with the price of going from one to another: its branches and switches in
   * numbers. A search that was ended goes on when it is asked for again.
   * @param {BestOptions} [options] @returns {Promise<Best>}
   */
  best(options) {
    return this.#ask('best', () => [], options);
  }

  /** The best motion that `best` has found: columns like those of any motion. @returns {Promise<Motion>} */
  bestMotion() {
    return this.#ask('best_motion', () => []);
  }

  /** Its whole closed path, with the points between frames, as of its switches. @returns {Promise<BestPath>} */
  bestPath() {
    return this.#ask('best_path', () => []);
  }

  /**
   * The calm form of the best motion, once `best` is complete.
   * @param {number} price of joint motion, such as those of the curve @returns {Promise<CalmMotion>}
   */
  calmMotion(price) {
    return this.#ask('calm_motion', () => [number('price', price, 'a number, not negative')]);
  }

  /**
   * All ways to assemble the linkage at a key frame, and what the motion planned from each costs.
   * @param {number} key counted from 0 @param {ModesOptions} [options] @returns {Promise<Modes>}
   */
  modes(key, options) {
    return this.#ask('modes', () => [number('key', key, 'a whole number, counted from 0')], options);
  }

  /** The document that starts as one of the ways that `modes` has found. @param {number} index @returns {Promise<MechanismDocument>} */
  async withMode(index) {
    return JSON.parse(await this.#ask('text_with_mode', () => [number('index', index, 'a whole number, counted from 0')]));
  }

  /**
   * The planned motion as text for other programs.
   * @param {'csv' | 'json' | 'mjcf'} format `mjcf` is a model for MuJoCo
   * @param {ExportOptions} [options]
   * @returns {Promise<string>}
   */
  exportMotion(format, options) {
    const args = () => {
      const { signal, onProgress, ...wished } = optionsOf(options, KNOWN.export_motion);
      return [textOf('format', format, 'csv, json, mjcf'), JSON.stringify(wished)];
    };
    return this.#ask('export_motion', args, options);
  }

  /** Frees what the planner keeps of it; nothing more can be asked. */
  close() {
    this.#closed = true;
    pool.close(this.#asker, this.#text);
  }

  /** @param {import('./calls.js').Call} call @param {() => unknown[]} args @param {PlanOptions | BestOptions | ModesOptions} [options] @returns {Promise<any>} */
  async #ask(call, args, options) {
    if (this.#closed) throw new Error('the session is closed');
    const { signal, stop, onProgress } = optionsOf(options, KNOWN[call] ?? []);
    signal?.throwIfAborted();
    return pool.ask({ asker: this.#asker, latest: false, call, args: args(), text: this.#text, signal, stop, onProgress });
  }
}

/** @param {MechanismDocument | string} doc */
const once = (doc) => new Session(written(doc), pool);

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
  return JSON.parse(await ask('assemble', textOf('type', type, 'the name of a type, such as 3RRS')));
}

/**
 * A document with a linkage of a type in given sizes: equal legs between two circles, closed at its start.
 * @param {import('../core/types.js').MakeRequest} request @returns {Promise<MechanismDocument>}
 */
export async function make(request) {
  return JSON.parse(await ask('make', JSON.stringify(object('request', request, 'an object with type and sizes'))));
}

/**
 * Key frames from a table of poses: CSV, or fields parted by tabs, semicolons or blanks. What cannot be taken over is listed
 * by its row.
 * @param {string} table its text
 * @param {import('../core/types.js').PoseTableRequest} [request] what is known of it; the rest is told from its headings and columns
 * @returns {Promise<import('../core/types.js').PoseTable>}
 */
export async function readPoses(table, request = {}) {
  return JSON.parse(await ask('read_poses', textOf('table', table, 'the text of a table'), JSON.stringify(object('request', request, 'an object, see PoseTableRequest'))));
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
  const label = unit === undefined ? unit : textOf('unit', unit, 'm, cm, mm, µm, in');
  return JSON.parse(await ask('make_named', textOf('name', name, 'the name of a maker, such as delta'), JSON.stringify(object('inputs', inputs, 'an object with numbers by their names')), label));
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
export async function chainByIndex(constraints, k) {
  return ask('chain_by_index', number('constraints', constraints), number('k', k));
}

/**
 * The k-th assembly with this total degree of constraint, as chain names; undefined where there is none.
 * @param {number} constraints @param {number} k counted from 0 @returns {Promise<string[] | undefined>}
 */
export async function assemblyByIndex(constraints, k) {
  return ask('assembly_by_index', number('constraints', constraints), number('k', k));
}

/**
 * One frame's numbers of a motion's column: `at(motion, 'joints', 12)`.
 * @param {Motion} motion
 * @param {'joints' | 'pose' | 'goal' | 'rows'} name
 * @param {number} frame counted from 0
 */
export function at(motion, name, frame) {
  const { frames, [name]: numbers } = object('motion', motion, 'a motion that was planned');
  if (!GROUPS.includes(name)) throw wrong('name', name, GROUPS.join(', '));
  if (typeof frames !== 'number' || !ArrayBuffer.isView(numbers)) throw new TypeError(`motion has no frames and ${name}. Accepted: a motion that was planned.`);
  const accepted = `a whole number from 0 to ${frames - 1}`;
  if (!Number.isInteger(number('frame', frame, accepted)) || frame < 0 || frame >= frames) throw new RangeError(`frame is the number ${frame}. Accepted: ${accepted}.`);
  return groupAt(/** @type {Float64Array} */ (numbers), { index: frame, frames });
}

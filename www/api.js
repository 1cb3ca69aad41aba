/**
 * The planner for programs: every question a function that promises its answer. Planned in a worker where there is one,
 * apart from that of the elements on the same page.
 *
 * @typedef {import('./types.js').MechanismDocument} MechanismDocument
 * @typedef {import('./types.js').Motion} Motion
 * @typedef {import('./types.js').Posture} Posture
 * @typedef {import('./types.js').Insight} Insight
 * @typedef {import('./types.js').Trace} Trace
 * @typedef {import('./types.js').Matrix} Matrix
 * @typedef {import('./types.js').Enumeration} Enumeration
 *
 * @typedef {{signal?: AbortSignal}} Options `signal` ends the wait, and the planning where a worker does it
 */
import { Desk } from './desk.js';
import { DocumentFault } from './faults.js';
import { groupAt } from './shown.js';

export { DocumentFault, PlannerFailure } from './faults.js';

/** A program may ask for what takes minutes, and waits for all that it asked for. */
const desk = new Desk(Infinity);

/** @param {import('./planner.calls.js').Call} call @param {unknown[]} args @param {Options} [options] @returns {Promise<any>} */
async function ask(call, args, { signal } = {}) {
  signal?.throwIfAborted();
  return desk.ask({ asker: desk, latest: false, call, args, signal });
}

/** Written anew each time: a program may have changed it. @param {MechanismDocument | string} document */
const written = (document) => (typeof document === 'string' ? document : JSON.stringify(document));

/** @param {ArrayLike<number>} numbers */
const column = (numbers) => Float64Array.from(numbers);

/**
 * The closest reachable motion.
 * @param {MechanismDocument | string} document an object or its text
 * @param {Options} [options]
 * @returns {Promise<Motion>}
 * @throws {DocumentFault} where the document is at fault; so do all functions that take one
 */
export function plan(document, options) {
  return ask('plan', [written(document)], options);
}

/**
 * What is wrong with a document; null where nothing is.
 * @param {MechanismDocument | string} document @returns {Promise<DocumentFault | null>}
 */
export async function check(document) {
  try {
    await normalise(document);
    return null;
  } catch (error) {
    if (error instanceof DocumentFault) return error;
    throw error;
  }
}

/** The document with every default written out. @param {MechanismDocument | string} document @returns {Promise<MechanismDocument>} */
export async function normalise(document) {
  return JSON.parse(await ask('normalise', [written(document)]));
}

/** The document with the start that the planner uses written into it. @param {MechanismDocument | string} document @returns {Promise<MechanismDocument>} */
export async function findStart(document) {
  return JSON.parse(await ask('find_start', [written(document)]));
}

/**
 * The closest reachable pose to one goal, from joint values along their branch.
 * @param {MechanismDocument | string} document
 * @param {ArrayLike<number>} joints rad or lengths, chain by chain
 * @param {ArrayLike<number>} goal x y z, then the rotation's quaternion x y z w
 * @returns {Promise<Posture>}
 */
export function pull(document, joints, goal) {
  return ask('pull', [written(document), column(joints), column(goal)]);
}

/**
 * One joint variable driven to a value; the loops stay closed and the other joints follow.
 * @param {MechanismDocument | string} document
 * @param {ArrayLike<number>} joints rad or lengths, chain by chain
 * @param {number} variable counted from 0 through all chains
 * @param {number} value rad or length
 * @returns {Promise<Posture>}
 */
export function drive(document, joints, variable, value) {
  return ask('drive', [written(document), column(joints), variable, value]);
}

/**
 * What holds the workpiece at a position against the pull of a goal, and what leaves it free.
 * @param {MechanismDocument | string} document
 * @param {ArrayLike<number>} joints rad or lengths, chain by chain
 * @param {ArrayLike<number>} goal x y z, then the rotation's quaternion x y z w
 * @returns {Promise<Insight>}
 */
export function explain(document, joints, goal) {
  return ask('explain', [written(document), column(joints), column(goal)]);
}

/**
 * The iterations of both methods at one frame.
 * @param {MechanismDocument | string} document
 * @param {number} frame counted from 0
 * @param {ArrayLike<number>} [joints] those of the frame before; without them the document's start
 * @returns {Promise<Trace>}
 */
export function trace(document, frame, joints = []) {
  return ask('trace', [written(document), frame, column(joints)]);
}

/**
 * The matrix [A] at a position, with its singular values.
 * @param {MechanismDocument | string} document @param {ArrayLike<number>} joints rad or lengths, chain by chain
 * @returns {Promise<Matrix>}
 */
export function matrix(document, joints) {
  return ask('matrix', [written(document), column(joints)]);
}

/**
 * The planned motion as text for other programs.
 * @param {MechanismDocument | string} document
 * @param {'csv' | 'json' | 'mjcf'} format `mjcf` is a model for MuJoCo
 * @param {Options} [options]
 * @returns {Promise<string>}
 */
export function exportMotion(document, format, options) {
  return ask('export_motion', [written(document), format], options);
}

/**
 * A document with a linkage of a type, closed at its start.
 * @param {string} type such as `3RRS` or `RPS+2TS` @returns {Promise<MechanismDocument>}
 */
export async function assemble(type) {
  return JSON.parse(await ask('assemble', [type]));
}

/** The JSON Schema of a document. @returns {Promise<Record<string, unknown>>} */
export async function schema() {
  return JSON.parse(await ask('schema', []));
}

/** Chain classes and assemblies with their counts: Tables 2 and 3 of the paper. @returns {Promise<Enumeration>} */
export function enumeration() {
  return ask('enumeration', []);
}

/**
 * The k-th chain with this degree of constraint, such as `RPS`; undefined where there is none.
 * @param {number} constraints @param {number} k counted from 0 @returns {Promise<string | undefined>}
 */
export function chainByIndex(constraints, k) {
  return ask('chain_by_index', [constraints, k]);
}

/**
 * The k-th assembly with this total degree of constraint, as chain names; undefined where there is none.
 * @param {number} constraints @param {number} k counted from 0 @returns {Promise<string[] | undefined>}
 */
export function assemblyByIndex(constraints, k) {
  return ask('assembly_by_index', [constraints, k]);
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

/**
 * All faults of a document's cells: the planner names the first one, so each is filled with a number that is always
 * accepted, and the planner asked again.
 *
 * @typedef {import('../../core/types.js').Fault} Fault
 * @typedef {import('../../core/types.js').MechanismDocument} MechanismDocument
 */
import { keyFramesOf } from '../../core/key-frames.js';
import { valueAt, withValueAt } from '../../core/path.js';

/** Optional numbers: where they are not given, nothing is wrong. */
const OPTIONAL = /\.(min|max|radius|metric_length|max_iterations|dimension_tolerance)$/;
/** Numbers of frames, Denavit–Hartenberg rows, start values and points: 0 is one of them. */
const NUMBER = /(\.(x|y|z|longitude|latitude|roll|alpha|a|theta|d)|\.(start|reference|metric_origin)\[\d+\])$/;
const TIME = /^motion\.key_frames\[(\d+)\]\.time$/;
/** What can be at fault by itself. */
const CELL = new RegExp(`${NUMBER.source}|${TIME.source}|\\.(min|max|name)$`);

/**
 * The faults from the first one on, as far as they can be told apart: what depends on several numbers is not judged by one
 * that was filled in.
 * @param {MechanismDocument} doc
 * @param {Fault} first
 * @param {(doc: MechanismDocument) => Promise<Fault | null>} check
 */
export async function allFaults(doc, first, check) {
  const faults = [first];
  /** @type {Fault | null} */
  let fault = first;
  let filled = doc;
  while (fault) {
    const next = fill(filled, fault.where);
    if (!next) break;
    filled = next;
    fault = await check(filled);
    if (!fault || !CELL.test(fault.where) || faults.some(({ where }) => where === fault?.where)) break;
    faults.push(fault);
  }
  return faults;
}

/** The document with a harmless value at a place; null where there is none. @param {MechanismDocument} doc @param {string} where */
function fill(doc, where) {
  // Whatever a parameter were, it may put others at fault.
  if (where.startsWith('parameters.')) return null;
  const key = TIME.exec(where)?.[1];
  if (key) return withValueAt(doc, where, timeBetween(keyFramesOf(doc), Number(key)));
  if (OPTIONAL.test(where)) return withValueAt(doc, where, undefined);
  if (NUMBER.test(where)) return valueAt(doc, where) === 0 ? null : withValueAt(doc, where, 0);
  return /name$/.test(where) ? withValueAt(doc, where, '') : null;
}

/** A time between those of the neighbours that have one. @param {import('../../core/types.js').KeyFrame[]} keys @param {number} index */
function timeBetween(keys, index) {
  const known = keys.flatMap(({ time }, at) => (typeof time === 'number' && at !== index ? [{ time, at }] : []));
  const before = known.filter(({ at }) => at < index).at(-1);
  const after = known.find(({ at }) => at > index);
  if (before && after) return before.time + ((after.time - before.time) * (index - before.at)) / (after.at - before.at);
  return before ? before.time + index - before.at : after ? after.time - after.at + index : index;
}

/**
 * By how much a number of the document changes in one step: a degree, a hundredth of the linkage's size, a whole number.
 *
 * @typedef {import('./types.js').MechanismDocument} MechanismDocument
 */
import { keyFramesOf } from './key-frames.js';
import { length, short } from './format.js';
import { chainVariables } from './joint-types.js';
import { valueAt } from './path.js';

const ANGLES = new Set(['alpha', 'theta', 'longitude', 'latitude', 'roll', 'roll_pitch_yaw']);
const LENGTHS = new Set(['a', 'd', 'x', 'y', 'z', 'radius', 'metric_length', 'reference', 'metric_origin', 'point']);
const WHOLE = new Set(['frames', 'max_iterations']);

/** About half a degree, where angles are in radians. */
const RADIANS = 0.01;

/** Of a linkage's size, of another number's own size. */
const SHARE = 1 / 100;

/** The power of ten at or below a number. @param {number} value */
const powerOfTen = (value) => Number((10 ** Math.floor(Math.log10(value))).toPrecision(1));

/** The largest length among the links, frames and key frames; 1 where there is none. @param {MechanismDocument} doc */
export function sizeOf(doc) {
  const { chains } = doc;
  /** @param {object | undefined} part @param {string[]} names */
  const numbers = (part, names) => names.map((name) => Math.abs(Number(/** @type {any} */ (part)?.[name]) || 0));
  const frames = [...chains.flatMap(({ base, gripper }) => [base, gripper]), ...keyFramesOf(doc)];
  const rows = chains.flatMap(({ joints }) => joints.flatMap(({ rows: own }) => own ?? []));
  const lengths = [...frames.flatMap((frame) => numbers(frame, ['x', 'y', 'z'])), ...rows.flatMap((row) => numbers(row, ['a', 'd']))];
  return lengths.reduce((most, length) => Math.max(most, length), 0) || 1;
}

/** What a start value, a limit or a driver's value is of: `theta` or `d`. @param {MechanismDocument} doc @param {string} path */
function variableAt(doc, path) {
  const start = /^chains\[(\d+)\]\.start\[(\d+)\]$/.exec(path);
  const limit = /^chains\[(\d+)\]\.joints\[(\d+)\]\.limits\[(\d+)\]/.exec(path);
  const driver = /^motion\.drivers\[(\d+)\]\.values\[\d+\]\.value$/.exec(path);
  if (driver) return drivenBy(doc, valueAt(doc, `motion.drivers[${driver[1]}]`));
  const [, chain, first, second] = start ?? limit ?? [];
  if (chain === undefined) return undefined;
  const all = chainVariables(valueAt(doc, `chains[${chain}]`));
  return start ? all[Number(first)]?.variable : all.find(({ joint, freedom }) => joint === Number(first) && freedom === Number(second))?.variable;
}

/** What a driver's values are of. @param {MechanismDocument} doc @param {import('./types.js').Driver} driver */
function drivenBy(doc, { chain, joint, freedom = 1 }) {
  const own = doc.chains[Number(chain) - 1];
  return own && chainVariables(own).find((one) => one.joint === Number(joint) - 1 && one.freedom === Number(freedom) - 1)?.variable;
}

/** @param {MechanismDocument} doc @param {string} path of a number */
const fieldOf = (doc, path) => variableAt(doc, path) ?? path.replace(/\[\d+\]$/, '').replace(/^.*\./, '');

/**
 * What a number of the document measures. What a parameter measures is not known: that depends on its uses.
 * @param {MechanismDocument} doc @param {string} path
 * @returns {'angle' | 'length' | 'time' | ''}
 */
export function kindOf(doc, path) {
  if (path.startsWith('parameters.')) return '';
  const name = fieldOf(doc, path);
  if (ANGLES.has(name)) return 'angle';
  if (LENGTHS.has(name)) return 'length';
  return name === 'time' ? 'time' : '';
}

/** A value as it is measured, with its unit: "303.1089 mm". @param {MechanismDocument} doc @param {string} path @param {number} value in the document's units */
export function measured(doc, path, value) {
  const kind = kindOf(doc, path);
  if (kind === 'length') return length(value, doc.length_unit);
  if (kind === 'angle') return doc.angles === 'radians' ? `${short(value)} rad` : `${short(value)}°`;
  return kind === 'time' ? `${short(value)} s` : short(value);
}

/**
 * @param {MechanismDocument} doc @param {string} path of a number @param {number} value what it is now
 * @param {MechanismDocument} [plain] the plain document that `doc` stands for, if that is another one
 */
export function stepOf(doc, path, value, plain = doc) {
  const kind = kindOf(doc, path);
  if (kind === 'angle') return doc.angles === 'radians' ? RADIANS : 1;
  if (kind === 'length') return powerOfTen(sizeOf(plain) * SHARE);
  if (!path.startsWith('parameters.') && WHOLE.has(fieldOf(doc, path))) return 1;
  // Seconds, shares: a digit of their own.
  return value === 0 ? SHARE : powerOfTen(Math.abs(value) * SHARE * 10);
}

/** A number some steps on, without the digits that adding has spoilt. @param {number} from @param {number} step @param {number} count */
export const stepped = (from, step, count) => Number((from + step * count).toPrecision(12));

/**
 * Edits of driven joints: what a new driver is like, and the way from key frames to drivers and back.
 *
 * @typedef {import('./types.js').MechanismDocument} MechanismDocument
 * @typedef {import('./types.js').Driver} Driver
 * @typedef {{chain: number, joint: number, freedom: number}} Place of a joint variable, counted from 0
 * @typedef {Place & {index: number, turns: boolean, name: string}} Drivable `index` among all variables; `name` such as "θ₁ of crank"
 * @typedef {Pick<import('./store.js').Store, 'doc' | 'result' | 'view'>} Shown
 * @typedef {Pick<import('./linkage.js').Parts, 'store' | 'say'>} Parts
 */
import { chainName } from './chain-name.js';
import { asWritten, frameAsWritten } from './document-angles.js';
import { driverIndex, hasDrivers } from './driven.js';
import { driverName } from './driven-words.js';
import { degrees, plural } from './format.js';
import { chainVariables, variableName } from './joint-types.js';
import { keyFramesOf } from './key-frames.js';
import { without } from './lists.js';
import { measured, sizeOf } from './number-steps.js';
import { withValueAt } from './path.js';
import { isTimed } from './playhead.js';
import { frameOf } from './frame-of.js';
import { POSE } from './poses.js';
import { groupAt, shown } from './shown.js';
import { plain } from './shown-frame.js';
import { sayUndo } from './undo.js';

/** How long a new driver takes, in seconds, where the motion has no times. */
const SECONDS = 5;

/** How far a new driver shifts a slider without limits to either side, as a share of the linkage's size. */
const SHIFT = 0.1;

/** Every joint variable that a driver may be given to. @param {MechanismDocument} doc @returns {Drivable[]} */
export function drivable(doc) {
  let index = 0;
  return doc.chains.flatMap((own, chain) =>
    chainVariables(own).map(({ variable, joint, freedom, row }) => ({
      chain, joint, freedom, index: index++, turns: variable === 'theta', name: `${variableName(variable, row)} of ${chainName(own, chain)}`,
    })),
  );
}

/** The first and the last time of the drivers, else of the motion that is shown. @param {Shown} store @returns {[number, number]} */
function timesOf({ doc, result: { motion, doc: planned } }) {
  const times = (doc.motion.drivers ?? []).flatMap(({ values }) => values.map(({ time }) => Number(time))).filter(Number.isFinite);
  if (times.length) return [Math.min(...times), Math.max(...times)];
  return motion && isTimed(planned) && motion.frames > 1 ? [motion.time[0], motion.time[motion.frames - 1]] : [0, SECONDS];
}

/** How large the linkage is: the box of the frames of its joints. @param {Shown} store */
function sizeShown({ doc, result: { motion } }) {
  const points = motion ? [...motion.rows.subarray(0, motion.rows.length / motion.frames)] : [];
  const extents = [0, 1, 2].map((axis) => {
    const own = points.filter((_, at) => at % POSE === axis);
    return Math.max(...own) - Math.min(...own);
  });
  const size = Math.hypot(...extents);
  return Number.isFinite(size) && size > 0 ? size : sizeOf(doc);
}

/**
 * From where to where a new driver goes: between the limits where there are two, else from the present value, a turn on or
 * some way to either side. Degrees or lengths.
 * @param {Shown} store @param {Drivable} variable @returns {[number, number]}
 */
export function freshRange(store, { chain, joint, freedom, index, turns }) {
  const { doc, result } = store;
  const now = shown(store);
  const joints = now && groupAt(now.joints, now);
  // Of a document with as many variables, or else of none.
  const value = joints?.length === drivable(doc).length ? joints[index] : 0;
  const limit = (result.plain ?? doc).chains[chain]?.joints[joint]?.limits?.[freedom];
  const [min, max] = [limit?.min, limit?.max].map((bound) => (typeof bound === 'number' ? bound : null));
  if (min !== null && max !== null) return [min, max];
  const at = plain(turns ? degrees(value) : value);
  if (turns) return [at, max === null ? at + 360 : at - 360];
  const shift = Number((SHIFT * sizeShown(store)).toPrecision(1));
  return [Math.max(at - shift, min ?? -Infinity), Math.min(at + shift, max ?? Infinity)];
}

/** @param {Shown} store @param {Drivable} variable @returns {Driver} */
export function freshDriver(store, variable) {
  const { doc } = store;
  const times = timesOf(store);
  const written = (/** @type {number} */ value) => plain(variable.turns ? asWritten(doc, value) : value);
  const values = freshRange(store, variable).map((value, i) => ({ time: times[i], value: written(value) }));
  return { chain: variable.chain + 1, joint: variable.joint + 1, freedom: variable.freedom + 1, values, ramp: 'linear' };
}

/** @param {MechanismDocument} doc @param {Driver[]} drivers @returns {MechanismDocument} */
export function withDrivers(doc, drivers) {
  const { key_frames: _, ...rest } = doc.motion;
  return { ...doc, motion: { ...rest, drivers } };
}

/** @param {MechanismDocument} doc @param {import('./types.js').KeyFrame[]} keys @returns {MechanismDocument} */
function withKeyFrames(doc, keys) {
  const { drivers: _, ...rest } = doc.motion;
  return { ...doc, motion: { ...rest, key_frames: keys } };
}

/**
 * One value more, equal to the last, as long after it as that is after the one before.
 * @param {MechanismDocument} doc @param {number} driver
 */
export function addValue(doc, driver) {
  const path = `motion.drivers[${driver}].values`;
  const values = doc.motion.drivers?.[driver].values ?? [];
  const [before, last] = [values.at(-2), values.at(-1)];
  const step = Number(last?.time) - Number(before?.time);
  return withValueAt(doc, path, [...values, { time: Number(last?.time) + (step > 0 ? step : 1) || values.length, value: last?.value ?? 0 }]);
}

/** @param {MechanismDocument} doc @param {number} driver @param {number} value */
export const removeValue = (doc, driver, value) =>
  withValueAt(doc, `motion.drivers[${driver}].values`, without(doc.motion.drivers?.[driver].values ?? [], value));

/** Once round, from its first value, in the driver's own time. @param {MechanismDocument} doc @param {number} driver */
export function fullTurn(doc, driver) {
  const values = doc.motion.drivers?.[driver].values ?? [];
  const [first, last] = [values[0], values[values.length - 1]];
  const from = typeof first.value === 'number' ? first.value : 0;
  return withValueAt(doc, `motion.drivers[${driver}].values`, [{ time: first.time, value: from }, { time: last.time, value: plain(from + asWritten(doc, 360)) }]);
}

/** The other kind of motion, by where the document came from: until another one is opened. @type {WeakMap<import('./types.js').Origin, Pick<import('./types.js').MotionSpec, 'key_frames' | 'drivers'>>} */
const kept = new WeakMap();

/** @param {import('./store.js').Store} store */
const keep = (store) => kept.set(store.origin, { ...kept.get(store.origin), ...(hasDrivers(store.doc) ? { drivers: store.doc.motion.drivers } : { key_frames: keyFramesOf(store.doc) }) });

/** What is kept of the other kind of motion, in words; empty where nothing is kept. @param {import('./store.js').Store} store */
export function keptWords(store) {
  const other = kept.get(store.origin);
  const [list, name] = hasDrivers(store.doc) ? [other?.key_frames, 'key frame'] : [other?.drivers, 'driven joint'];
  return list?.length ? `${plural(list.length, name)} ${list.length === 1 ? 'is' : 'are'} kept until another linkage is opened.` : '';
}

/** The motion by driven joints in place of key frames: those of before, else the first joint. @param {Parts} parts */
export function goToDrivers({ store, say }) {
  const { doc: former } = store;
  const [first] = drivable(former);
  if (hasDrivers(former) || !first) return;
  const drivers = kept.get(store.origin)?.drivers ?? [freshDriver(store, first)];
  keep(store);
  store.edit((doc) => withDrivers(doc, drivers));
  sayUndo({ store, say }, former, `Joints are driven. ${keptWords(store)}`.trim());
}

/** The motion by key frames in place of driven joints: those of before, else poses of the motion that is shown. @param {Parts} parts */
export function goToKeyFrames({ store, say }) {
  const { doc: former } = store;
  if (!hasDrivers(former)) return;
  const before = kept.get(store.origin)?.key_frames;
  const keys = before?.length ? before : posesShown(store);
  keep(store);
  store.edit((doc) => withKeyFrames(doc, keys));
  sayUndo({ store, say }, former, `The motion has key frames. ${keptWords(store)}`.trim());
}

/** First, middle and last pose of the motion, as key frames. @param {Shown} store @returns {import('./types.js').KeyFrame[]} */
function posesShown({ doc, result: { motion } }) {
  if (!motion) return [{ name: 'start' }, { name: 'end' }];
  const last = motion.frames - 1;
  /** @type {import('./types.js').Frame | undefined} */
  let near;
  return [['start', 0], ['middle', Math.round(last / 2)], ['end', last]].map(([name, frame]) => {
    const found = frameOf(motion.pose.subarray(POSE * Number(frame), POSE * (Number(frame) + 1)), near);
    near = found;
    return { name: String(name), ...frameAsWritten(doc, Object.fromEntries(Object.entries(found).map(([key, value]) => [key, plain(value)]))) };
  });
}

/** One joint more is driven, or the first one in place of key frames. @param {Parts} parts @param {Place} place */
export function driveJoint({ store, say }, place) {
  const { doc: former } = store;
  const variable = drivable(former).find(({ chain, joint, freedom }) => chain === place.chain && joint === place.joint && freedom === place.freedom);
  if (!variable || driverIndex(former, place) >= 0) return;
  const fresh = freshDriver(store, variable);
  const others = former.motion.drivers ?? [];
  if (!hasDrivers(former)) keep(store);
  store.edit((doc) => withDrivers(doc, [...others, fresh]));
  const [from, to] = fresh.values.map(({ value }) => measured(store.doc, `motion.drivers[${others.length}].values[0].value`, Number(value)));
  sayUndo({ store, say }, former, `${driverName(store.doc, fresh)} is driven from ${from} to ${to}: see Motion. ${others.length ? '' : keptWords(store)}`.trim());
}


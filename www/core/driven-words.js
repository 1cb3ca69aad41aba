/**
 * What is said of a motion with driven joints, and the lines of its charts: where the joints stand, and what stops them.
 *
 * @typedef {import('./types.js').Motion} Motion
 * @typedef {import('./types.js').MechanismDocument} MechanismDocument
 */
import { chainName } from './chain-name.js';
import { angle, degrees, length, plural } from './format.js';
import { chainVariables, variableName } from './joint-types.js';
import { POSE } from './poses.js';

/** At most so many driven joints are told of in one sentence. */
const TOLD = 3;

/** How a frame ended. @type {Record<string, string>} */
const MEANINGS = {
  reached: 'Every driven joint has its value, and every loop is closed.',
  at_limit: 'A joint limit keeps the driven joints from their values: the linkage waits as near as it comes.',
  stalled: 'The driven joints cannot have their values here: the linkage waits as near as it comes.',
  closure_lost: 'The loops could not be closed here. Do not trust this frame.',
};

/** @param {string} status */
export const statusMeaning = (status) => MEANINGS[status] ?? '';

/** The driven variables with their chains, in the order of the drivers. @param {Motion} motion */
function drivenVariables({ report }) {
  const all = report.chains.flatMap(({ variables }, chain) => variables.map(({ unit, row }) => ({ unit, chain, name: variableName(unit === 'rad' ? 'theta' : 'd', row) })));
  return (report.drivers ?? []).map((index) => ({ index, ...all[index] }));
}

/** What a driver drives: "θ₁ of crank"; what there is not is at fault, and is called by its number. @param {MechanismDocument} doc @param {import('./types.js').Driver} driver */
export function driverName(doc, { chain, joint, freedom = 1 }) {
  const at = Number(chain) - 1;
  const found = doc.chains[at] && chainVariables(doc.chains[at]).find((one) => one.joint === Number(joint) - 1 && one.freedom === Number(freedom) - 1);
  return found ? `${variableName(found.variable, found.row)} of ${chainName(doc.chains[at], at)}` : `joint ${joint} of chain ${chain}`;
}

/** Where the driven joints stand: "θ₁ of crank at 120°". @param {Motion} motion @param {MechanismDocument | null} doc @param {number} frame */
export function drivenWords(motion, doc, frame) {
  const width = motion.joints.length / motion.frames;
  const driven = drivenVariables(motion);
  const some = driven.slice(0, TOLD).map(({ index, name, unit, chain }) => {
    const value = motion.joints[frame * width + index];
    return `${name} of ${chainName(doc?.chains[chain], chain)} at ${unit === 'rad' ? angle(value) : length(value, doc?.length_unit)}`;
  });
  const more = driven.length - some.length;
  return [...some, ...(more > 0 ? [plural(more, 'more driven joint')] : [])].join(', ');
}

/**
 * Why the driven joints do not have their values at a frame, and where a way was chosen: Rust's words.
 * @param {Motion} motion @param {number} frame
 */
export function driveReasons(motion, frame) {
  const { warnings } = motion.report;
  const here = warnings.filter(({ first, last }) => first !== undefined && first <= frame && frame <= (last ?? first));
  const ends = here.filter(({ code }) => code === 'drive-ends');
  const short = motion.report.statuses[motion.status[frame]] !== 'reached';
  const why = ends.length || !short ? ends : warnings.filter(({ code }) => code === 'driver-dependent');
  return [...why, ...here.filter(({ code }) => code === 'branch-chosen')].map(({ message }) => message);
}

/** The driven joints' values, in degrees or lengths. @param {Motion} motion */
export function drivenSeries(motion) {
  const width = motion.joints.length / motion.frames;
  return drivenVariables(motion).map(({ index, name, unit, chain }) => ({
    name: `${chainName(motion.report.chains[chain], chain)} ${name}`,
    unit,
    values: Float64Array.from({ length: motion.frames }, (_, frame) => (unit === 'rad' ? degrees : Number)(motion.joints[frame * width + index])),
  }));
}

/** The way of the workpiece's origin, in the fixed frame. @param {Motion} motion */
export const pathSeries = ({ pose, frames }) =>
  ['x', 'y', 'z'].map((name, axis) => ({ name, values: Float64Array.from({ length: frames }, (_, frame) => pose[frame * POSE + axis]) }));

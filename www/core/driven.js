/**
 * Motions whose joints are driven: which, and where they stand. There is no goal then, and no distance from one.
 *
 * @typedef {import('./types.js').Motion} Motion
 * @typedef {import('./types.js').MechanismDocument} MechanismDocument
 */
import { chainName } from './chain-name.js';
import { angle, length, plural } from './format.js';
import { chainVariables, variableName } from './joint-types.js';

/** At most so many driven joints are told of in one sentence. */
const TOLD = 3;

/** Whether joints are driven in a motion. @param {Motion | null} motion */
export const drivesJoints = (motion) => (motion?.report?.drivers?.length ?? 0) > 0;

/** Whether a document drives joints. @param {MechanismDocument | null} doc */
export const hasDrivers = (doc) => (doc?.motion.drivers?.length ?? 0) > 0;

/** The driven variables with their chains, in the order of the drivers. @param {Motion} motion */
export function drivenVariables({ report }) {
  const all = report.chains.flatMap(({ variables }, chain) => variables.map((variable) => ({ ...variable, chain })));
  return (report.drivers ?? []).map((index) => ({ index, ...all[index] }));
}

/** A variable's label with its number below: θ₁. @param {string} label */
export const subscript = (label) => label.replace(/\d/g, (digit) => '₀₁₂₃₄₅₆₇₈₉'[Number(digit)]);

/** Which driver drives a variable, all counted from 0; −1 for none. @param {MechanismDocument} doc @param {{chain: number, joint: number, freedom: number}} variable */
export const driverIndex = ({ motion: { drivers = [] } }, { chain, joint, freedom }) =>
  drivers.findIndex((one) => Number(one.chain) === chain + 1 && Number(one.joint) === joint + 1 && Number(one.freedom ?? 1) === freedom + 1);

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
  const told = driven.slice(0, TOLD).map(({ index, label, unit, chain }) => {
    const value = motion.joints[frame * width + index];
    const name = `${subscript(label)} of ${chainName(doc?.chains[chain], chain)}`;
    return `${name} at ${unit === 'rad' ? angle(value) : length(value, doc?.length_unit)}`;
  });
  const more = driven.length - told.length;
  return [...told, ...(more > 0 ? [`${plural(more, 'more driven joint')}`] : [])].join(', ');
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

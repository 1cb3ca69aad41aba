/**
 * Why the workpiece does not come closer, in words. Knows no DOM, and no bound of its own: values and bounds are Rust's.
 *
 * @typedef {import('../../core/types.js').Insight} Insight
 * @typedef {import('../../core/types.js').Motion} Motion
 * @typedef {import('../../core/types.js').MechanismDocument} MechanismDocument
 */
import { degrees, length, plural, scientific, short } from '../../core/format.js';
import { capital, chainName } from '../../core/chain-name.js';
import { percentages } from '../../core/percentages.js';
import { UNTOLD, direction, exactAngle, exactLength } from '../../core/freedom-words.js';

/** The part of a wrench, as a share of the other part, up to which the other part alone says what it forbids. */
const MOSTLY = 0.05;

/** @param {ArrayLike<number>} v */
const norm = (v) => Math.hypot(...Array.from(v));

/** The pair of a twist or wrench. @param {number[]} pair */
const halves = (pair) => [pair.slice(0, 3), pair.slice(3)];

/** A small motion: "a shift of 0.1 m along (0, 0, 1) and a turn of 2° about (1, 0, 0)". @param {number[]} twist @param {string} [unit] */
export function twistInWords(twist, unit) {
  const [v, w] = halves(twist);
  const said = [];
  if (norm(v) > 0) said.push(`a shift of ${exactLength(norm(v), unit)} along ${direction(v)}`);
  if (norm(w) > 0) said.push(`a turn of ${exactAngle(norm(w))} about ${direction(w)}`);
  return said.join(' and ') || 'nothing';
}

/** What a chain withstands. @param {number[]} wrench @param {number} metricLength weighs moments against forces */
export function wrenchInWords(wrench, metricLength) {
  const [force, moment] = halves(wrench);
  const [f, m] = [norm(force), norm(moment) / metricLength];
  const said = [];
  if (f > UNTOLD * m) said.push(`a force along ${direction(force)}`);
  if (m > UNTOLD * f) said.push(`a moment about ${direction(moment)}`);
  return said.join(' and ') || 'nothing';
}

/** What the wrench forbids. @param {number[]} wrench @param {number} metricLength */
function forbidden(wrench, metricLength) {
  const [force, moment] = halves(wrench);
  const [f, m] = [norm(force), norm(moment) / metricLength];
  if (m <= MOSTLY * f) return `no shift along ${direction(force)}`;
  if (f <= MOSTLY * m) return `no turn about ${direction(moment)}`;
  return `no motion that gives way to ${wrenchInWords(wrench, metricLength)}`;
}

/**
 * Whether the pose is a closest one, and how that is known. Which it is, is the status, which is Rust's; the numbers stand beside
 * their bounds in the table of the frame.
 * @param {Insight} insight @param {string} status
 * @param {{closure: number, misfit: number}} end how far the loops are open
 * @param {Pick<Motion['report']['bounds'], 'closure' | 'misfit'>} bounds
 */
export function certificate({ projected_gradient: slope, stationary, least_curvature: curvature, flat }, status, end, bounds) {
  const falls = !(slope <= stationary);
  if (status === 'passing' && end.closure <= bounds.closure) return 'On the way, with closed loops: it is not meant to be the closest pose.';
  if (status === 'closest' || status === 'at_limit') {
    if (falls) return `Certified closest by the gradient method’s bound. Newton’s method would go on: in its measure the slope is ${scientific(slope)}, and it stops at ${scientific(stationary)}.`;
    if (curvature === null) return 'Certified closest: no direction is free, so no small motion of the linkage comes nearer.';
    return 'Certified closest: no small motion of the linkage comes nearer.';
  }
  if (end.closure > bounds.closure) return `Not certified: the loops are open by ${scientific(end.closure)}, and closed up to ${scientific(bounds.closure)}.`;
  if (end.misfit > bounds.misfit) return 'Not certified: the dimensions contradict each other by more than their tolerance.';
  if (falls) return 'Not certified: the distance still falls in a free direction.';
  if (curvature !== null && curvature < -flat) return 'Not certified: a direction without slope in which the distance curves downwards.';
  return 'Not certified by the planner, though slope and curvature are within their bounds here.';
}

/**
 * Joint variables that the goal's pull presses against a limit.
 * @param {Insight['held']} held @param {MechanismDocument} doc @param {Motion['report']} report @param {ArrayLike<number>} joints rad or lengths
 * @returns {string[]}
 */
export function atLimits(held, doc, report, joints) {
  const variables = report.chains.flatMap(({ variables: own }, chain) => own.map((variable) => ({ ...variable, chain })));
  return held.map(({ variable, largest }) => {
    const { label, unit, chain } = variables[variable];
    const value = unit === 'rad' ? `${short(degrees(joints[variable]), 2)}°` : length(joints[variable], doc.length_unit);
    return `${label} of ${chainName(doc.chains[chain], chain)} is at its ${largest ? 'largest' : 'smallest'} value, ${value}.`;
  });
}

/**
 * The chain that holds the workpiece back most, in a sentence; '' where nothing is held back.
 * @param {Insight} insight @param {MechanismDocument} doc @param {number} metricLength weighs moments against forces
 */
export function mostHolding(insight, doc, metricLength) {
  const shares = percentages(insight.chains.map(({ share }) => share));
  const most = shares.indexOf(Math.max(...shares));
  if (!(shares[most] > 0)) return '';
  const { wrench } = insight.chains[most];
  const name = chainName(doc.chains[most], most);
  const equal = shares.filter((share) => share >= shares[most] - 1).length;
  const head =
    shares.length === 1
      ? `The linkage’s one chain, ${name}, holds it back`
      : equal > 1
        ? `${plural(equal, 'chain')} hold it back alike, ${name} among them (${shares[most]} %)`
        : `${capital(name)} holds it back most (${shares[most]} %)`;
  return `${head}: it allows ${forbidden(wrench, metricLength)}.`;
}

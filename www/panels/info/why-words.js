/**
 * Why the workpiece does not come closer, in words. Knows no DOM.
 *
 * @typedef {import('../../core/types.js').Insight} Insight
 * @typedef {import('../../core/types.js').Motion} Motion
 * @typedef {import('../../core/types.js').MechanismDocument} MechanismDocument
 */
import { angle, atMost, degrees, length, plural, scientific, short } from '../../core/format.js';

/** Parts of a direction, and of a twist or wrench, that are too small to be told. */
const ROUNDING = 0.005;
const NOTHING = 1e-9;

/** @param {ArrayLike<number>} v */
const norm = (v) => Math.hypot(...Array.from(v));

/** A direction: (0.2, 0, 1), its largest component 1 or −1. @param {ArrayLike<number>} v */
export function direction(v) {
  const largest = Math.max(...Array.from(v, Math.abs));
  return `(${Array.from(v, (x) => short(Math.abs(x / largest) < ROUNDING ? 0 : x / largest, 2)).join(', ')})`;
}

/** @param {ArrayLike<number>} point */
const place = (point) => `(${Array.from(point, (x) => short(x, 3)).join(', ')})`;

/** The pair of a twist or wrench. @param {number[]} pair */
const halves = (pair) => [pair.slice(0, 3), pair.slice(3)];

/** A small motion: "shift by 0.1 m along (0, 0, 1) and turn by 2° about (1, 0, 0)". @param {number[]} twist @param {string} [unit] */
export function twistInWords(twist, unit) {
  const [v, w] = halves(twist);
  const said = [];
  if (norm(v) > NOTHING) said.push(`a shift of ${norm(v) < 1e-4 ? scientific(norm(v)) : length(norm(v), unit)} along ${direction(v)}`);
  if (norm(w) > NOTHING) said.push(`a turn of ${degrees(norm(w)) < 0.01 ? `${scientific(degrees(norm(w)))}°` : angle(norm(w))} about ${direction(w)}`);
  return said.join(' and ') || 'nothing';
}

/** What a chain withstands. @param {number[]} wrench @param {number} metricLength weighs moments against forces */
export function wrenchInWords(wrench, metricLength) {
  const [force, moment] = halves(wrench);
  const [f, m] = [norm(force), norm(moment) / metricLength];
  const said = [];
  if (f > ROUNDING * m) said.push(`a force along ${direction(force)}`);
  if (m > ROUNDING * f) said.push(`a moment about ${direction(moment)}`);
  return said.join(' and ') || 'nothing';
}

/** What the wrench forbids. @param {number[]} wrench @param {number} metricLength */
function forbidden(wrench, metricLength) {
  const [force, moment] = halves(wrench);
  const [f, m] = [norm(force), norm(moment) / metricLength];
  if (m <= 0.05 * f) return `no shift along ${direction(force)}`;
  if (f <= 0.05 * m) return `no turn about ${direction(moment)}`;
  return `no motion that gives way to ${wrenchInWords(wrench, metricLength)}`;
}

/** A freedom. @param {Insight['freedoms'][number]} screw @param {string} [unit] */
export function freedomInWords({ point, direction: along, pitch }, unit) {
  if (pitch === null) return `Shift along ${direction(along)}`;
  const axis = `about the axis through ${place(point)} along ${direction(along)}`;
  if (Math.abs(pitch) < 1e-6) return `Turn ${axis}`;
  return `Screw ${axis}, ${length(Math.abs(pitch) * 2 * Math.PI, unit)} a turn${pitch < 0 ? ', left-handed' : ''}`;
}

/** Shares as whole percent that sum to 100; all 0 where nothing is held back. @param {number[]} shares 0 to 1 */
export function percentages(shares) {
  if (shares.reduce((sum, share) => sum + share, 0) < 0.5) return shares.map(() => 0);
  const exact = shares.map((share) => share * 100);
  const whole = exact.map(Math.floor);
  const order = exact.map((_, i) => i).sort((a, b) => exact[b] - whole[b] - (exact[a] - whole[a]));
  let missing = 100 - whole.reduce((sum, x) => sum + x, 0);
  for (const i of order) if (missing-- > 0) whole[i] += 1;
  return whole;
}

/**
 * Whether the pose is a closest one, and how that is known: every number with the bound that it is held against.
 * @param {Insight} insight @param {string} status
 * @param {Pick<Motion['report']['bounds'], 'projected_gradient'>} bounds of the motion, whose method may have one of its own
 */
export function certificate({ projected_gradient: slope, stationary, least_curvature: curvature, flat }, status, bounds) {
  const curved = curvature === null ? '' : `; least curvature ${scientific(curvature)}, at least ${scientific(-flat)}`;
  const numbers = (/** @type {number} */ bound) => `projected gradient ${atMost(slope, bound)}${curved}`;
  if (!(slope <= stationary)) {
    if (status === 'closest' || status === 'at_limit') return `Closest within the bound of the gradient method (${numbers(bounds.projected_gradient)}); Newton’s method stops at ${scientific(stationary)}.`;
    return `Not certified: the distance still falls in a free direction (${numbers(stationary)}).`;
  }
  if (curvature === null) return `Certified closest: no direction is free, so no small motion of the linkage comes nearer (${numbers(stationary)}).`;
  if (curvature < -flat) return `Not certified: a direction without slope in which the distance curves downwards (${numbers(stationary)}).`;
  return `Certified closest: no small motion of the linkage comes nearer (${numbers(stationary)}).`;
}

/** What a chain is called. @param {MechanismDocument} doc @param {number} index */
export const chainName = (doc, index) => doc.chains[index]?.name || `chain ${index + 1}`;

/**
 * Joint variables that stand at a limit.
 * @param {MechanismDocument} doc @param {Motion['report']} report @param {ArrayLike<number>} joints rad or lengths
 * @returns {{chain: number, joint: number, text: string}[]}
 */
export function atLimits(doc, report, joints) {
  /** @type {{chain: number, joint: number, text: string}[]} */
  const found = [];
  let k = 0;
  report.chains.forEach(({ variables }, chain) => {
    variables.forEach(({ label, unit, joint }, i) => {
      const value = unit === 'rad' ? degrees(joints[k]) : joints[k];
      k += 1;
      const first = variables.findIndex((other) => other.joint === joint);
      const limit = doc.chains[chain]?.joints[joint]?.limits?.[i - first];
      for (const [bound, word] of [[limit?.min, 'smallest'], [limit?.max, 'largest']]) {
        if (bound == null || bound === '' || Math.abs(value - Number(bound)) > 1e-6 * Math.max(1, Math.abs(value))) continue;
        const shown = unit === 'rad' ? `${short(value, 2)}°` : length(value, doc.length_unit);
        found.push({ chain, joint, text: `${label} of ${chainName(doc, chain)} is at its ${word} value, ${shown}.` });
      }
    });
  });
  return found;
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
  const name = chainName(doc, most);
  const equal = shares.filter((share) => share >= shares[most] - 1).length;
  const head =
    shares.length === 1
      ? `The linkage’s one chain, ${name}, holds it back`
      : equal > 1
        ? `${plural(equal, 'chain')} hold it back alike, ${name} among them (${shares[most]} %)`
        : `${name[0].toUpperCase()}${name.slice(1)} holds it back most (${shares[most]} %)`;
  return `${head}: it allows ${forbidden(wrench, metricLength)}.`;
}

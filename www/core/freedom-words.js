/**
 * A freedom, and any other small motion, in words: the one place for tooltips, handles and the info panel. Which freedom is
 * a shift, a turn or a screw is what Rust says: it sets the pitch to null or 0.
 *
 * @typedef {import('./types.js').Insight['freedoms'][number]} Screw
 */
import { angle, degrees, length, scientific, short } from './format.js';

/** A component of a direction, as a share of the largest, that is not told; a part of a wrench, as a share of the other part, that is not. */
export const UNTOLD = 0.005;
/** Below this a length or an angle in degrees is written in powers of ten, so that it is not rounded to nothing. */
const TINY = 1e-3;

/** A direction: (0.2, 0, 1), its largest component 1 or −1. @param {ArrayLike<number>} v */
export function direction(v) {
  const largest = Math.max(...Array.from(v, Math.abs));
  return `(${Array.from(v, (x) => short(Math.abs(x / largest) < UNTOLD ? 0 : x / largest, 2)).join(', ')})`;
}

/** @param {ArrayLike<number>} point */
const place = (point) => `(${Array.from(point, (x) => short(x, 3)).join(', ')})`;

/** A length that is not rounded to nothing. @param {number} value @param {string | undefined} unit */
export const exactLength = (value, unit) => (value !== 0 && Math.abs(value) < TINY ? `${scientific(value)}${unit ? ` ${unit}` : ''}` : length(value, unit));

/** An angle that is not rounded to nothing. @param {number} radians */
export const exactAngle = (radians) => (radians !== 0 && Math.abs(degrees(radians)) < TINY ? `${scientific(degrees(radians))}°` : angle(radians, 3));

/**
 * `short` is its kind, `whole` says where it is.
 * @param {Screw} screw @param {string | undefined} unit
 * @returns {{short: 'shift' | 'turn' | 'screw', whole: string}}
 */
export function freedomInWords({ pitch, point, direction: along }, unit) {
  if (pitch === null) return { short: 'shift', whole: `shift along ${direction(along)}` };
  const axis = `about the axis through ${place(point)} along ${direction(along)}`;
  if (pitch === 0) return { short: 'turn', whole: `turn ${axis}` };
  const lead = exactLength(Math.abs(pitch) * 2 * Math.PI, unit);
  return { short: 'screw', whole: `screw ${axis}, ${lead} a turn${pitch < 0 ? ', left-handed' : ''}` };
}

/**
 * Freedoms of the workpiece in words.
 */
import { lengthUnit, short } from '../../core/format.js';

/** @param {number[]} vector */
const triple = (vector) => `(${vector.map((value) => short(value, 2)).join(', ')})`;

/**
 * @param {import('../../core/types.js').Insight['freedoms'][number]} screw
 * @param {string | undefined} unit
 * @returns {{short: string, whole: string}}
 */
export function freedomWords({ pitch, point, direction }, unit) {
  const along = triple(direction);
  if (pitch === null) return { short: 'shift', whole: `shift along ${along}` };
  const axis = `about ${along} through ${triple(point)}`;
  if (Math.abs(pitch) < 5e-4) return { short: 'turn', whole: `turn ${axis}` };
  return { short: 'screw', whole: `screw ${axis}, pitch ${short(pitch, 3)} ${lengthUnit(unit)} per rad` };
}

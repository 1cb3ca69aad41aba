/**
 * Round steps and round numbers for moving by hand.
 */

/** One turn's step in degrees. */
export const ANGLE_STEP = 15;

/** A step's share of the scene's radius. */
const SHARE = 1 / 20;

/** The nearest of 1, 2, 5 · 10ⁿ to a twentieth of the scene. @param {number} size */
export function lengthStep(size) {
  const wanted = size * SHARE;
  const power = 10 ** Math.floor(Math.log10(wanted));
  const digit = [1, 2, 5, 10].reduce((best, next) => (Math.abs(Math.log(next * power / wanted)) < Math.abs(Math.log(best * power / wanted)) ? next : best));
  // As text, so that 3 · 0.1 is 0.3.
  return Number((digit * power).toPrecision(1));
}

/** Digits behind the point that a hand can tell apart: a millionth of the scene. @param {number} size */
export const lengthDigits = (size) => Math.min(15, Math.max(0, Math.ceil(6 - Math.log10(size))));

/** Digits of an angle in degrees. */
export const ANGLE_DIGITS = 4;

/** @param {number} value @param {number} digits behind the point */
export const rounded = (value, digits) => Number(value.toFixed(digits)) || 0;

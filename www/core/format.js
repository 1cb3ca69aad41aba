/**
 * Numbers as text: short where they are shown, whole where they are edited.
 */

/** Decimals of a number that is shown but not edited, and of one in degrees. */
const DECIMALS = 4;
export const ANGLE_DECIMALS = 2;

/** @param {number} value @param {number} [decimals] */
export function short(value, decimals = DECIMALS) {
  if (!Number.isFinite(value)) return '–';
  const text = value.toFixed(decimals);
  const trimmed = text.includes('.') ? text.replace(/\.?0+$/, '') : text;
  return (trimmed === '-0' ? '0' : trimmed).replace('-', '−');
}

/** A small or large number in powers of ten: 3.2 · 10⁻¹². @param {number} value */
export function scientific(value) {
  if (!Number.isFinite(value)) return '–';
  if (value === 0) return '0';
  const magnitude = Math.abs(value);
  if (magnitude >= 0.01 && magnitude < 10000) return short(value);
  return value.toExponential(1).replace('e+', 'e').replaceAll('-', '−');
}

/** A number beside the bound that it is held against: "3.1e−12, at most 2.5e−10". @param {number} value @param {number} bound */
export const atMost = (value, bound) => `${scientific(value)}, at most ${scientific(bound)}`;

/** @param {number} radians */
export const degrees = (radians) => (radians * 180) / Math.PI;

/** How the document's angles are labelled: their sign and their name. @param {{angles?: string}} doc */
export const angleUnit = ({ angles }) => (angles === 'radians' ? { sign: 'rad', name: 'radians', decimals: 4 } : { sign: '°', name: 'degrees', decimals: ANGLE_DECIMALS });

/** @param {string | undefined} unit the document's unit of length, "" if it names none */
export const lengthUnit = (unit) => unit || 'length';

/** @param {number} value @param {string | undefined} unit */
export const length = (value, unit) => (unit ? `${short(value)} ${unit}` : short(value));

/** @param {number} radians @param {number} [decimals] */
export const angle = (radians, decimals = ANGLE_DECIMALS) => `${short(degrees(radians), decimals)}°`;

/** With a capital at the beginning and a stop at the end. @param {string} text */
export const sentence = (text) => text.replace(/^[a-z]/, (letter) => letter.toUpperCase()) + (/[.!?]$/.test(text) ? '' : '.');

/** @param {number} count @param {string} one @param {string} [many] */
export const plural = (count, one, many = `${one}s`) => `${count} ${count === 1 ? one : many}`;

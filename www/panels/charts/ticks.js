/**
 * Which ticks of a scale are labelled, and how, so that labels neither overlap nor repeat. Knows no DOM.
 */
import { scientific, short } from '../../core/format.js';

/** Least distance between the labels of a scale, in pixels. */
const LABELS_APART = 16;

/**
 * Which ticks of a logarithmic scale are labelled, null for the others: every power of ten or every n-th where that is all there is
 * room for, else also 2 and 5, else all.
 * @param {number[]} splits 1 to 9 times powers of ten @param {number} decades of the scale @param {number} height in pixels
 * @returns {(number | null)[]}
 */
export function logTicks(splits, decades, height) {
  const decade = height / decades;
  const every = Math.ceil(LABELS_APART / decade);
  // The closest neighbours are 5 and 10 of 1, 2, 5, and 9 and 10 of all.
  const mantissas = decade * Math.log10(10 / 9) >= LABELS_APART ? [1, 2, 3, 4, 5, 6, 7, 8, 9] : decade * Math.log10(2) >= LABELS_APART ? [1, 2, 5] : [1];
  return splits.map((value) => {
    const power = Math.floor(Math.log10(value) + 1e-9);
    return mantissas.includes(Math.round(value / 10 ** power)) && power % every === 0 ? value : null;
  });
}

/** A value of a linear scale with as many digits as tell it from its neighbour. @param {number} value @param {number} step between ticks */
export function tickText(value, step) {
  if (value === 0 || !(step > 0)) return short(value);
  return step < 1e-4 ? scientific(value) : short(value, Math.min(6, Math.max(0, Math.ceil(-Math.log10(step) - 1e-9) + 1)));
}

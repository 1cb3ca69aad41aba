/**
 * How far the slider of each parameter goes: twice its value when it is first seen, and further where more has been typed.
 *
 * @typedef {{low: number, high: number}} Range
 */

/** Steps of a slider, about so many. */
const STEPS = 400;

/** From 0 to twice the value, which may be negative; −1 to 1 about 0. @param {number} value @returns {Range} */
export function rangeAround(value) {
  if (value === 0) return { low: -1, high: 1 };
  return value > 0 ? { low: 0, high: 2 * value } : { low: 2 * value, high: 0 };
}

export function createRanges() {
  /** @type {Map<string, Range>} */
  const ranges = new Map();
  /** @type {unknown} */
  let origin = null;
  return {
    /**
     * @param {unknown} from where the document comes from: another one has other ranges
     * @param {string} name @param {number} value
     */
    of(from, name, value) {
      if (from !== origin) ranges.clear();
      origin = from;
      const { low, high } = ranges.get(name) ?? rangeAround(value);
      const more = value < low || value > high ? rangeAround(value) : { low, high };
      const range = { low: Math.min(low, more.low), high: Math.max(high, more.high) };
      ranges.set(name, range);
      const step = 10 ** Math.floor(Math.log10((range.high - range.low) / STEPS));
      return { ...range, step: Number(step.toPrecision(1)) };
    },
    /** @param {string} old @param {string} fresh */
    rename(old, fresh) {
      const range = ranges.get(old);
      if (range) ranges.set(fresh, range);
    },
  };
}

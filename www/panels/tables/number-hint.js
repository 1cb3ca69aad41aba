/**
 * How to write what was meant as a number and is none: with a point, without its unit.
 */

const NUMBER = /^([+\-−–]?)\s*(\d*)([.,]?)(\d*)(e[+-]?\d+)?\s*(\D*)$/i;

/**
 * @param {string} text as it was typed
 * @returns {string} a sentence, '' where it cannot be told what was meant
 */
export function numberHint(text) {
  const [, sign, whole, mark, rest, power = '', unit] = NUMBER.exec(text.trim()) ?? [];
  if (!whole && !rest) return '';
  const number = `${sign && sign !== '+' ? '-' : ''}${whole || '0'}${rest ? `.${rest}` : ''}${power}`;
  // A number that JSON cannot hold is written well, and too large.
  if (!Number.isFinite(Number(number))) return '';
  if (mark === ',') return `Write ${unit ? 'the number alone, with a point' : 'a point'}: ${number}.`;
  return unit ? `Write the number alone: ${number}.` : '';
}

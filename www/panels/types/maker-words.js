/**
 * The makers as the page lists and asks them: found by their names, their inputs as fields, what was typed as inputs. No DOM.
 *
 * @typedef {import('../../core/types.js').Maker} Maker
 * @typedef {Maker['inputs'][number]} MakerInput
 */
import { factorBetween } from '../../core/units.js';
import { sizeOf } from './size-of.js';

/** Units of length that makers know. */
export const UNITS = ['mm', 'cm', 'm', 'µm', 'in'];

/** Letters and digits: capitals, blanks and dashes do not matter. @param {string} text */
const key = (text) => text.toLowerCase().replace(/[^\p{L}\p{N}]/gu, '');

/** Those with a name or title that holds what is typed; those that begin with it come first. @param {Maker[]} makers @param {string} typed */
export function found(makers, typed) {
  const wanted = key(typed);
  const names = (/** @type {Maker} */ { name, also, title }) => [name, ...also, title].map(key);
  const holding = makers.filter((maker) => names(maker).some((name) => name.includes(wanted)));
  const begins = (/** @type {Maker} */ maker) => names(maker).some((name) => name.startsWith(wanted));
  return [...holding.filter(begins), ...holding.filter((maker) => !begins(maker))];
}

/** The texts of an input's fields with its defaults: one for each part; a list is one field. @param {Maker} maker @param {MakerInput} input @param {string} unit */
export function defaultTexts(maker, input, unit) {
  if (input.is === 'list') return [input.value.join(', ')];
  const factor = input.is === 'length' ? (factorBetween(maker.unit, unit) ?? 1) : 1;
  return input.value.map((value) => String(Number((value * factor).toPrecision(12))));
}

/** The labels of an input's fields. @param {MakerInput} input */
export const labelsOf = ({ name, parts, is }) => (is === 'list' || !parts.length ? [name] : parts);

/** What an input measures, with its unit. @param {MakerInput} input @param {string} unit */
export function meaningOf({ meaning, is }, unit) {
  const measured = { length: `, in ${unit}`, angle: ', in degrees', number: '', count: '', list: ', with commas between them' }[is];
  return `${meaning[0].toUpperCase()}${meaning.slice(1)}${measured}.`;
}

/**
 * What is asked of a maker: the inputs that differ from their defaults, so that these stay exact in any unit.
 * @param {Maker} maker @param {Map<string, string[]>} typed the texts of each input's fields @param {string} unit
 * @returns {Record<string, string>}
 */
export function givenInputs(maker, typed, unit) {
  const given = maker.inputs.flatMap((input) => {
    const texts = typed.get(input.name) ?? [];
    const standard = defaultTexts(maker, input, unit);
    if (texts.every((text, index) => text.trim() === standard[index])) return [];
    // In a field for one number a comma is a decimal one.
    const numbers = input.is === 'list' ? texts : texts.map((text) => String(sizeOf(text) ?? ''));
    return [[input.name, numbers.join(',')]];
  });
  return Object.fromEntries(given);
}

/**
 * The attributes of <synthetica-linkage>: the one list of them, what may stand in each, and how it is written. No DOM.
 *
 * From it come the attributes that are observed, the properties of the same names, and with the sentences of descriptions.js
 * the types, the package's manifest of elements and the tables of the reference.
 *
 * @typedef {import('../core/playhead.js').Loop} Loop
 * @typedef {keyof typeof ATTRIBUTES} Name
 */
/**
 * @template V
 * @typedef {object} Attribute
 * @property {(text: string | null) => V} read what it means; the default for null, one that is absent; what is no such thing is refused in words
 * @property {(value: V) => string | null} write null for no attribute
 * @property {'boolean' | 'number' | 'string'} type of the property of its name
 * @property {readonly string[]} [words] all that is accepted
 * @property {true} [many] any of those words, with blanks between
 */
import { Refusal } from '../core/refusal.js';
import { STANDARD_VIEWS } from '../core/standard-views.js';

/** @type {import('./workbench.js').Panel[]} */
export const PANELS = ['mechanism', 'motion', 'teach', 'types', 'info', 'charts', 'algorithm', 'best'];

/** @template {string} T @param {string} name @param {string} text @param {readonly T[]} accepted @returns {T} */
function oneOf(name, text, accepted) {
  const found = accepted.find((word) => word === text.trim().toLowerCase());
  if (found === undefined) throw new Refusal(`The attribute ${name} is “${text}”. Accepted: ${accepted.join(', ')}.`);
  return found;
}

/** Stands there, or not. @type {Attribute<boolean>} */
const flag = { type: 'boolean', read: (text) => text !== null, write: (on) => (on ? '' : null) };

/** Any text. @type {Attribute<string>} */
const any = { type: 'string', read: (text) => text ?? '', write: (text) => text || null };

/** One of these words. @template {string} T @param {string} name @param {readonly T[]} words @param {T} standard @returns {Attribute<T>} */
const word = (name, words, standard) => ({
  type: 'string',
  words,
  read: (text) => (text === null ? standard : oneOf(name, text, words)),
  write: (value) => (value === standard ? null : value),
});

/** One of these words, or empty for none. @template {string} T @param {string} name @param {readonly T[]} words @returns {Attribute<T | ''>} */
const wordOrNone = (name, words) => ({ type: 'string', words, read: (text) => (text ? oneOf(name, text, words) : ''), write: (value) => value || null });

/** @param {string} name @param {number} standard @param {(value: number) => boolean} good @param {string} accepted @returns {Attribute<number>} */
const number = (name, standard, good, accepted) => ({
  type: 'number',
  read(text) {
    if (text === null) return standard;
    const value = text.trim() === '' ? NaN : Number(text);
    if (!good(value)) throw new Refusal(`The attribute ${name} is “${text}”. Accepted: ${accepted}.`);
    return value;
  },
  write: (value) => (value === standard ? null : String(value)),
});

/** @type {Attribute<import('./workbench.js').Panel[]>} */
const panels = {
  type: 'string',
  words: PANELS,
  many: true,
  read: (text) => (text ?? '').split(/[\s,]+/).filter(Boolean).map((name) => oneOf('panels', name, PANELS)),
  write: (names) => names.join(' ') || null,
};

/** In the order of the reference. */
export const ATTRIBUTES = {
  src: any,
  type: any,
  controls: flag,
  autoplay: flag,
  loop: flag,
  bounce: flag,
  /** Counted from 0, as in the columns. */
  frame: number('frame', 0, (value) => Number.isInteger(value) && value >= 0, 'a whole number from 0'),
  /** A factor. */
  speed: number('speed', 1, (value) => value > 0 && value < Infinity, 'a factor above zero, such as 0.5'),
  view: wordOrNone('view', /** @type {(keyof typeof STANDARD_VIEWS)[]} */ (Object.keys(STANDARD_VIEWS))),
  theme: wordOrNone('theme', /** @type {const} */ (['light', 'dark', 'auto'])),
  readonly: flag,
  panels,
  interaction: word('interaction', /** @type {const} */ (['none', 'ctrl', 'full']), 'ctrl'),
  keys: word('keys', /** @type {const} */ (['element', 'page']), 'element'),
  loading: word('loading', /** @type {const} */ (['lazy', 'eager']), 'lazy'),
  poster: any,
};

/** What happens at the end, by the two attributes. @param {{loop: boolean, bounce: boolean}} attributes @returns {Loop} */
export const modeOf = ({ loop, bounce }) => (bounce ? 'bounce' : loop ? 'loop' : 'once');

/** @param {Element} element @param {string} name @param {string | null} text */
export function write(element, name, text) {
  if (text === null) element.removeAttribute(name);
  else element.setAttribute(name, text);
}

/**
 * The attributes of <synthetica-linkage>: what may stand in each, and how it is written. No DOM.
 *
 * @typedef {import('../core/playhead.js').Loop} Loop
 */
import { Refusal } from '../core/refusal.js';
import { STANDARD_VIEWS } from '../core/standard-views.js';

/** @type {import('./workbench.js').Panel[]} */
export const PANELS = ['mechanism', 'motion', 'teach', 'types', 'info', 'charts', 'algorithm'];

/** @template {string} T @param {string} name @param {string} text @param {readonly T[]} accepted @returns {T} */
function oneOf(name, text, accepted) {
  const found = accepted.find((word) => word === text.trim().toLowerCase());
  if (found === undefined) throw new Refusal(`The attribute ${name} is “${text}”. Accepted: ${accepted.join(', ')}.`);
  return found;
}

/** @param {string} name @param {string} text @param {(value: number) => boolean} good @param {string} accepted */
function number(name, text, good, accepted) {
  const value = text.trim() === '' ? NaN : Number(text);
  if (!good(value)) throw new Refusal(`The attribute ${name} is “${text}”. Accepted: ${accepted}.`);
  return value;
}

/** What each attribute means; null for one that is absent. A meaning that is no such thing is refused in words. */
export const MEANINGS = {
  /** @param {string | null} text @returns {Loop} */
  loop: (text) => (text === null ? 'once' : text === '' ? 'loop' : oneOf('loop', text, /** @type {const} */ (['once', 'loop', 'bounce']))),
  /** A factor. @param {string | null} text */
  speed: (text) => (text === null ? 1 : number('speed', text, (value) => value > 0 && value < Infinity, 'a factor above zero, such as 0.5')),
  /** Counted from 0, as in the columns. @param {string | null} text */
  frame: (text) => (text === null ? 0 : number('frame', text, (value) => Number.isInteger(value) && value >= 0, 'a whole number from 0')),
  /** @param {string | null} text @returns {keyof typeof STANDARD_VIEWS | ''} */
  view: (text) => (text === null || text === '' ? '' : oneOf('view', text, /** @type {(keyof typeof STANDARD_VIEWS)[]} */ (Object.keys(STANDARD_VIEWS)))),
  /** @param {string | null} text @returns {'light' | 'dark' | 'auto' | ''} */
  theme: (text) => (text === null || text === '' ? '' : oneOf('theme', text, /** @type {const} */ (['light', 'dark', 'auto']))),
  /** @param {string | null} text @returns {import('./workbench.js').Panel[]} */
  panels: (text) => (text ?? '').split(/[\s,]+/).filter(Boolean).map((word) => oneOf('panels', word, PANELS)),
  /** @param {string | null} text @returns {'element' | 'page'} */
  keys: (text) => (text === null ? 'element' : oneOf('keys', text, /** @type {const} */ (['element', 'page']))),
};

/** @param {Element} element @param {string} name @param {string | null} text */
export function write(element, name, text) {
  if (text === null) element.removeAttribute(name);
  else element.setAttribute(name, text);
}

/** How a state is written; null for no attribute. */
export const WRITINGS = {
  /** @param {Loop} loop */
  loop: (loop) => ({ once: null, loop: '', bounce: 'bounce' })[loop],
  /** @param {number} speed */
  speed: (speed) => (speed === 1 ? null : String(speed)),
  /** @param {number} frame */
  frame: (frame) => (frame === 0 ? null : String(frame)),
  /** @param {string} view */
  view: (view) => view || null,
};

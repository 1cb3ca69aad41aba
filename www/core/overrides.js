/**
 * Readable changes of a document in an address: `?set=chains.0.joints[1].rows[0].a:1.2`, repeated or parted by
 * commas or semicolons. What holds a place must be there; whether the value is accepted is Rust's to say.
 *
 * @typedef {{path: string, value: unknown}} Override
 */
import { parsePath, valueAt, withValueAt } from './path.js';
import { Refusal } from './refusal.js';

/** A comma or semicolon that another `path:` follows; one in a text does not part. */
const BETWEEN = /[;,](?=\s*[A-Za-z_][\w.[\]]*:)/;

/** An override that cannot be applied; the message is a sentence for a person. */
export class BadOverride extends Refusal {}

/**
 * @param {string[]} sets the values of every `set` of the address
 * @returns {Override[]}
 */
export function parseOverrides(sets) {
  return sets
    .flatMap((set) => set.replace(/[;,]\s*$/, '').split(BETWEEN))
    .filter((text) => text.trim() !== '')
    .map((text) => {
      const colon = text.indexOf(':');
      const place = text.slice(0, colon).trim();
      if (colon < 0 || !/^[A-Za-z_]\w*(\.\w+|\[\d+\])*$/.test(place)) {
        throw new BadOverride(`“${text.trim()}” is no change of a document. Accepted: a place, a colon and a value, such as chains[0].joints[1].rows[0].a:1.2.`);
      }
      return { path: place.replace(/\.(\d+)(?=[.[]|$)/g, '[$1]'), value: valueOf(text.slice(colon + 1).trim()) };
    });
}

/** Numbers, true, false, null and whole JSON are themselves, anything else is text. @param {string} text @returns {unknown} */
function valueOf(text) {
  try {
    return JSON.parse(text.replace(/^−/, '-'));
  } catch {
    return text;
  }
}

/**
 * @template T
 * @param {T} doc with every default written out
 * @param {Override[]} overrides
 * @returns {T}
 */
export function applyOverrides(doc, overrides) {
  return overrides.reduce((changed, { path, value }) => {
    const keys = parsePath(path);
    const last = keys[keys.length - 1];
    const holder = parent(path);
    const container = valueAt(changed, holder);
    const known = keys.every((key, depth) => depth === keys.length - 1 || hasOwn(valueAt(changed, join(keys.slice(0, depth))), key));
    const fits = Array.isArray(container) ? typeof last === 'number' && last < container.length : typeof last === 'string';
    if (!known || typeof container !== 'object' || container === null || !fits || last === '__proto__') {
      const offered = Array.isArray(container) ? `${holder}[0] to ${holder}[${container.length - 1}]` : 'a place that the document has';
      throw new BadOverride(`There is no ${path} in this document. Accepted: ${offered}.`);
    }
    return withValueAt(changed, path, value);
  }, doc);
}

/** @param {(string | number)[]} keys @returns {string} */
const join = (keys) => keys.map((key, index) => (typeof key === 'number' ? `[${key}]` : `${index ? '.' : ''}${key}`)).join('');

/** @param {string} path */
const parent = (path) => join(parsePath(path).slice(0, -1));

/** @param {unknown} container @param {string | number} key */
const hasOwn = (container, key) => typeof container === 'object' && container !== null && Object.hasOwn(container, key);

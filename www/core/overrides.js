/**
 * Readable changes of a document in an address: `?set=chains.0.joints[1].rows[0].a:1.2`, repeated or parted by
 * commas or semicolons. What holds a place must be there; whether the value is accepted is Rust's to say. Each change that
 * is refused is told by itself, and the others hold; of two for the same place the last one counts.
 *
 * @typedef {{path: string, value: unknown, text: string}} Override `text` as it stands in the address
 * @typedef {import('./types.js').MechanismDocument} MechanismDocument
 */
import { DocumentFault } from '../planner/planner.js';
import { reason } from './open.js';
import { covers, parsePath, valueAt, withValueAt } from './path.js';
import { Refusal } from './refusal.js';

/** A comma or semicolon that another `path:` follows; one in a text does not part. */
const BETWEEN = /[;,](?=\s*[A-Za-z_][\w.[\]]*:)/;

/** An override that cannot be applied; the message is a sentence for a person. */
export class BadOverride extends Refusal {
  /** @param {string} message @param {string} [where] the place that the document has not */
  constructor(message, where = '') {
    super(message);
    this.where = where;
  }
}

/**
 * The document with the changes that are accepted, and what is wrong with each of the others.
 * @param {MechanismDocument} doc with every default written out
 * @param {string[]} sets the values of every `set` of the address
 * @param {(text: string) => Promise<MechanismDocument>} whole
 * @returns {Promise<{doc: MechanismDocument, problems: string[]}>}
 */
export async function withOverrides(doc, sets, whole) {
  /** @type {string[]} */
  const problems = [];
  const refuse = (/** @type {string} */ text, /** @type {unknown} */ error) => {
    // That the planner failed is no fault of a change.
    if (!(error instanceof BadOverride || error instanceof DocumentFault)) throw error;
    problems.push(`The change “${text}” in the address (set=…) was left out. ${reason(error)}`);
  };
  const kept = changesIn(sets).flatMap((text) => {
    try {
      return [parseOverride(text)];
    } catch (error) {
      refuse(text, error);
      return [];
    }
  });
  const changed = async (/** @type {number} */ count) => whole(JSON.stringify(applyOverrides(doc, kept.slice(0, count))));

  for (;;) {
    try {
      // Together: some are accepted only with others, such as the times of the key frames.
      return { doc: await changed(kept.length), problems };
    } catch (error) {
      let at = namedBy(/** @type {{where?: string}} */ (error).where ?? '', kept);
      let why = error;
      // The fault names none of them: the first one with which there is a fault.
      for (let count = 1; at < 0 && count <= kept.length; count++) {
        await changed(count).catch((other) => {
          at = count - 1;
          why = other;
        });
      }
      if (at < 0) throw error;
      refuse(kept[at].text, why);
      kept.splice(at, 1);
    }
  }
}

/** Index of the change that a fault at that place is about, -1 for none: one of the place itself or above it, else one inside it. @param {string} where @param {Override[]} changes */
function namedBy(where, changes) {
  if (!where) return -1;
  const above = changes.map(({ path }) => covers(path, where) >= 0).lastIndexOf(true);
  return above >= 0 ? above : changes.map(({ path }) => covers(where, path) >= 0).lastIndexOf(true);
}

/** @param {string[]} sets @returns {string[]} one change each */
const changesIn = (sets) => sets.flatMap((set) => set.replace(/[;,]\s*$/, '').split(BETWEEN)).map((text) => text.trim()).filter(Boolean);

/** @param {string} text @returns {Override} */
export function parseOverride(text) {
  const colon = text.indexOf(':');
  const place = text.slice(0, colon).trim();
  if (colon < 0 || !/^[A-Za-z_]\w*(\.\w+|\[\d+\])*$/.test(place)) {
    throw new BadOverride('It is no change of a document. Accepted: a place, a colon and a value, such as chains[0].joints[1].rows[0].a:1.2.');
  }
  return { path: place.replace(/\.(\d+)(?=[.[]|$)/g, '[$1]'), value: valueOf(text.slice(colon + 1).trim()), text };
}

/** @param {string[]} sets @returns {Override[]} */
export const parseOverrides = (sets) => changesIn(sets).map(parseOverride);

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
      throw new BadOverride(`There is no ${path} in this document. Accepted: ${offered}.`, path);
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

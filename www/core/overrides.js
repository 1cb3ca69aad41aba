/**
 * Readable changes of a document in an address: `?set=chains.0.joints[1].rows[0].a:1.2`, or `?set=base:400` for a parameter, `=` as good as the colon,
 * repeated or parted by commas or semicolons. What holds a place must be there; whether the value is accepted is Rust's to say. Each change that
 * is refused is told by itself, and the others hold; of two for the same place the last one counts.
 *
 * @typedef {{path: string, value: unknown, text: string}} Override `text` as it stands in the address
 * @typedef {import('./types.js').MechanismDocument} MechanismDocument
 * @typedef {import('./linkage.js').Linkage['whole']} Whole
 * @typedef {{is: 'bad', where: string, message: string}} Bad
 */
import { covers, parsePath, valueAt, withValueAt } from './path.js';
import { Refusal } from './refusal.js';

/** A comma or semicolon that another `path:` or `path=` follows; one in a text does not part. */
const BETWEEN = /[;,](?=\s*[A-Za-z_][\w.[\]]*[:=])/;

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
 * @param {Whole} whole
 * @returns {Promise<import('./ask.js').Answer<{doc: MechanismDocument, problems: string[]}> | import('./ask.js').Trouble | import('./ask.js').Late>}
 */
export async function withOverrides(doc, sets, whole) {
  /** @type {string[]} */
  const problems = [];
  const refuse = (/** @type {string} */ text, /** @type {string} */ why) => {
    problems.push(`The change “${text}” in the address (set=…) was left out. ${why}`);
  };
  const kept = changesIn(sets).flatMap((text) => {
    const read = unlessBad(() => namedIn(doc, parseOverride(text)));
    if (read.is === 'answer') return [read.value];
    refuse(text, read.message);
    return [];
  });
  /** With the first ones only. @param {number} count @returns {Promise<Awaited<ReturnType<Whole>> | Bad>} */
  const changed = async (count) => {
    const text = unlessBad(() => JSON.stringify(applyOverrides(doc, kept.slice(0, count))));
    return text.is === 'answer' ? whole(text.value) : text;
  };

  for (;;) {
    // Together: some are accepted only with others, such as the times of the key frames.
    let read = await changed(kept.length);
    if (read.is === 'answer') return { is: 'answer', value: { doc: read.value, problems } };
    if (read.is === 'trouble' || read.is === 'late') return read;
    let at = namedBy(read.is === 'bad' ? read.where : read.fault.where, kept);
    // The fault names none of them: the first one with which there is a fault.
    for (let count = 1; at < 0 && count <= kept.length; count++) {
      read = await changed(count);
      if (read.is === 'trouble' || read.is === 'late') return read;
      if (read.is !== 'answer') at = count - 1;
    }
    if (at < 0 || read.is === 'answer') throw new Error('The document was without a fault before it was changed.');
    refuse(kept[at].text, read.message);
    kept.splice(at, 1);
  }
}

/** @template T @param {() => T} act @returns {import('./ask.js').Answer<T> | Bad} */
function unlessBad(act) {
  try {
    return { is: 'answer', value: act() };
  } catch (error) {
    if (!(error instanceof BadOverride)) throw error;
    return { is: 'bad', where: error.where, message: error.message };
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
function parseOverride(text) {
  const colon = text.search(/[:=]/);
  const place = text.slice(0, colon).trim();
  if (colon < 0 || !/^[A-Za-z_]\w*(\.\w+|\[\d+\])*$/.test(place)) {
    throw new BadOverride('It is no change of a document. Accepted: a place, a colon and a value, such as chains[0].joints[1].rows[0].a:1.2; or the name of a parameter, such as base:400.');
  }
  return { path: place.replace(/\.(\d+)(?=[.[]|$)/g, '[$1]'), value: valueOf(text.slice(colon + 1).trim()), text };
}

/**
 * A change whose place is the name of a parameter is one of that parameter, also where a field has that name, as in the command.
 * @param {unknown} doc @param {Override} change @returns {Override}
 */
const namedIn = (doc, change) => (hasOwn(valueAt(doc, 'parameters'), change.path) ? { ...change, path: `parameters.${change.path}` } : change);

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
  return overrides.reduce((changed, given) => {
    const { path, value } = namedIn(changed, given);
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

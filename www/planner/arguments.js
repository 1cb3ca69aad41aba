/**
 * What a program may pass to the planner's functions. What is of the wrong kind is refused here, in words: the planner's own
 * code expects the kinds that are declared, and what it makes of others is chance.
 */

/** @param {string} where @param {unknown} value @param {string} accepted */
export const wrong = (where, value, accepted) => new TypeError(`${where} is ${kindOf(value)}. Accepted: ${accepted}.`);

/** @param {unknown} value */
function kindOf(value) {
  if (value === null || value === undefined) return String(value);
  if (typeof value === 'number') return `the number ${value}`;
  if (typeof value === 'string') return `the text ${JSON.stringify(value.length > 40 ? `${value.slice(0, 40)}…` : value)}`;
  if (typeof value === 'function') return 'a function';
  if (Array.isArray(value)) return 'a list';
  return typeof value === 'object' ? `an object (${value.constructor?.name ?? 'of no class'})` : `a ${typeof value}`;
}

/** A document's text, written anew each time: a program may have changed it. @param {unknown} doc @returns {string} */
export function written(doc) {
  if (typeof doc === 'string') return doc;
  const accepted = 'a mechanism document, as an object or its text';
  /** @type {string | undefined} */
  let text;
  try {
    text = JSON.stringify(doc);
  } catch (error) {
    throw new TypeError(`The document cannot be written as JSON (${error instanceof Error ? error.message : error}). Accepted: ${accepted}.`);
  }
  // What is JSON, and no document, is the planner's to refuse.
  if (text === undefined) throw wrong('The document', doc, accepted);
  return text;
}

/** @param {string} where @param {unknown} value @param {string} accepted @returns {string} */
export function text(where, value, accepted) {
  if (typeof value !== 'string') throw wrong(where, value, accepted);
  return value;
}

/** @param {string} where @param {unknown} value @param {string} [accepted] @returns {number} */
export function number(where, value, accepted = 'a number') {
  if (typeof value !== 'number') throw wrong(where, value, accepted);
  return value;
}

/** Values of joints, or a pose. @param {string} where @param {unknown} numbers @param {string} accepted @returns {Float64Array} */
export function column(where, numbers, accepted) {
  const isList = Array.isArray(numbers) || (ArrayBuffer.isView(numbers) && 'length' in numbers);
  if (!isList) throw wrong(where, numbers, accepted);
  const list = Array.from(/** @type {ArrayLike<unknown>} */ (numbers));
  const at = list.findIndex((value) => typeof value !== 'number');
  if (at >= 0) throw wrong(`${where}[${at}]`, list[at], 'a number');
  return Float64Array.from(/** @type {number[]} */ (list));
}

/** @param {string} where @param {unknown} value @param {string} accepted @returns {any} */
export function object(where, value, accepted) {
  if (typeof value !== 'object' || value === null || Array.isArray(value)) throw wrong(where, value, accepted);
  return value;
}

/** Also one of another realm or library. @param {any} value */
const isSignal = (value) => typeof value === 'object' && typeof value.aborted === 'boolean' && typeof value.addEventListener === 'function';

/** @type {Record<string, {accepted: string, is: (value: unknown) => boolean}>} */
const OPTIONS = {
  signal: { accepted: 'an AbortSignal', is: isSignal },
  stop: { accepted: 'an AbortSignal', is: isSignal },
  onProgress: { accepted: 'a function', is: (value) => typeof value === 'function' },
  headings: { accepted: 'units, plain, two-rows', is: (value) => typeof value === 'string' },
  gravity: { accepted: 'true, false', is: (value) => typeof value === 'boolean' },
};

/**
 * Options without those that are undefined or null.
 * @param {unknown} given @param {string[]} known
 * @returns {{signal?: AbortSignal, stop?: AbortSignal, onProgress?: (progress: import('../core/types.js').Progress) => void} & import('../core/types.js').ExportOptions}
 */
export function options(given, known) {
  if (given === undefined || given === null) return {};
  const accepted = `an object with ${known.join(', ')}`;
  const there = Object.entries(object('The argument options', given, accepted)).filter(([, value]) => value !== undefined && value !== null);
  for (const [name, value] of there) {
    if (!known.includes(name)) throw new TypeError(`The option ${name} is unknown. Accepted: ${known.join(', ')}.`);
    if (!OPTIONS[name].is(value)) throw wrong(`The option ${name}`, value, OPTIONS[name].accepted);
  }
  return Object.fromEntries(there);
}

/**
 * Long lists shown in part: which entries stand for all, and equality of documents that share most of their parts.
 */

/**
 * Indices of a list, evenly spread from the first to the last; all of them where there are no more than `most`.
 * @param {number} count @param {number} most @param {number} [own] an index that is among them in any case
 */
export function spreadOver(count, most, own = -1) {
  if (count <= most) return Array.from({ length: count }, (_, index) => index);
  const some = Array.from({ length: most }, (_, i) => Math.round((i * (count - 1)) / (most - 1)));
  return own < 0 || own >= count || some.includes(own) ? some : [...some, own].sort((a, b) => a - b);
}

/**
 * Whether two plain values would be the same JSON, but for the order of fields. Parts that are one object are not looked
 * into: of a document with 100,000 key frames an edit changes one.
 * @param {any} a @param {any} b @returns {boolean}
 */
export function same(a, b) {
  if (a === b || (a !== a && b !== b)) return true;
  if (typeof a !== 'object' || typeof b !== 'object' || a === null || b === null || Array.isArray(a) !== Array.isArray(b)) return false;
  if (Array.isArray(a)) return a.length === b.length && a.every((item, index) => same(item, b[index]));
  const fields = (/** @type {any} */ one) => Object.keys(one).filter((field) => one[field] !== undefined);
  const own = fields(a);
  return own.length === fields(b).length && own.every((field) => b[field] !== undefined && same(a[field], b[field]));
}

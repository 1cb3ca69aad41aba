/**
 * A document as the text that the planner reads, written once: documents are never changed, only replaced.
 */

/** @type {WeakMap<object, string>} */
const texts = new WeakMap();

/** @param {object} document */
export function textOf(document) {
  const known = texts.get(document);
  if (known !== undefined) return known;
  const text = JSON.stringify(document);
  texts.set(document, text);
  return text;
}

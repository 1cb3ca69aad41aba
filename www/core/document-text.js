/**
 * A document as the text that the planner reads, written once: documents are never changed, only replaced.
 */

/** @type {WeakMap<object, string>} */
const texts = new WeakMap();

/** @param {object} doc */
export function textOf(doc) {
  const known = texts.get(doc);
  if (known !== undefined) return known;
  const text = JSON.stringify(doc);
  texts.set(doc, text);
  return text;
}

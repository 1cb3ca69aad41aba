/**
 * A document as the text that the planner reads, written once: documents are never changed, only replaced.
 */

/** Characters of a text that is kept only while its document is one of the last few: undo keeps hundreds of documents. */
const LARGE = 200_000;
const FEW = 3;

/** @type {WeakMap<object, string>} */
const texts = new WeakMap();
/** Documents with large texts, the last one at the end. @type {object[]} */
const large = [];

/** @param {object} doc */
export function textOf(doc) {
  const known = texts.get(doc);
  if (known !== undefined) return known;
  const text = JSON.stringify(doc);
  texts.set(doc, text);
  if (text.length > LARGE && large.push(doc) > FEW) texts.delete(/** @type {object} */ (large.shift()));
  return text;
}

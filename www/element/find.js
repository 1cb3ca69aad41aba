/**
 * Finds the document that an element's attributes or its content ask for.
 */
import { Refusal } from '../core/refusal.js';
import { findSample, sampleText } from '../core/samples.js';

/**
 * The document inside. One that the page's parser has not come to the end of is none yet.
 * @param {HTMLElement} element
 */
function textInside(element) {
  const script = element.querySelector(':scope > script[type="application/json"]');
  const isWhole = script && (document.readyState !== 'loading' || script.nextSibling || element.nextSibling);
  return isWhole ? (script.textContent ?? '').trim() : '';
}

/** What the attributes and the content ask for, as a text to compare. @param {HTMLElement & {src: string, type: string}} element */
export function askedFor(element) {
  const { src, type } = element;
  if (src) return `src ${src}`;
  const inside = textInside(element);
  return inside ? `inside ${inside}` : type && `type ${type}`;
}

/** Whether its attribute type says what it shows. @param {HTMLElement & {src: string, type: string}} element */
export const isByType = (element) => askedFor(element).startsWith('type ');

/**
 * @param {HTMLElement & {src: string, type: string}} element
 * @param {(type: string) => Promise<import('../core/ask.js').Outcome<string>>} assemble asks the planner for a linkage of a type
 * @returns {Promise<{text: string, title: string} | null>} null where nothing is asked for, or the answer is late
 */
export async function findDocument(element, assemble) {
  const { src, type } = element;
  if (src) return { text: await fetched(src, element.baseURI), title: src.replace(/^.*\//, '') };
  const inside = textInside(element);
  if (inside) return { text: inside, title: '' };
  if (!type) return null;
  const sample = await findSample(type);
  if (sample) return { text: await sampleText(sample), title: sample.file };
  const made = await assemble(type);
  if (made.is === 'fault') throw new Refusal(made.message);
  return made.is === 'answer' ? { text: made.value, title: '' } : null;
}

/** @param {string} src @param {string} base @returns {Promise<string>} */
async function fetched(src, base) {
  if (!URL.canParse(src, base)) throw new Refusal(`“${src}” is no address. Accepted: the address of a document, which is JSON text.`);
  const { fetchText } = await import('../core/fetch-text.js');
  // With the cookies of its own server, as pictures and videos: who wrote the page may read what is there.
  return fetchText(new URL(src, base), { credentials: 'same-origin' });
}

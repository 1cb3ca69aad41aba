/**
 * All sample documents: what is said of them, and their texts. Loaded when one is asked for that a page does not open with.
 */
import index from '../mechanisms/index.json';
import { Refusal } from './refusal.js';

const texts = /** @type {Record<string, () => Promise<string>>} */ (
  import.meta.glob(['../mechanisms/*.json', '!../mechanisms/index.json'], { query: '?raw', import: 'default' })
);

/** @typedef {{file: string, title: string, line: string, mobility: number, group: string}} Sample `group` as in mechanism-groups.js */

/** In the order of their index. @type {Sample[]} */
export const samples = index;

/** @param {{file: string}} sample @returns {Promise<string>} */
export const sampleText = ({ file }) => texts[`../mechanisms/${file}`]();

/** By its file, with or without its ending, or by its title. @param {string} name @returns {{file: string} | undefined} */
export function findSample(name) {
  const wanted = name.trim().toLowerCase();
  return samples.find(({ file, title }) => [file, file.replace('.json', ''), title.toLowerCase()].includes(wanted));
}

/** @param {string} name @returns {{file: string}} */
export function sampleOf(name) {
  const found = findSample(name);
  if (found) return found;
  const near = nearestSample(name);
  throw new Refusal(`There is no sample “${name}”.${near ? ` Did you mean “${near.file.replace('.json', '')}”?` : ''} Accepted: ${samples.map(({ file }) => file).join(', ')}.`);
}

/** The one whose file or title is few letters away from a name; none where all are too far for a slip. @param {string} name */
function nearestSample(name) {
  const wanted = name.trim().toLowerCase().replace(/\.json$/, '');
  const far = (/** @type {Sample} */ { file, title }) => Math.min(...[file.replace('.json', ''), title.toLowerCase()].map((known) => lettersApart(wanted, known)));
  const [near] = [...samples].sort((a, b) => far(a) - far(b));
  return far(near) <= Math.max(1, wanted.length / 2) ? near : undefined;
}

/** How many letters must be put in, left out or changed (Levenshtein's distance, by the rows of its table). @param {string} a @param {string} b */
function lettersApart(a, b) {
  let row = [...b, ''].map((_, j) => j);
  for (let i = 1; i <= a.length; i++) {
    const above = row;
    row = [i];
    for (let j = 1; j <= b.length; j++) row[j] = Math.min(above[j] + 1, row[j - 1] + 1, above[j - 1] + (a[i - 1] === b[j - 1] ? 0 : 1));
  }
  return row[b.length];
}

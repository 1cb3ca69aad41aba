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
  if (!found) throw new Refusal(`There is no sample “${name}”. Accepted: ${samples.map(({ file }) => file).join(', ')}.`);
  return found;
}

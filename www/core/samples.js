/**
 * The sample documents. What is said of them and their texts are loaded when they are asked for.
 */
import { Refusal } from './refusal.js';

const texts = /** @type {Record<string, () => Promise<string>>} */ (
  import.meta.glob(['../mechanisms/*.json', '!../mechanisms/index.json'], { query: '?raw', import: 'default' })
);

/** @typedef {{file: string, title: string, line: string, mobility: number, group: string}} Sample `group` as in mechanism-groups.js */

/** What a page opens with. */
export const FIRST = { file: '3rps.json' };

/** All, in the order of their index. @returns {Promise<Sample[]>} */
export const samples = async () => (await import('../mechanisms/index.json')).default;

/** @param {{file: string}} sample @returns {Promise<string>} */
export const sampleText = ({ file }) => texts[`../mechanisms/${file}`]();

/** By its file, with or without its ending, or by its title. @param {string} name @returns {Promise<{file: string} | undefined>} */
export async function findSample(name) {
  const wanted = name.trim().toLowerCase();
  const file = `${wanted.replace(/\.json$/, '')}.json`;
  // What is asked for by its file needs no index.
  if (`../mechanisms/${file}` in texts) return { file };
  return (await samples()).find(({ title }) => title.toLowerCase() === wanted);
}

/** @param {string} name @returns {Promise<{file: string}>} */
export async function sampleOf(name) {
  const found = await findSample(name);
  if (!found) throw new Refusal(`There is no sample “${name}”. Accepted: ${(await samples()).map(({ file }) => file).join(', ')}.`);
  return found;
}

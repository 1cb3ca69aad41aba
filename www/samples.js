/**
 * The sample documents, in the order of their index.
 */
import index from './mechanisms/index.json';

/** @type {Record<string, string>} */
const texts = import.meta.glob(['./mechanisms/*.json', '!./mechanisms/index.json'], { query: '?raw', import: 'default', eager: true });

/** @type {{file: string, title: string, line: string, mobility: number, text: string}[]} */
export const samples = index.map((entry) => ({ ...entry, text: texts[`./mechanisms/${entry.file}`] }));

/**
 * The sample that a page opens with; all others are in sample-list.js, loaded when they are asked for.
 */
const list = () => import('./sample-list.js');

/** What a page opens with. */
export const FIRST = { file: '3rps.json' };

/** @param {{file: string}} sample @returns {Promise<string>} */
export const sampleText = async (sample) => (sample.file === FIRST.file ? (await import('../mechanisms/3rps.json?raw')).default : (await list()).sampleText(sample));

/** By its file, with or without its ending, or by its title. @param {string} name @returns {Promise<{file: string} | undefined>} */
export const findSample = async (name) => (await list()).findSample(name);

/** @param {string} name @returns {Promise<{file: string}>} refuses a name that there is not, with those that there are */
export const sampleOf = async (name) => (await list()).sampleOf(name);

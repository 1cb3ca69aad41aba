/**
 * The document that an address asks for: the one in a share link, or a sample, with the changes of `set=`.
 */
import { reason } from './open.js';
import { sampleOf, sampleText, samples } from './samples.js';

/**
 * @param {ReturnType<typeof import('./address.js').readAddress>} asked
 * @param {import('./linkage.js').Linkage['whole']} whole
 * @returns {Promise<{doc: import('./types.js').MechanismDocument, title: string, problems: string[]}>} with what
 *   was wrong with the address; something is always shown
 */
export async function answerTo({ payload, sample, sets }, whole) {
  /** @type {string[]} */
  const problems = [];
  let found = samples[0];
  try {
    if (sample !== null) found = sampleOf(sample);
  } catch (error) {
    problems.push(reason(error));
  }
  let doc = await whole(await sampleText(found));
  let title = found.file;
  if (payload !== null) {
    try {
      const { decode } = await import('./link-codec.js');
      doc = await whole(await decode(payload));
      title = '';
    } catch (error) {
      problems.push(`This link cannot be opened: a sample is shown in its place. ${reason(error)}`);
    }
  }
  try {
    if (sets.length) {
      const { withOverrides } = await import('./overrides.js');
      const changed = await withOverrides(doc, sets, whole);
      ({ doc } = changed);
      problems.push(...changed.problems);
    }
  } catch (error) {
    problems.push(`The changes in the address (set=…) were left out. ${reason(error)}`);
  }
  return { doc, title, problems };
}

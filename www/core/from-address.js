/**
 * The document that an address asks for: the one in a share link, or a sample, with the changes of `set=`.
 */
import { loaded } from '../ui/lazy.js';
import { reason } from './open.js';
import { FIRST, sampleOf, sampleText } from './samples.js';

/**
 * @param {ReturnType<typeof import('./address.js').readAddress>} asked
 * @param {Pick<import('./linkage.js').Linkage, 'whole' | 'say'>} linkage
 * @returns {Promise<import('./ask.js').Answer<{doc: import('./types.js').MechanismDocument, title: string, broken: string,
 *   problems: string[]}> | import('./ask.js').Trouble>} `broken`: why the link cannot be opened, if it cannot, a sample then stands
 *   in its place; `problems`: what else was wrong with the address
 */
export async function answerTo({ payload, sample, sets }, linkage) {
  const { whole } = linkage;
  /** @type {string[]} */
  const problems = [];
  let found = FIRST;
  try {
    if (sample !== null) found = await sampleOf(sample);
  } catch (error) {
    problems.push(reason(error));
  }
  const first = await whole(await loaded(linkage, 'The sample', () => sampleText(found)));
  if (first.is === 'trouble') return first;
  if (first.is !== 'answer') throw new Error(`The sample ${found.file} cannot be opened. ${first.message}`);
  let doc = first.value;
  let title = found.file;
  let broken = '';
  if (payload !== null) {
    const { decode } = await loaded(linkage, 'What reads links', () => import('./link-codec.js'));
    const text = await decode(payload).catch((error) => {
      broken = reason(error);
      return null;
    });
    const shared = text === null ? null : await whole(text);
    if (shared?.is === 'trouble') return shared;
    if (shared?.is === 'answer') {
      doc = shared.value;
      title = '';
    } else if (shared) broken = shared.message;
  }
  if (sets.length) {
    const { withOverrides } = await loaded(linkage, 'What reads the changes in the address', () => import('./overrides.js'));
    const changed = await withOverrides(doc, sets, whole);
    if (changed.is === 'trouble') return changed;
    if (changed.is === 'answer') {
      ({ doc } = changed.value);
      problems.push(...changed.value.problems);
    }
  }
  return { is: 'answer', value: { doc, title, broken, problems } };
}

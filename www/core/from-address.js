/**
 * The document that an address asks for: the one in a share link, one of another address, or a sample, with the changes of
 * `set=`.
 *
 * @typedef {import('./types.js').MechanismDocument} MechanismDocument
 * @typedef {object} Found
 * @property {MechanismDocument | null} doc null where there is none to be shown: another one would be taken for it
 * @property {string} title of its file
 * @property {string} from the address that it was loaded from, if it was
 * @property {string} broken why the link cannot be opened, if it cannot; a sample then stands in its place
 * @property {string} missing why there is no document
 * @property {import('./types.js').Fault | null} fault of the document that is missing, if it has one
 * @property {string[]} problems what else was wrong with the address
 */
import { faultText } from './fault-text.js';
import { loaded } from '../ui/lazy.js';
import { reason } from './open.js';
import { FIRST, sampleOf, sampleText } from './samples.js';

/** @typedef {(src: string) => Promise<{text: string, from: string}>} ReadSrc refuses what cannot be read */

/**
 * @param {ReturnType<typeof import('./address.js').readAddress>} asked
 * @param {Pick<import('./linkage.js').Linkage, 'whole' | 'say'>} linkage
 * @param {ReadSrc} [readSrc]
 * @returns {Promise<import('./ask.js').Answer<Found> | import('./ask.js').Trouble>}
 */
export async function answerTo({ payload, src, sample, sets }, linkage, readSrc) {
  const { whole } = linkage;
  /** @type {Found} */
  const found = { doc: null, title: '', from: '', broken: '', missing: '', fault: null, problems: [] };
  if (payload !== null) {
    const { decode } = await loaded(linkage, 'What reads links', () => import('./link-codec.js'));
    const text = await decode(payload).catch((error) => {
      found.broken = reason(error);
      return null;
    });
    const shared = text === null ? null : await whole(text);
    if (shared?.is === 'trouble') return shared;
    if (shared?.is === 'answer') found.doc = shared.value;
    else if (shared) found.broken = shared.message;
  }
  if (!found.doc) {
    const named = await textOf(payload === null ? src : null, sample, linkage, readSrc).catch((error) => {
      found.missing = reason(error);
      return null;
    });
    if (!named) return { is: 'answer', value: found };
    const read = await whole(named.text);
    if (read.is === 'trouble') return read;
    if (read.is === 'answer') Object.assign(found, { doc: read.value, title: named.title, from: named.from });
    else if (read.is === 'fault') Object.assign(found, { fault: read.fault, missing: `${named.from || named.title} cannot be opened. ${faultText(read.fault)}` });
  }
  if (found.doc && sets.length) {
    const { withOverrides } = await loaded(linkage, 'What reads the changes in the address', () => import('./overrides.js'));
    const changed = await withOverrides(found.doc, sets, whole);
    if (changed.is === 'trouble') return changed;
    if (changed.is === 'answer') {
      found.doc = changed.value.doc;
      found.problems.push(...changed.value.problems);
    }
  }
  return { is: 'answer', value: found };
}

/**
 * @param {string | null} src @param {string | null} sample
 * @param {Pick<import('./linkage.js').Linkage, 'say'>} linkage @param {ReadSrc} [readSrc]
 */
async function textOf(src, sample, linkage, readSrc) {
  if (src !== null) {
    const read = readSrc ?? (await loaded(linkage, 'What reads other addresses', () => import('./from-src.js'))).fromSrc;
    const { text, from } = await read(src);
    return { text, from, title: from.replace(/[?#].*$/s, '').replace(/^.*\//, '') };
  }
  const file = sample === null ? FIRST : await sampleOf(sample);
  return { text: await loaded(linkage, 'The sample', () => sampleText(file)), from: '', title: file.file };
}

/**
 * The address of a frame: which attributes its linkage has, which document, and who may talk to it. No DOM.
 */
import { Refusal } from '../core/refusal.js';

/** What stands in the address under the same name as in the element. */
const NAMES = ['controls', 'autoplay', 'loop', 'bounce', 'speed', 'frame', 'view', 'theme', 'readonly', 'panels', 'interaction'];

/** What is on by standing there. */
const SWITCHES = ['controls', 'autoplay', 'readonly', 'loop', 'bounce'];

/** In an address also the words for no. */
const NO = ['0', 'false', 'no', 'off'];

/**
 * @param {string} search
 * @returns {[string, string][]} a frame has controls and the reader's scheme unless it says otherwise
 */
export function attributesOf(search) {
  const query = new URLSearchParams(search);
  // As addresses had it when `loop` said how.
  if (query.get('loop') === 'bounce') {
    query.delete('loop');
    query.set('bounce', '');
  }
  const given = NAMES.filter((name) => query.has(name)).map((name) => /** @type {[string, string]} */ ([name, query.get(name) ?? '']));
  const kept = given.filter(([name, value]) => (SWITCHES.includes(name) ? !NO.includes(value) : value !== ''));
  const unless = (/** @type {string} */ name, /** @type {string} */ value) => (query.has(name) ? [] : [/** @type {[string, string]} */ ([name, value])]);
  return [...kept, ...unless('controls', ''), ...unless('theme', 'auto')];
}

/**
 * The origin of the page around the frame: as its author wrote it, else as the browser tells it.
 * @param {string} search @param {string} referrer of the frame's document
 * @returns {string} an origin; `*` where the author lets any page talk; empty if nothing is known
 */
export function parentOrigin(search, referrer) {
  const written = new URLSearchParams(search).get('origin');
  if (written === '*') return '*';
  try {
    const { origin } = new URL(written ?? referrer);
    // A file or a sandbox has none that a message could be sent to.
    return origin === 'null' ? '' : origin;
  } catch {
    return '';
  }
}

/**
 * What `src` names, if it is in the folder of the page for frames or below. Any page can put any address there and hear the
 * document, so that what else is on the same server is none of its business; what lies beside the page is published with it.
 * @param {string} src @param {string} home the frame's own address
 * @returns {URL}
 */
export function ownFile(src, home) {
  const accepted = 'Accepted: a document in the folder of this page or below it, such as src=mechanisms/3rps.json; or the document in the address itself, as the dialog “Share” writes it.';
  if (!URL.canParse(src, home)) throw new Refusal(`src is “${src}”, which is no address. ${accepted}`);
  const [url, folder] = [new URL(src, home), new URL('./', home)];
  // Some servers unpack a written slash, and then go up.
  const inside = url.origin === folder.origin && url.pathname.startsWith(folder.pathname) && !/%2f|%5c/i.test(url.pathname);
  if (!inside) throw new Refusal(`src is “${src}”, which a frame does not load. ${accepted}`);
  return url;
}

/** Names of a document's format that hold others. */
const PARTS = /^(?:\.?(?:chains|joints|rows|base|gripper|motion|key_frames)(?:\[\d+\])?)*/;

/**
 * What a page of another origin may hear of a file that is no document: which kind of fault, and where as far as the names
 * are the format's. No word of the file, which the fault's own words tell.
 * @param {{message: string, where: string, code: string}} error
 */
export function withoutContent({ where, code }) {
  const known = PARTS.exec(where)?.[0] ?? '';
  return { message: `The document that src names cannot be shown (${code}${known && `, in ${known}`}). What is wrong stands in the frame.`, where: known, code };
}

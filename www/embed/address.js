/**
 * The address of a frame: which attributes its linkage has, and who may talk to it. No DOM.
 */

/** What stands in the address under the same name as in the element. */
const NAMES = ['controls', 'autoplay', 'loop', 'bounce', 'speed', 'frame', 'view', 'theme', 'readonly', 'panels', 'interaction', 'interaction'];

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

/**
 * The text at an address, or why there is none. Asked for without cookies or passwords unless it is said otherwise: what a
 * reader of the page may see on that server is nothing to put into a page for whoever wrote its address.
 */
import { Refusal } from './refusal.js';

/** Bytes of the largest text that is taken: as many as a document may have. */
const MAX_BYTES = 32_000_000;

/**
 * @param {URL} url
 * @param {{redirect?: RequestRedirect, credentials?: RequestCredentials}} [how]
 * @returns {Promise<string>}
 */
export async function fetchText(url, how = {}) {
  const refuse = (/** @type {string} */ why) => {
    throw new Refusal(`${url.href} could not be loaded (${why}). Accepted: the address of a document, which is JSON text, on ${serverFor(url)}.`);
  };
  const refused = (/** @type {Error} */ { message }) => refuse(message);
  const answer = await fetch(url, { credentials: 'omit', ...how }).catch(refused);
  if (!answer.ok) return refuse(`${answer.status} ${answer.statusText}`.trim());
  const bytes = await answer.blob().catch(refused);
  if (bytes.size > MAX_BYTES) return refuse(`it has ${(bytes.size / 1e6).toFixed(1)} MB, and at most ${MAX_BYTES / 1e6} MB are taken`);
  return bytes.text();
}

/** What the server must do. @param {URL} url */
function serverFor(url) {
  const grant = 'with the header Access-Control-Allow-Origin';
  // Those without an origin are not each other’s: “null” says that there is none.
  if (self.origin !== 'null') return url.origin === self.origin ? 'this server' : `a server that lets other pages read it (${grant})`;
  const place = location.protocol === 'file:' ? 'was opened from a disk, and is' : 'is in a sandbox';
  return `a server that answers ${grant}: this page ${place} without an origin of its own, so that every server is another one’s; or the document itself, in the element or in the address of the frame, as the dialog “Share” writes it`;
}

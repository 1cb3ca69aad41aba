/**
 * The text at an address, or why there is none. Asked for without cookies or passwords unless told: what a reader of the page
 * may see on that server is nothing to put into a page for whoever wrote its address.
 */
import { Refusal } from './refusal.js';

/** Bytes of the largest text that is taken: as many as a document may have. */
const MAX_BYTES = 32_000_000;

/**
 * @param {URL} url
 * @param {Pick<RequestInit, 'credentials' | 'redirect'>} [how]
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
  if (url.origin === self.origin) return 'this server';
  const grant = 'with the header Access-Control-Allow-Origin';
  if (self.origin !== 'null') return `a server that lets other pages read it (${grant})`;
  return `a server that answers ${grant}: this frame is in a sandbox without an origin of its own, so that every server is another one’s; or the document in the address itself, as the dialog “Share” writes it`;
}

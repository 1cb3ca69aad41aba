/**
 * The document at the address of `?src=`, for the applet: one's own document on any server that lets it be read.
 */
import { fetchText } from './fetch-text.js';
import { Refusal } from './refusal.js';

/** @param {string} src @returns {Promise<{text: string, from: string}>} */
export async function fromSrc(src) {
  const url = URL.canParse(src, location.href) ? new URL(src, location.href) : null;
  if (!url || !/^https?:$/.test(url.protocol)) throw new Refusal(`src is “${src}”. Accepted: the address of a document, absolute as in https://course.example/arm.json, or from this page, as in mechanisms/3rps.json.`);
  return { text: await fetchText(url), from: url.href };
}

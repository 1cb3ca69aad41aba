/**
 * Hands a text to the browser as a file to keep.
 */
import { element } from '../dom.js';

/** Milliseconds until the text is let go: the browser reads it after the click. */
const UNTIL_READ = 60_000;

/** @param {string} text @param {string} name @param {string} [type] */
export function download(text, name, type = 'text/plain') {
  const url = URL.createObjectURL(new Blob([text], { type }));
  element('a', { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), UNTIL_READ);
}

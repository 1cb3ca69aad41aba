/**
 * Hands a file to the browser to keep.
 */
import { element } from '../ui/dom.js';

/** Milliseconds until the content is let go: the browser reads it after the click. */
const UNTIL_READ = 60_000;

/** @param {string} name @param {Blob} content */
export function saveFile(name, content) {
  const url = URL.createObjectURL(content);
  element('a', { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), UNTIL_READ);
}

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

/**
 * A file's name for a document: 3rps.csv.
 * @param {{name?: string} | null} doc
 * @param {string} ending
 */
export function fileName(doc, ending) {
  const plain = (doc?.name ?? '')
    .normalize('NFKD')
    .toLowerCase()
    .replace(/[’'\u0300-\u036f]/g, '')
    .replace(/[^\p{L}\p{N}]+/gu, '-')
    .replace(/^-|-$/g, '');
  return `${plain || 'linkage'}.${ending}`;
}

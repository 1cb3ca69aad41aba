/**
 * The text of a file that a person hands in, or why it is none.
 */
import { Refusal } from '../../core/refusal.js';

/** Bytes of the largest file that is looked at: as many as a document may have. */
const MAX_BYTES = 32_000_000;

/** The file is not read; the message is a sentence for a person. */
export class RefusedFile extends Refusal {}

/** @param {Blob & {name?: string}} file @returns {Promise<string>} */
export async function readText(file) {
  if (file.size > MAX_BYTES) throw new RefusedFile(`It has ${(file.size / 1e6).toFixed(1)} MB. Accepted: a document (JSON text) of at most ${MAX_BYTES / 1e6} MB.`);
  const bytes = await file.arrayBuffer();
  try {
    const text = new TextDecoder('utf-8', { fatal: true }).decode(bytes);
    if (!text.includes('\0')) return text;
  } catch {
    // No text: told below.
  }
  throw new RefusedFile('It is not a text. Accepted: a document, which is JSON text in UTF-8.');
}

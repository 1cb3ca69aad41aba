/**
 * The share link's payload: a whole document as text, compressed, in the letters that a fragment may hold.
 *
 * `1.` (version of this form), then in base64url: the CRC-32 of the text's bytes, high byte first, and those bytes
 * compressed by raw deflate (RFC 1951). The sum tells a link that was cut or mistyped from a whole one.
 */
import { Refusal } from './refusal.js';

const VERSION = '1';

/** Bytes of text that a link may unfold to: a few bytes of payload can hold gigabytes of blanks. */
export const MAX_TEXT = 4_000_000;

/** Letters of a payload that a link can have: Chromium opens no address of more than 2 MB, and Firefox of 1 MB. */
export const MAX_PAYLOAD = 1_000_000;

/** The payload is not what was sent; the message is a sentence for a person. */
export class DamagedLink extends Refusal {}

/** @param {string} text @returns {Promise<string>} */
export async function encode(text) {
  const bytes = new TextEncoder().encode(text);
  const packed = await pass(bytes, new CompressionStream('deflate-raw'), Infinity);
  const whole = new Uint8Array(4 + packed.length);
  new DataView(whole.buffer).setUint32(0, crc32(bytes));
  whole.set(packed, 4);
  return `${VERSION}.${toBase64url(whole)}`;
}

/** @param {string} payload @returns {Promise<string>} */
export async function decode(payload) {
  const [, version, letters] = /^(\d+)\.(.*)$/s.exec(payload) ?? [];
  if (!version) throw new DamagedLink('It does not begin with the version of its form.');
  if (version !== VERSION) throw new DamagedLink(`It is of version ${version}; this page reads version ${VERSION}. Reload the page to get its newest version.`);
  if (!/^[\w-]*$/.test(letters)) throw new DamagedLink('There are letters in it that a link never holds.');
  try {
    const whole = fromBase64url(letters);
    const sum = new DataView(whole.buffer).getUint32(0);
    const bytes = await pass(whole.subarray(4), new DecompressionStream('deflate-raw'), MAX_TEXT);
    if (crc32(bytes) === sum) return new TextDecoder('utf-8', { fatal: true }).decode(bytes);
  } catch {
    // Cut short, or letters changed: the one sentence below says it.
  }
  throw new DamagedLink('A part of it is missing or changed: copy it again, whole.');
}

/**
 * @param {Uint8Array<ArrayBuffer>} bytes
 * @param {{readable: ReadableStream<Uint8Array>, writable: WritableStream<BufferSource>}} stream
 * @param {number} limit bytes that may come out
 */
async function pass(bytes, { readable, writable }, limit) {
  const writer = writable.getWriter();
  // The reader meets the same errors and reports them.
  writer.write(bytes).catch(() => {});
  writer.close().catch(() => {});
  /** @type {Uint8Array[]} */
  const parts = [];
  let length = 0;
  const reader = readable.getReader();
  for (;;) {
    const { value, done } = await reader.read();
    if (done) break;
    length += value.length;
    if (length > limit) {
      reader.cancel().catch(() => {});
      throw new RangeError('too long');
    }
    parts.push(value);
  }
  const whole = new Uint8Array(length);
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  return whole;
}

/** @param {Uint8Array} bytes */
function toBase64url(bytes) {
  let letters = '';
  for (const byte of bytes) letters += String.fromCharCode(byte);
  return btoa(letters).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
}

/** @param {string} letters */
const fromBase64url = (letters) => Uint8Array.from(atob(letters.replaceAll('-', '+').replaceAll('_', '/')), (letter) => letter.charCodeAt(0));

/** CRC-32 as in gzip and PNG, bit by bit: links are short. @param {Uint8Array} bytes */
function crc32(bytes) {
  let sum = -1;
  for (const byte of bytes) {
    sum ^= byte;
    for (let bit = 0; bit < 8; bit++) sum = (sum >>> 1) ^ (sum & 1 ? 0xedb88320 : 0);
  }
  return ~sum >>> 0;
}

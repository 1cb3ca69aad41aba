/**
 * Tells a recorded WebM film how long it is: browsers write it as a live stream, without a duration, and players then
 * show no end and cannot seek.
 */

/** EBML ids: the head of a segment, and its duration. */
const INFO = [0x15, 0x49, 0xa9, 0x66];
const DURATION = [0x44, 0x89];

/**
 * The film with its duration put into it; as it was if it has one, or is not built as browsers build it.
 * @param {Uint8Array<ArrayBuffer>} film
 * @param {number} milliseconds the unit that browsers write times in
 * @returns {Uint8Array<ArrayBuffer>}
 */
export function withDuration(film, milliseconds) {
  const at = find(film, INFO, 0, Math.min(film.length, 4096));
  if (at < 0) return film;
  const size = readSize(film, at + INFO.length);
  if (!size) return film;
  const from = at + INFO.length + size.bytes;
  const to = from + size.value;
  if (to > film.length || find(film, DURATION, from, to) >= 0) return film;
  const entry = new Uint8Array(11);
  entry.set([...DURATION, 0x88]);
  new DataView(entry.buffer).setFloat64(3, milliseconds);
  const info = new Uint8Array(8);
  // A size of eight bytes: 0x01, then 56 bits.
  new DataView(info.buffer).setUint32(4, size.value + entry.length);
  info[0] = 0x01;
  const parts = [film.subarray(0, at + INFO.length), info, film.subarray(from, to), entry, film.subarray(to)];
  const whole = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  let place = 0;
  for (const part of parts) {
    whole.set(part, place);
    place += part.length;
  }
  return whole;
}

/** @param {Uint8Array} film @param {number[]} id @param {number} from @param {number} to */
function find(film, id, from, to) {
  for (let at = from; at + id.length <= to; at++) if (id.every((byte, index) => film[at + index] === byte)) return at;
  return -1;
}

/** A size: as many leading zeros as bytes follow the first. @param {Uint8Array} film @param {number} at */
function readSize(film, at) {
  const bytes = Math.clz32(film[at]) - 23;
  if (bytes > 8 || at + bytes > film.length) return null;
  let value = film[at] & (0xff >> bytes);
  for (let index = 1; index < bytes; index++) value = value * 256 + film[at + index];
  return { bytes, value };
}

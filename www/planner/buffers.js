/**
 * What of an answer moves to who asked, instead of being copied.
 */

/** The typed columns' memory. @param {import('./calls.js').Answer} answer */
export function buffers(answer) {
  if (answer.kind !== 'value' || typeof answer.value !== 'object' || answer.value === null) return [];
  return Object.values(answer.value)
    .filter((column) => ArrayBuffer.isView(column))
    .map((column) => column.buffer);
}

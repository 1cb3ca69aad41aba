/**
 * A number as people type it, with a comma or a point; nothing for an empty field; what is no number goes to Rust as it is,
 * which says so.
 * @param {string} typed
 */
export function sizeOf(typed) {
  const text = typed.trim();
  const number = Number(text.replace(',', '.'));
  return text === '' ? undefined : Number.isFinite(number) ? number : text;
}

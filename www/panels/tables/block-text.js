/**
 * Blocks of cells as text, in the forms that spreadsheets read and write.
 */

/** A number with a decimal comma. */
const DECIMAL_COMMA = /^\s*[+\-−–]?\d*,\d+(e[+-]?\d+)?\s*$/i;

/**
 * The cells of a pasted text: rows by lines, columns by tabs, else by semicolons, else by commas where they can only
 * part columns and are not in the parentheses of an expression. Decimal commas become points, unless commas part the columns.
 * @param {string} text
 * @returns {string[][]} rows may differ in length
 */
export function parseBlock(text) {
  const lines = text.replace(/\r\n?/g, '\n').replace(/\n$/, '').split('\n');
  const has = (/** @type {RegExp} */ pattern) => lines.some((line) => pattern.test(line));
  const separator = has(/\t/) ? '\t' : has(/;/) ? ';' : has(/,\s|,.*,/) && !has(/\(/) ? ',' : null;
  return lines.map((line) =>
    (separator === null ? [line] : line.split(separator)).map((cell) => {
      const plain = cell.trim();
      return separator !== ',' && DECIMAL_COMMA.test(plain) ? plain.replace(',', '.') : plain;
    }),
  );
}

/** @param {string[][]} rows */
export const blockText = (rows) => rows.map((cells) => cells.join('\t')).join('\n');

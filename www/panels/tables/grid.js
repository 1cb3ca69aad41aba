/**
 * Where a cell stands among those of its table: the rows that have as many cells as its own. A key frame is one row, though it
 * is shown in two lines.
 */

const ROW = '.key, :not(.key) > tr';

/**
 * @param {HTMLInputElement} field
 * @returns {{rows: HTMLInputElement[][], row: number, column: number} | null} null for a cell in no table
 */
export function gridAt(field) {
  const table = field.closest('table');
  if (!table || !field.dataset.path) return null;
  const cells = (/** @type {Element} */ row) => /** @type {HTMLInputElement[]} */ ([...row.querySelectorAll('input[data-path]')]);
  const own = field.closest(ROW);
  const count = own ? cells(own).length : 0;
  const rows = [...table.querySelectorAll(ROW)].map(cells).filter((row) => row.length === count);
  const row = rows.findIndex((candidate) => candidate.includes(field));
  return row < 0 ? null : { rows, row, column: rows[row].indexOf(field) };
}

/**
 * Moving through a table from the keyboard, as in a spreadsheet: Enter and the up and down arrows go along a column, the
 * left and right arrows leave a cell at the ends of its text. Tab goes along the rows by itself.
 */
import { onKeys } from '../../ui/keys.js';
import { gridAt } from './grid.js';

/** @param {HTMLElement} panel holds tables whose inputs have a `data-column` */
export function gridKeys(panel) {
  /** Along a column. @param {Event} event @param {-1 | 1} step */
  function along({ target: field }, step) {
    if (!(field instanceof HTMLInputElement) || !field.dataset.column) return false;
    const fields = [...(field.closest('table')?.querySelectorAll('input') ?? [])].filter(({ dataset }) => dataset.column === field.dataset.column);
    const next = fields[fields.indexOf(field) + step];
    if (next) next.focus();
    else field.select();
  }

  /** Along a row. @param {Event} event @param {-1 | 1} step */
  function aside({ target: field }, step) {
    if (!(field instanceof HTMLInputElement) || !field.matches('.cell')) return false;
    const whole = field.selectionStart === 0 && field.selectionEnd === field.value.length;
    const end = field.selectionStart === field.selectionEnd && field.selectionStart === (step < 0 ? 0 : field.value.length);
    const at = gridAt(field);
    const next = at?.rows[at.row][at.column + step];
    if (!next || !(whole || end)) return false;
    next.focus();
  }

  onKeys(panel, {
    cell: (event, at) => along(event, at ? 1 : -1),
    keepValue: (event, at) => along(event, at ? -1 : 1),
    cellAside: (event, at) => aside(event, at ? 1 : -1),
  });
}

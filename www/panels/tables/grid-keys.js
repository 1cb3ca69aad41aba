/**
 * Moving through a table from the keyboard, as in a spreadsheet: Enter and the up and down arrows go along a column, the
 * left and right arrows leave a cell at the ends of its text. Tab goes along the rows by itself.
 */
import { gridAt } from './grid.js';

/** @param {HTMLElement} panel holds tables whose inputs have a `data-column` */
export function gridKeys(panel) {
  panel.addEventListener('keydown', (event) => {
    const field = event.target;
    if (!(field instanceof HTMLInputElement) || event.altKey || event.ctrlKey || event.metaKey || event.defaultPrevented) return;
    const aside = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (aside && !event.shiftKey && field.matches('.cell')) {
      const whole = field.selectionStart === 0 && field.selectionEnd === field.value.length;
      const end = field.selectionStart === field.selectionEnd && field.selectionStart === (aside < 0 ? 0 : field.value.length);
      const at = gridAt(field);
      const next = at?.rows[at.row][at.column + aside];
      if (!next || !(whole || end)) return;
      event.preventDefault();
      return next.focus();
    }
    // With Shift an arrow chooses cells.
    if (event.shiftKey && event.key.startsWith('Arrow')) return;
    const step = { ArrowDown: 1, ArrowUp: -1, Enter: event.shiftKey ? -1 : 1 }[event.key];
    const column = field.dataset.column;
    if (!step || !column) return;
    const fields = [...(field.closest('table')?.querySelectorAll('input') ?? [])].filter((f) => f.dataset.column === column);
    const next = fields[fields.indexOf(field) + step];
    event.preventDefault();
    if (next) next.focus();
    else field.select();
  });
}

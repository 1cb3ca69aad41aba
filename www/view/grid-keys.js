/**
 * Moving through a table from the keyboard: Enter and the up and down arrows go along a column, as in a spreadsheet.
 * Tab goes along the rows by itself.
 */

/** @param {HTMLElement} panel holds tables whose inputs have a `data-column` */
export function gridKeys(panel) {
  panel.addEventListener('keydown', (event) => {
    const field = event.target;
    if (!(field instanceof HTMLInputElement) || event.altKey || event.ctrlKey || event.metaKey) return;
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

/**
 * Blocks of cells as in a spreadsheet: pasting one fills the cells from where one is; Shift with the arrows or a click
 * chooses one, to be copied in whole numbers or cleared. Each is one step of undo.
 */
import { blockText, parseBlock } from './block-text.js';
import { element, focusBeside, setText } from '../../ui/dom.js';
import { plural } from '../../core/format.js';
import { valueAt } from '../../core/path.js';
import { gridAt } from './grid.js';

/**
 * @param {HTMLElement} root holds the tables
 * @param {import('../../core/store.js').Store} store
 * @param {ReturnType<typeof import('./cells.js').createCells>} cells
 * @param {import('../../ui/notice.js').Say} say
 */
export function gridBlock(root, store, cells, say) {
  /** The cell where the block began, and the one where it ends. @type {{from: HTMLInputElement, to: HTMLInputElement} | null} */
  let block = null;
  const note = element('p', { class: 'block-note', role: 'status', hidden: true });
  root.append(note);

  const cellOf = (/** @type {EventTarget | null} */ target) => (target instanceof HTMLInputElement && target.matches('.cell') ? target : null);
  const size = (/** @type {number} */ rows, /** @type {number} */ columns) => `${plural(rows, 'row')} of ${plural(columns, 'cell')}`;

  /** The fields of the block, row by row. */
  function chosen() {
    const [a, b] = [block && gridAt(block.from), block && gridAt(block.to)];
    if (!a || !b) return [];
    const between = (/** @type {number} */ one, /** @type {number} */ other) => [Math.min(one, other), Math.max(one, other) + 1];
    return a.rows.slice(...between(a.row, b.row)).map((row) => row.slice(...between(a.column, b.column)));
  }

  /** @param {HTMLInputElement | null} from @param {HTMLInputElement} [to] */
  function choose(from, to) {
    for (const old of root.querySelectorAll('.in-block')) old.classList.remove('in-block');
    block = from && to && from !== to ? { from, to } : null;
    const rows = chosen();
    for (const field of rows.flat()) field.classList.add('in-block');
    note.hidden = rows.length === 0;
    setText(note, rows.length ? `${size(rows.length, rows[0].length)} chosen` : '');
  }

  /** Writes texts into fields, as one edit. @param {[HTMLInputElement, string][]} texts */
  const write = (texts) =>
    store.edit((doc) => texts.reduce((next, [field, text]) => cells.written(next, field.dataset.path ?? '', text), doc));

  root.addEventListener('paste', (event) => {
    if (store.readonly) return;
    const field = cellOf(event.target);
    const at = field && gridAt(field);
    const text = event.clipboardData?.getData('text/plain') ?? '';
    const rows = parseBlock(text);
    const columns = Math.max(...rows.map((row) => row.length));
    // One value is typed as usual; a whole document is not for a cell.
    if (!at || (rows.length === 1 && columns === 1) || /^\s*[{[]/.test(text)) return;
    event.preventDefault();
    event.stopPropagation();
    const room = { rows: at.rows.length - at.row, columns: at.rows[at.row].length - at.column };
    if (rows.length > room.rows || columns > room.columns) {
      say(`The pasted block has ${size(rows.length, columns)}; from this cell on there is room for ${size(room.rows, room.columns)}. Nothing was written: paste it further up or to the left, or make it smaller.`);
      return;
    }
    write(rows.flatMap((row, r) => row.map((value, c) => /** @type {[HTMLInputElement, string]} */ ([at.rows[at.row + r][at.column + c], value]))));
    say(`${size(rows.length, columns)} pasted.`, { label: 'Undo', act: () => store.undo() });
  });

  root.addEventListener('copy', (event) => {
    if (!block) return;
    const text = (/** @type {HTMLInputElement} */ { dataset }) => String(valueAt(store.doc, dataset.path ?? '') ?? '');
    event.clipboardData?.setData('text/plain', blockText(chosen().map((row) => row.map(text))));
    event.preventDefault();
  });

  root.addEventListener('keydown', (event) => {
    const field = cellOf(event.target);
    if (!field || event.altKey || event.ctrlKey || event.metaKey) return;
    const step = { ArrowUp: [-1, 0], ArrowDown: [1, 0], ArrowLeft: [0, -1], ArrowRight: [0, 1] }[event.key];
    // Within a text that is being changed, Shift with left and right chooses letters.
    const whole = field.selectionStart === 0 && field.selectionEnd === field.value.length;
    if (step && event.shiftKey && (block || whole || step[0])) {
      const at = gridAt(block?.to ?? field);
      const to = at?.rows[at.row + step[0]]?.[at.column + step[1]];
      if (to) choose(block?.from ?? field, to);
    } else if (block && (event.key === 'Delete' || event.key === 'Backspace')) {
      write(chosen().flat().map((cell) => [cell, '']));
      choose(null);
    } else if (block && event.key === 'Escape') {
      choose(null);
    } else {
      if (block && event.key !== 'Shift') choose(null);
      return;
    }
    event.preventDefault();
    event.stopImmediatePropagation();
  }, true);

  root.addEventListener('pointerdown', (event) => {
    const to = cellOf(event.target);
    const from = cellOf(focusBeside(root));
    if (!event.shiftKey || !to || !from || from.closest('table') !== to.closest('table')) return choose(null);
    event.preventDefault();
    choose(from, to);
  });
  root.addEventListener('focusout', () => choose(null));
}

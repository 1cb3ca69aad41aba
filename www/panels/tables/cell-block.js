/**
 * Blocks of cells as in a spreadsheet: pasting one fills the cells from where one is; Shift with the arrows or a click
 * chooses one, to be copied in whole numbers or cleared. Each is one step of undo.
 */
import { keyFramesOf } from '../../core/key-frames.js';
import { blockText, parseBlock } from './block-text.js';
import { entry } from '../../core/edits.js';
import { addKeyFrame, setTimes } from '../../core/key-frame-edits.js';
import { element, focusBeside, setText } from '../../ui/dom.js';
import { onKeys } from '../../ui/keys.js';
import { plural } from '../../core/format.js';
import { valueAt, withValueAt } from '../../core/path.js';
import { sayUndo } from '../../core/undo.js';
import { gridAt } from './grid.js';
import { placed } from './paste.js';
import { wear } from '../../ui/style-sheets.js';
import look from '../../style/block.css?inline';

/** @typedef {import('../../core/types.js').MechanismDocument} MechanismDocument */

/** Where each arrow key goes, rows down and cells to the right, in the order of the list of keys. */
const ARROWS = [[0, -1], [0, 1], [-1, 0], [1, 0]];

/** Lists that grow with what is pasted into their rows. */
const GROWING = /^(motion\.key_frames|motion\.drivers\[\d+\]\.values)\[\d+\]/;
/** Rows that a pasted block may add: each is written cell by cell. */
const MOST_ROWS = 1_000;
const KEY_FRAMES = 'motion.key_frames';
const TIME = /^motion\.key_frames\[(\d+)\]\.time$/;

/**
 * @param {HTMLElement} root holds the tables
 * @param {import('../../core/store.js').Store} store
 * @param {ReturnType<typeof import('./cells.js').createCells>} cells
 * @param {import('../../ui/notice.js').Say} say
 */
export function gridBlock(root, store, cells, say) {
  /** The cell where the block began, and the one where it ends. @type {{from: HTMLInputElement, to: HTMLInputElement} | null} */
  let block = null;
  wear(/** @type {ShadowRoot} */ (root.getRootNode()), look);
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

  /** The document with texts written into cells. @param {MechanismDocument} doc @param {[path: string, text: string][]} texts */
  function written(doc, texts) {
    // Times stand in all key frames or in none, so they are written together.
    const times = texts.flatMap(([path, text]) => {
      const key = TIME.exec(path)?.[1];
      return key ? [/** @type {[number, import('../../core/types.js').Entry | undefined]} */ ([Number(key), text === '' ? undefined : entry(text)])] : [];
    });
    const rest = texts.reduce((next, [path, text]) => (TIME.test(path) ? next : cells.written(next, path, text)), doc);
    return times.length ? setTimes(rest, times) : rest;
  }

  /**
   * The document with more rows of a list, each like the last, for a pasted block to be written into.
   * @param {MechanismDocument} doc @param {string} list @param {number} more
   */
  function withMore(doc, list, more) {
    const rows = list === KEY_FRAMES ? [] : valueAt(doc, list);
    if (rows?.length && more) return withValueAt(doc, list, [...rows, ...Array.from({ length: more }, () => rows[rows.length - 1])]);
    let next = doc;
    for (let i = 0; i < more; i++) next = addKeyFrame(next, keyFramesOf(next)[keyFramesOf(next).length - 1]);
    return next;
  }

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
    const path = field.dataset.path ?? '';
    const own = at.rows[at.row];
    const list = GROWING.exec(path)?.[1];
    const plan = placed(rows, {
      columns: own.map((cell) => cell.dataset.column ?? ''),
      rows: at.rows.length,
      row: at.row,
      column: at.column,
      grows: list !== undefined,
    });
    const { room } = plan;
    if (room) {
      say(`The pasted block has ${size(plan.rows, plan.width)}; from this cell on there is room for ${size(room.rows, room.columns)}. Nothing was written: paste it further up or to the left, or make it smaller.`);
      return;
    }
    // In rows that are not there yet, cells have the names of those above them.
    const place = (/** @type {import('./paste.js').Pasted} */ { row, column }) =>
      at.rows[row]?.[column].dataset.path ?? (own[column].dataset.path ?? '').replace(GROWING, `$1[${row}]`);
    // Only a part of many rows is in the table.
    if (list && (plan.more > MOST_ROWS || (plan.more > 0 && valueAt(store.doc, list).length > at.rows.length))) {
      say(`The pasted block has ${plural(plan.rows, 'row')}, and from this cell on there is room for ${at.rows.length - at.row} in the table. Nothing was written${list === KEY_FRAMES ? ': use From a table…, below the key frames' : ''}.`);
      return;
    }
    const { doc: former } = store;
    store.edit((doc) => written(withMore(doc, list ?? '', plan.more), plan.cells.map((cell) => [place(cell), cell.text])));
    const added = plan.more ? ` ${plural(plan.more, list === KEY_FRAMES ? 'key frame' : 'value')} added.` : '';
    sayUndo({ store, say }, former, `${size(plan.rows, plan.width)} pasted.${added}${plan.head ? ' The row of heads was skipped.' : ''}`);
  });

  root.addEventListener('copy', (event) => {
    if (!block) return;
    const text = (/** @type {HTMLInputElement} */ { dataset }) => String(valueAt(store.doc, dataset.path ?? '') ?? '');
    event.clipboardData?.setData('text/plain', blockText(chosen().map((row) => row.map(text))));
    event.preventDefault();
  });

  /** Only with a block, and then for nobody else. @param {() => void} act @returns {import('../../ui/keys.js').Handler} */
  const withBlock = (act) => (event) => {
    if (!block) return false;
    event.stopImmediatePropagation();
    act();
  };
  onKeys(root, {
    block(event, arrow) {
      const field = cellOf(event.target);
      if (!field) return false;
      const [down, right] = ARROWS[arrow];
      // Within a text that is being changed, Shift with left and right chooses letters.
      const whole = field.selectionStart === 0 && field.selectionEnd === field.value.length;
      if (!block && !whole && right) return false;
      event.stopImmediatePropagation();
      const at = gridAt(block?.to ?? field);
      const to = at?.rows[at.row + down]?.[at.column + right];
      if (to) choose(block?.from ?? field, to);
    },
    clearBlock: withBlock(() => {
      const texts = chosen().flat().map((cell) => /** @type {[string, string]} */ ([cell.dataset.path ?? '', '']));
      store.edit((doc) => written(doc, texts));
      choose(null);
    }),
    oldValue: withBlock(() => choose(null)),
  }, { capture: true });
  // Whatever else is typed goes into one cell.
  root.addEventListener('keydown', ({ key, altKey, ctrlKey, metaKey }) => {
    if (block && key !== 'Shift' && !altKey && !ctrlKey && !metaKey) choose(null);
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

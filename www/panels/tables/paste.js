/**
 * Where a pasted block of cells goes in a grid: a row of heads is skipped, and names the columns where it names columns of
 * the grid.
 *
 * @typedef {{row: number, column: number, text: string}} Pasted
 */

/** What spreadsheets call the columns of the tables. @type {Record<string, string>} */
const COLUMNS = { t: 'time', lon: 'longitude', lat: 'latitude', α: 'alpha', θ: 'theta' };

/** A column's name without its unit: "x (mm)", "lon [°]", "time / s". @param {string} head */
function columnOf(head) {
  const plain = head.toLowerCase().replace(/[([/°].*$/, '').trim();
  return COLUMNS[plain] ?? plain;
}

/** @param {string | undefined} text */
const isNumber = (text) => !!text && Number.isFinite(Number(text.replace(/^[−–]/, '-')));

/** Columns that hold texts. */
const TEXTS = ['name'];

/**
 * The columns that a block's first row names; null if it is a row like the others.
 * @param {string[][]} rows
 * @param {string[]} columns of the grid
 * @param {number} column where the block is pasted
 * @returns {number[] | null} for each column of the block one of the grid, -1 where it has no head
 */
function heads([first, second], columns, column) {
  const named = first.map((head) => (head ? columns.indexOf(columnOf(head)) : -1));
  const positions = first.map((_, index) => column + index);
  if (!second || first.some(isNumber)) return null;
  const known = first.every((head, index) => head === '' || named[index] >= 0) && new Set(named).size === named.length;
  if (known && named.some((at) => at >= 0)) return named;
  // Words over numbers: where every number of the second row has one above it.
  const over = positions.filter((at, index) => !TEXTS.includes(columns[at]) && isNumber(second[index]));
  return over.length && over.every((at) => first[at - column] !== '') ? positions : null;
}

/**
 * @param {string[][]} block
 * @param {{columns: string[], rows: number, row: number, column: number, grows: boolean}} grid with the cell that the block is
 *   pasted from; one that grows has room for any number of rows
 * @returns {{cells: Pasted[], rows: number, width: number, more: number, head: boolean, room: {rows: number, columns: number} | null}}
 *   `more` rows are needed than there are; `room` is what there is, where it is too little
 */
export function placed(block, { columns, rows, row, column, grows }) {
  const named = heads(block, columns, column);
  const body = named ? block.slice(1) : [...block];
  // Spreadsheets copy empty rows too.
  while (body.length > 1 && body[body.length - 1].every((text) => text === '')) body.pop();
  const width = Math.max(...body.map((texts) => texts.length));
  const to = named ?? Array.from({ length: width }, (_, index) => column + index);
  const room = { rows: rows - row, columns: columns.length - column };
  const tooLarge = to.some((at) => at >= columns.length) || width > to.length || (!grows && body.length > room.rows);
  const cells = body.flatMap((texts, r) => texts.map((text, c) => ({ row: row + r, column: to[c], text })).filter((cell) => cell.column >= 0));
  return { cells, rows: body.length, width, more: Math.max(0, row + body.length - rows), head: named !== null, room: tooLarge ? room : null };
}

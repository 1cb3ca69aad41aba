// Blocks of cells, as spreadsheets write them.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { setTimes } from '../../www/core/key-frame-edits.js';
import { allFaults } from '../../www/panels/tables/all-faults.js';
import { blockText, parseBlock } from '../../www/panels/tables/block-text.js';
import { numberHint } from '../../www/panels/tables/number-hint.js';
import { placed } from '../../www/panels/tables/paste.js';

test('tabs part columns and lines part rows; the last line end counts for nothing', () => {
  assert.deepEqual(parseBlock('1\t2.5\r\n-3\tabc\r\n'), [['1', '2.5'], ['-3', 'abc']]);
  assert.deepEqual(parseBlock('1\t\t3'), [['1', '', '3']]);
  assert.deepEqual(parseBlock('7'), [['7']]);
});

test('semicolons part columns too, and decimal commas are read', () => {
  assert.deepEqual(parseBlock('1,5;2\n-0,25;,5'), [['1.5', '2'], ['-0.25', '.5']]);
  assert.deepEqual(parseBlock('1,5\t2,25'), [['1.5', '2.25']]);
  assert.deepEqual(parseBlock('1,5\n2'), [['1.5'], ['2']]);
});

test('commas part columns only where they can do nothing else', () => {
  assert.deepEqual(parseBlock('1,2,3\n4,5,6'), [['1', '2', '3'], ['4', '5', '6']]);
  assert.deepEqual(parseBlock('1, 2'), [['1', '2']]);
});

test('a block written is a block read', () => {
  const rows = [['1', '-2.5', ''], ['abc', '0.1', '7']];
  assert.deepEqual(parseBlock(blockText(rows)), rows);
});

const KEYS = { columns: ['name', 'time', 'x', 'y', 'z', 'longitude', 'latitude', 'roll'], rows: 3, row: 1, column: 0, grows: true };

test('a block takes its place in a grid, and asks for more rows where the grid grows', () => {
  const block = [['a', '1', '2'], ['b', '3', '4'], ['c', '5', '6'], ['', '', '']];
  const plan = placed(block, KEYS);
  assert.deepEqual([plan.more, plan.rows, plan.head, plan.room], [1, 3, false, null]);
  assert.deepEqual(plan.cells.slice(-3), [{ row: 3, column: 0, text: 'c' }, { row: 3, column: 1, text: '5' }, { row: 3, column: 2, text: '6' }]);
  assert.deepEqual(placed(block, { ...KEYS, grows: false }).room, { rows: 2, columns: 8 });
  assert.deepEqual(placed(block, { ...KEYS, column: 6 }).room, { rows: 2, columns: 2 });
});

test('a row of heads is skipped and names the columns, with units and in any order', () => {
  const plan = placed([['Name', 'x [mm]', 'lon (°)', 'z/mm'], ['a', '1', '2', '3']], { ...KEYS, column: 0 });
  assert.equal(plan.head, true);
  assert.deepEqual(plan.cells.map(({ column }) => column), [0, 2, 5, 4]);
  assert.equal(plan.more, 0);
  // Words that name no column stand over the cells they are pasted on.
  const other = placed([['Weg', 'Höhe'], ['1', '2']], { ...KEYS, column: 2 });
  assert.deepEqual([other.head, other.cells.map(({ column }) => column)], [true, [2, 3]]);
  // A row with a number in it, or the only one, is no row of heads.
  assert.equal(placed([['abc', '1'], ['2', '3']], { ...KEYS, column: 2 }).head, false);
  assert.equal(placed([['x', 'y']], { ...KEYS, column: 2 }).head, false);
  assert.equal(placed([['begin'], ['end']], KEYS).head, false);
});

test('pasted times stand as they are; a missing one is left for the planner to tell', () => {
  const doc = { motion: { key_frames: [{ x: 1 }, { x: 2 }, { x: 3 }] } };
  const times = (list) => setTimes(doc, list).motion.key_frames.map(({ time }) => time);
  assert.deepEqual(times([[0, 5], [1, undefined], [2, 9]]), [5, undefined, 9]);
  assert.deepEqual(times([[1, 4], [2, 6]]), [0, 4, 6], 'those that are not pasted are made up');
  assert.deepEqual(times([[0, undefined], [1, undefined]]), [undefined, undefined, undefined]);
  assert.deepEqual(times([[0, 'abc'], [1, 2], [2, 3]]), ['abc', 2, 3]);
});

test('all bad cells are found, each with its own fault, and none that a filled-in number makes', async () => {
  const doc = { motion: { key_frames: [{ time: 0, x: 'one' }, { time: 'abc', x: 2 }, { time: 1, x: 'two' }] } };
  /** As the planner does: the first fault, in the document's order. */
  const check = async ({ motion: { key_frames: keys } }) => {
    for (const [index, { time, x }] of keys.entries()) {
      const where = `motion.key_frames[${index}]`;
      if (typeof time !== 'number') return { where: `${where}.time` };
      if (typeof x !== 'number') return { where: `${where}.x` };
      if (index && time <= keys[index - 1].time) return { where: `${where}.time` };
    }
    return null;
  };
  const found = await allFaults(doc, await check(doc), check);
  assert.deepEqual(found.map(({ where }) => where), ['motion.key_frames[0].x', 'motion.key_frames[1].time', 'motion.key_frames[2].x']);
  const whole = { where: 'chains' };
  assert.deepEqual(await allFaults(doc, whole, check), [whole], 'what cannot be filled in ends the search');
});

test('what was meant as a number is told as it is to be written', () => {
  const hints = { '1,8': 'Write a point: 1.8.', '-,5': 'Write a point: -0.5.', '1.8 m': 'Write the number alone: 1.8.', '90°': 'Write the number alone: 90.', '−1,8 mm': 'Write the number alone, with a point: -1.8.' };
  for (const [text, hint] of Object.entries(hints)) assert.equal(numberHint(text), hint, text);
  for (const text of ['abc', '', '1e999', '1/2', '1,2,3', '-', '.']) assert.equal(numberHint(text), '', text);
});

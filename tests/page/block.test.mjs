// Blocks of cells, as spreadsheets write them.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { blockText, parseBlock } from '../../www/panels/tables/block-text.js';

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

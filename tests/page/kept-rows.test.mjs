// Rows of a long table: an edit makes anew only those in which something changed.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { createKeptRows } from '../../www/panels/tables/kept-rows.js';

/** Stands for the tables' cells: which are known, and which were made. */
function fakeCells() {
  const known = new Set();
  return {
    known,
    noting: (make) => ({ made: make(), specs: [{ path: `made ${known.size}` }] }),
    know: (specs) => specs.forEach((spec) => known.add(spec)),
  };
}

test('of a thousand rows an edit makes the one that it changed', () => {
  const cells = fakeCells();
  const rows = createKeptRows(cells);
  const made = [];
  const show = (items, unit) => rows(items.map((item, index) => ({ key: index, of: [item, unit], make: () => made.push(index) })));
  const items = Array.from({ length: 1000 }, (_, x) => ({ x }));
  show(items, 'm');
  assert.equal(made.length, 1000);
  made.length = 0;
  show(items.map((item, index) => (index === 7 ? { x: -1 } : item)), 'm');
  assert.deepEqual(made, [7]);
  assert.equal(cells.known.size, 999, 'the cells of the others are known as before');
  made.length = 0;
  show(items, 'mm');
  assert.equal(made.length, 1000, 'what all show is another');
});

test('a row that has gone is forgotten', () => {
  const rows = createKeptRows(fakeCells());
  const made = [];
  const show = (keys) => rows(keys.map((key) => ({ key, of: [], make: () => made.push(key) })));
  show(['a', 'b']);
  show(['b']);
  show(['a', 'b']);
  assert.deepEqual(made, ['a', 'b', 'a']);
});

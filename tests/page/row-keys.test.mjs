// The rows of the tables keep their keys over edits.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { createRowKeys } from '../../www/panels/tables/row-keys.js';

const row = (name, time) => ({ name, ...(time === undefined ? {} : { time }) });
const [a, b, c] = ['a', 'b', 'c'].map((name) => row(name));

test('a row that is inserted, removed or moved leaves the others their keys', () => {
  const keys = createRowKeys();
  const [ka, kb, kc] = keys([a, b, c]);
  assert.equal(new Set([ka, kb, kc]).size, 3);
  const [first, fresh, ...rest] = keys([a, row('new'), b, c]);
  assert.deepEqual([first, ...rest], [ka, kb, kc]);
  assert.ok(![ka, kb, kc].includes(fresh));
  assert.deepEqual(keys([c, a, b]), [kc, ka, kb]);
  assert.deepEqual(keys([c, b]), [kc, kb]);
  const back = keys([c, a, b]);
  assert.deepEqual([back[0], back[2]], [kc, kb]);
  assert.ok(![kb, kc].includes(back[1]), 'a row that comes back is a new one');
});

test('a row that is changed where it stands keeps its key', () => {
  const keys = createRowKeys();
  const before = keys([a, b, c]);
  assert.deepEqual(keys([a, row('other'), c]), before);
  assert.deepEqual(keys([row('a2'), row('b2'), row('c2')]), before, 'also where all change, as in another unit');
});

test('equal rows are told apart, and rows written anew are found by what they say', () => {
  const keys = createRowKeys();
  const [one, two] = keys([a, a]);
  assert.notEqual(one, two);
  assert.equal(new Set(keys([a, a, a])).size, 3);
  const plain = createRowKeys();
  const [ka, kb] = plain([a, b]);
  assert.deepEqual(plain([row('b'), row('a')]), [kb, ka]);
});

test('the part of a row that stays where it is does not count', () => {
  const keys = createRowKeys(({ time: _, ...rest }) => rest);
  const [ka, kb] = keys([row('a', 0), row('b', 1)]);
  assert.deepEqual(keys([row('b', 0), row('a', 1)]), [kb, ka]);
});

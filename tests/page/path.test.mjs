// Paths into documents.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { covers, parsePath, valueAt, withValueAt } from '../../www/core/path.js';

test('a path is read as a fault writes it', () => {
  assert.deepEqual(parsePath('chains[1].joints[0].rows[0].alpha'), ['chains', 1, 'joints', 0, 'rows', 0, 'alpha']);
  assert.deepEqual(parsePath(''), []);
});

test('a value is read, and nothing where the path leads nowhere', () => {
  assert.equal(valueAt({ a: [{ b: 3 }] }, 'a[0].b'), 3);
  assert.equal(valueAt({ a: [] }, 'a[2].b'), undefined);
});

test('setting copies the way to the place and shares the rest', () => {
  const old = { a: [{ b: 1 }, { b: 2 }], c: {} };
  const next = withValueAt(old, 'a[1].b', 5);
  assert.deepEqual(next, { a: [{ b: 1 }, { b: 5 }], c: {} });
  assert.equal(old.a[1].b, 2);
  assert.equal(next.a[0], old.a[0]);
  assert.equal(next.c, old.c);
  assert.deepEqual(withValueAt({ a: 1, b: 2 }, 'b', undefined), { a: 1 });
  assert.deepEqual(withValueAt({}, 'a[0].b', 1), { a: [{ b: 1 }] });
});

test('a container covers what is in it, not what begins with the same letters', () => {
  assert.ok(covers('chains[1]', 'chains[1].name') > 0);
  assert.ok(covers('chains', 'chains[1].name') > 0);
  assert.equal(covers('chains[1]', 'chains[10].name'), -1);
  assert.equal(covers('chains[1].joints[0].rows[0].a', 'chains[1].joints[0].rows[0].alpha'), -1);
  assert.ok(covers('a.b', 'a.b') > covers('a', 'a.b'));
});

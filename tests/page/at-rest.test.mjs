// What is only read waits while a hand moves something, and hears of the last state once.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { atRest } from '../../www/core/at-rest.js';
import { createStore } from '../../www/core/store.js';

const named = (name) => ({ version: 1, name, chains: [], motion: { key_frames: [] } });

function made(parts) {
  const store = createStore(named('a'));
  const heard = [];
  atRest(store, parts, () => heard.push(store.doc.name), () => heard.push('meanwhile'));
  return { store, heard };
}

test('without a hand it is told at once', () => {
  const { store, heard } = made(['document']);
  store.edit(() => named('b'));
  assert.deepEqual(heard, ['b']);
});

test('while a hand moves it is told once, afterwards; what is done meanwhile is done at every change', () => {
  const { store, heard } = made(['document']);
  store.setView({ moving: 'motion.key_frames[1]' });
  store.edit(() => named('b'));
  store.edit(() => named('c'));
  assert.deepEqual(heard, ['meanwhile', 'meanwhile']);
  store.setView({ moving: '' });
  assert.deepEqual(heard, ['meanwhile', 'meanwhile', 'c']);
  store.setView({ frame: 2 });
  assert.equal(heard.length, 3, 'it is told no more than once');
});

test('a hand that changed nothing tells nothing', () => {
  const { store, heard } = made(['document']);
  store.setView({ moving: 'workpiece' });
  store.setView({ moving: '' });
  assert.deepEqual(heard, []);
});

test('of several parts it hears once of all that came meanwhile', () => {
  const { store, heard } = made(['result', 'view']);
  store.setView({ moving: 'workpiece' });
  heard.length = 0;
  store.setView({ frame: 1 });
  store.setResult({ trouble: 'x' });
  store.setView({ moving: '' });
  assert.deepEqual(heard, ['meanwhile', 'meanwhile', 'a']);
});

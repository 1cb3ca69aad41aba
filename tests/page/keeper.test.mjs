// The work that is kept in the browser: comes back, fits, and never overwrites another page's.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { createKeeper } from '../../www/app/files/browser-storage.js';

/** A storage with room for so many characters. */
function storageOf(room = Infinity) {
  const items = new Map();
  return {
    getItem: (key) => items.get(key) ?? null,
    removeItem: (key) => void items.delete(key),
    setItem(key, text) {
      const others = [...items].filter(([name]) => name !== key).reduce((sum, [, kept]) => sum + kept.length, 0);
      if (others + text.length > room) throw new DOMException('full', 'QuotaExceededError');
      items.set(key, text);
    },
    items,
  };
}
const named = (name) => ({ version: 1, name, chains: [], motion: { key_frames: [] } });
const work = (name, past = []) => ({ doc: named(name), past: past.map(named), future: [], good: null, title: '', unsaved: past.length > 0 });

test('the work comes back with its undo steps', () => {
  const storage = storageOf();
  const keeper = createKeeper(() => storage, 'a');
  assert.deepEqual(keeper.load(), { work: null, broken: '' });
  assert.ok(keeper.save(work('b', ['a'])));
  assert.deepEqual(createKeeper(() => storage, 'b').load(), { work: work('b', ['a']), broken: '' });
});

test('where the undo steps do not fit, the document is kept', () => {
  const storage = storageOf(3000);
  const keeper = createKeeper(() => storage, 'a');
  assert.ok(keeper.save(work('last', Array(60).fill('x'.repeat(100)))));
  const { work: kept } = keeper.load();
  assert.equal(kept.doc.name, 'last');
  assert.equal(kept.past.length, 8);
});

test('a full or forbidden storage is told', () => {
  const full = storageOf(50);
  assert.equal(createKeeper(() => full, 'a').save(work('a')), false);
  const forbidden = createKeeper(() => {
    throw new DOMException('no', 'SecurityError');
  }, 'a');
  assert.deepEqual(forbidden.load(), { work: null, broken: '' });
  assert.equal(forbidden.save(work('a')), false);
  assert.deepEqual(forbidden.earlier(), []);
});

test('a broken text is put aside, whole', () => {
  for (const broken of ['{', 'a 1\n{"document": {"chains": 3}}', 'a 1\n{"document": {"chains": [5], "motion": {"key_frames": []}}}', 'null']) {
    const storage = storageOf();
    storage.setItem('synthetica.work.1', broken);
    const keeper = createKeeper(() => storage, 'a');
    assert.deepEqual(keeper.load(), { work: null, broken });
    assert.deepEqual(keeper.earlier().map(({ doc, text }) => [doc, text]), [[undefined, broken]]);
    assert.deepEqual(keeper.load(), { work: null, broken: '' });
  }
});

test("another page's work goes onto the shelf before it is overwritten, its newest state only", () => {
  const storage = storageOf();
  const a = createKeeper(() => storage, 'a');
  const b = createKeeper(() => storage, 'b');
  a.load();
  b.load();
  a.save(work('a1', ['a']));
  b.save(work('b1', ['b']));
  a.save(work('a2', ['a']));
  b.save(work('b2', ['b']));
  assert.deepEqual(b.earlier().map(({ doc }) => doc.name), ['a2', 'b1']);
  assert.ok(a.isOthers({ key: 'synthetica.work.1', newValue: storage.getItem('synthetica.work.1') }));
  assert.ok(!b.isOthers({ key: 'synthetica.work.1', newValue: storage.getItem('synthetica.work.1') }));
});

test('work that was not shown goes onto the shelf; what nobody changed does not', () => {
  const storage = storageOf();
  const first = createKeeper(() => storage, 'a');
  first.save(work('mine', ['sample']));
  const next = createKeeper(() => storage, 'b');
  next.load();
  next.disown();
  next.save(work('from a link'));
  assert.deepEqual(next.earlier().map(({ doc }) => doc.name), ['mine']);
  next.disown();
  next.save(work('another'));
  assert.equal(next.earlier().length, 1);
});

test('what cannot be put onto the shelf is not overwritten', () => {
  const storage = storageOf(400);
  createKeeper(() => storage, 'a').save(work('x'.repeat(100), ['y']));
  assert.equal(createKeeper(() => storage, 'b').save(work('z')), false);
  assert.equal(createKeeper(() => storage, 'c').load().work.doc.name[0], 'x');
});

test('kept work that cannot be shown goes onto the shelf, changed or not; what stands there stays', () => {
  const storage = storageOf();
  createKeeper(() => storage, 'a').save(work('at fault'));
  storage.setItem('synthetica.earlier.1', JSON.stringify([{ when: 1, by: '', title: '', text: '{' }]));
  // Of an earlier version of the page.
  storage.setItem('synthetica.broken', '[');
  const keeper = createKeeper(() => storage, 'b');
  keeper.load();
  keeper.setAside();
  assert.deepEqual(keeper.load(), { work: null, broken: '' });
  assert.deepEqual(keeper.earlier().map(({ doc, text }) => doc?.name ?? text), ['at fault', '{', '[']);
});

test('where the shelf is full, what cannot be read stays, and nothing is kept in its place', () => {
  const storage = storageOf(120);
  const broken = `x 1\n${'?'.repeat(80)}`;
  storage.setItem('synthetica.work.1', broken);
  const keeper = createKeeper(() => storage, 'a');
  assert.deepEqual(keeper.load(), { work: null, broken });
  assert.equal(keeper.save(work('z')), false);
  assert.equal(storage.getItem('synthetica.work.1'), broken);
});

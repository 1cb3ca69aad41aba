// One Ctrl+Z takes back what came last, a posture by hand before an edit of the document; a notice one step, while it is the last.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { sayUndo, undoOne } from '../../www/core/undo.js';
import { createStore } from '../../www/core/store.js';

test('a posture by hand is given back before an edit is undone', () => {
  const store = createStore({ version: 1, chains: [], motion: { key_frames: [] } });
  store.edit((doc) => ({ ...doc, name: 'changed' }));
  store.setView({ posture: { status: 'reached' } });
  undoOne(store);
  assert.equal(store.view.posture, null);
  assert.equal(store.doc.name, 'changed', 'the document is as it was');
  undoOne(store);
  assert.equal(store.doc.name, undefined);
});

test('an iterate of the planner is not by hand: the edit is undone', () => {
  const store = createStore({ version: 1, chains: [], motion: { key_frames: [] } });
  store.edit((doc) => ({ ...doc, name: 'changed' }));
  store.setView({ posture: { status: 'stalled', note: 'Iterate 2 of 9.' } });
  undoOne(store);
  assert.equal(store.doc.name, undefined);
});

const rename = (name) => (doc) => ({ ...doc, name });

/** A store with two edits, the second told by a notice; `offered` is the notice's action, null when it has gone. */
function told(change = rename('second')) {
  const store = createStore({ version: 1, name: 'first', chains: [], motion: { key_frames: [] } });
  store.edit(rename('former'));
  const { doc } = store;
  store.edit(change);
  const notice = { text: '', offered: null };
  const say = (text, { act, until } = {}) => {
    Object.assign(notice, { text, offered: act ?? null });
    until?.(() => Object.assign(notice, { offered: null }));
  };
  sayUndo({ store, say }, doc, 'Renamed.');
  return { store, notice };
}

test('a notice undoes its own step, once', () => {
  const { store, notice } = told();
  assert.equal(notice.text, 'Renamed.');
  notice.offered();
  assert.equal(store.doc.name, 'former');
  assert.equal(notice.offered, null);
});

for (const [what, then] of [
  ['another edit', (store) => store.edit(rename('third'))],
  ['an undo', (store) => store.undo()],
  ['another document', (store) => store.open({ ...store.doc, name: 'other' }, { title: '', handle: null, saved: null })],
]) {
  test(`${what} takes the notice’s undo away, for good`, () => {
    const { store, notice } = told();
    store.setView({ frame: 3 });
    assert.notEqual(notice.offered, null, 'what is no step leaves it');
    then(store);
    assert.equal(notice.offered, null);
    store.undo();
    store.redo();
    assert.equal(notice.offered, null);
  });
}

test('what changed nothing offers no undo', () => {
  const { store, notice } = told((doc) => doc);
  assert.deepEqual(notice, { text: 'Renamed.', offered: null });
  assert.equal(store.doc.name, 'former');
});

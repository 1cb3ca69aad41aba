// One Ctrl+Z takes back what came last: a posture by hand before an edit of the document.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { undoOne } from '../../www/core/undo.js';
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

// Document, result and view: history and subscriptions.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { createStore } from '../../www/core/store.js';

const named = (name) => ({ version: 1, name, chains: [], motion: { key_frames: [] } });
const rename = (name) => (doc) => ({ ...doc, name });

test('undo and redo walk through the edits', () => {
  const store = createStore(named('a'));
  store.edit(rename('b'));
  store.edit(rename('c'));
  store.undo();
  assert.equal(store.doc.name, 'b');
  store.undo();
  assert.equal(store.doc.name, 'a');
  assert.equal(store.canUndo, false);
  store.undo();
  assert.equal(store.doc.name, 'a');
  store.redo();
  store.redo();
  assert.equal(store.doc.name, 'c');
  assert.equal(store.canRedo, false);
});

test('a new edit ends what could be redone', () => {
  const store = createStore(named('a'));
  store.edit(rename('b'));
  store.undo();
  store.edit(rename('c'));
  assert.equal(store.canRedo, false);
});

test('an edit that changes nothing is no step', () => {
  const store = createStore(named('a'));
  let told = 0;
  store.subscribe('document', () => told++);
  store.edit(rename('a'));
  assert.equal(told, 0);
  assert.equal(store.canUndo, false);
});

test('edits of one stay in a cell are undone together', () => {
  const store = createStore(named('a'));
  for (const name of ['b', 'bc', 'bcd']) store.edit(rename(name), 'visit 1');
  store.edit(rename('x'), 'visit 2');
  store.undo();
  assert.equal(store.doc.name, 'bcd');
  store.undo();
  assert.equal(store.doc.name, 'a');
});

test('typed and taken back leaves nothing to undo', () => {
  const store = createStore(named('a'));
  store.edit(rename('b'), 'visit 1');
  store.edit(rename('a'), 'visit 1');
  assert.equal(store.canUndo, false);
});

const file = (title, saved) => ({ title, handle: null, saved });

test('another document is a step that undo takes back, with its own file', () => {
  const store = createStore(named('a'));
  store.edit(rename('b'));
  const [former, z] = [store.doc, named('z')];
  store.open(z, file('z.json', z));
  assert.equal(store.origin.title, 'z.json');
  store.edit(rename('zz'));
  assert.equal(store.origin.title, 'z.json');
  assert.ok(store.unsaved);
  store.undo();
  store.undo();
  assert.equal(store.doc.name, 'b');
  assert.equal(store.origin.title, '');
  store.undo();
  assert.equal(store.doc.name, 'a');
  assert.equal(store.unsaved, false);
  store.redo();
  store.redo();
  assert.equal(store.origin.title, 'z.json');
});

test('what is open already is opened again without a step', () => {
  const store = createStore(named('a'));
  store.open(named('a'), file('a.json', named('a')));
  assert.equal(store.canUndo, false);
});

test('a saved document is unsaved again after an edit, and saved after its undo', () => {
  const store = createStore(named('a'));
  store.edit(rename('b'));
  const heard = [];
  store.subscribe('origin', () => heard.push(store.unsaved));
  store.markSaved(store.doc, { title: 'b.json' });
  assert.deepEqual(heard, [false]);
  store.edit(rename('c'));
  assert.ok(store.unsaved);
  store.undo();
  assert.equal(store.unsaved, false);
  store.undo();
  assert.ok(store.unsaved, 'the file holds b');
});

test('work of another visit comes with its steps', () => {
  const store = createStore(named('a'));
  const work = { doc: named('c'), past: [named('b')], future: [named('d')] };
  store.restore(work, file('', null));
  assert.deepEqual(store.history, work);
  store.undo();
  assert.equal(store.doc.name, 'b');
  assert.ok(store.unsaved);
});

test('listeners hear of their part only, until they leave', () => {
  const store = createStore(named('a'));
  const heard = [];
  const leave = store.subscribe('view', () => heard.push('view'));
  store.subscribe('result', () => heard.push('result'));
  store.setView({ frame: 3 });
  store.setView({ frame: 3 });
  store.setResult({ trouble: 'x' });
  leave();
  store.setView({ frame: 4 });
  assert.deepEqual(heard, ['view', 'result']);
  assert.deepEqual(store.view, {
    frame: 4, playing: false, moving: '', posture: null, selected: '', hovered: '',
    speed: 1, loop: 'once', side: '', charts: ['translation', 'rotation', 'driven', 'path', 'joints', 'sigma'],
    projection: 'perspective', show: { goal: true, closest: true, gaps: true, names: true, axes: true, ground: true, holds: true, freedoms: false }, ghosts: 'none', only: false,
  });
});

test('a value of the state is told when it is another one, and no more once it is left', () => {
  const store = createStore(named('a'));
  const heard = [];
  const leave = store.select(({ view, doc }) => `${doc.name} ${view.frame}`, (value) => heard.push(value));
  assert.deepEqual(heard, [], 'what is so already is not told');
  store.setView({ frame: 3 });
  store.setView({ playing: true });
  store.setResult({ trouble: 'none of its business' });
  store.edit(rename('b'));
  store.undo();
  leave();
  store.setView({ frame: 4 });
  assert.deepEqual(heard, ['a 3', 'b 3', 'a 3']);
});

test('a listener that changes the value itself hears the last value once', () => {
  const store = createStore(named('a'));
  const heard = [];
  store.select(({ view }) => view.frame, (frame) => {
    heard.push(frame);
    if (frame < 3) store.setView({ frame: frame + 1 });
  });
  store.setView({ frame: 1 });
  assert.deepEqual(heard, [1, 2, 3]);
});

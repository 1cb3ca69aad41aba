// One list of keys: what it lists is handled, what is handled is listed, and no two entries of a place share a key.
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { KEYS, PLACES, inWords, onKeys, spokenKey, written } from '../../www/ui/keys.js';

const www = fileURLToPath(new URL('../../www/', import.meta.url));
const press = (key, modifiers = {}) => ({ key, ctrlKey: false, metaKey: false, altKey: false, shiftKey: false, ...modifiers });

const sourceOf = (file) => readFileSync(join(www, file), 'utf8').replaceAll(/\/\*[^]*?\*\/|\/\/ .*/g, '');
const files = readdirSync(www, { recursive: true }).filter((file) => file.endsWith('.js') && !/^(dist|pkg)|^ui.keys/.test(file));

/** Names of the handlers that are given to `onKeys` or `keyListener`, and of the keys that are asked for with `isHeld`. @param {string} source */
function namedIn(source) {
  const calls = [...source.matchAll(/\b(?:onKeys|keyListener)\(/g)].flatMap(({ index }) => {
    // What stands in the object itself, without what is inside its handlers.
    let own = '';
    let depth = 0;
    for (let at = source.indexOf('(', index); ; at++) {
      depth += '([{'.includes(source[at]) ? 1 : ')]}'.includes(source[at]) ? -1 : 0;
      if (depth === 0) break;
      if (depth === 2) own += source[at];
    }
    return [...own.matchAll(/[{,}]\s*(\w+)/g)].map(([, name]) => name);
  });
  return [...calls, ...[...source.matchAll(/\bisHeld\(\w+, '(\w+)'\)/g)].map(([, name]) => name)];
}

const handled = files.flatMap((file) => namedIn(sourceOf(file))).filter((name) => name in KEYS);

test('what is inside a handler names no entry', () => {
  assert.deepEqual(namedIn("onKeys(canvas, { play: act(({ at }) => go({ undo: 1 })), redo(event) { return [open, save]; }, fit }, { capture: true }); isHeld(event, 'round');"), ['play', 'redo', 'fit', 'capture', 'round']);
});

test('every entry that is listed has a handler, but for what the browser does', () => {
  assert.deepEqual(Object.keys(KEYS).filter((id) => !handled.includes(id)), ['oneFrame', 'ends', 'nextCell', 'copy', 'paste']);
  assert.deepEqual(Object.keys(KEYS).filter((id) => KEYS[id].native), ['oneFrame', 'ends', 'nextCell', 'copy', 'paste']);
});

test('in tables and in the object tree no key of the list is compared by hand', () => {
  for (const [place, own] of [['tables', files.filter((file) => /^panels.tables/.test(file))], ['tree', [join('panels', 'tree.js')]]]) {
    const keys = Object.values(KEYS).filter(({ where }) => where === place).flatMap((entry) => entry.keys);
    const names = new Set(keys.map((key) => spokenKey(key).replace(/.*\+/, '')).filter((name) => name.length > 1 && name !== 'Shift'));
    assert.ok(names.has('ArrowUp') && names.has('Enter') && own.length > 0);
    const byHand = new RegExp(`\\b(${[...names].join('|')})(?:'|:)|shiftKey\\s*[?&)]|\\bkey === ' '`);
    // The pointer that chooses a block is no key.
    for (const file of own) assert.doesNotMatch(sourceOf(file).replace('if (!event.shiftKey || !to', ''), byHand, file);
  }
});

test('what a screen reader says of keys comes from the list', () => {
  assert.equal(inWords('shiftView', 'zoomIn', 'fit'), `Shift+arrow keys: ${KEYS.shiftView.does}. plus: ${KEYS.zoomIn.does}. Home: ${KEYS.fit.does}.`);
  assert.match(inWords('side'), /^1 to 7: /);
});

test('no two entries of a place share a key; every place has entries', () => {
  for (const place of Object.keys(PLACES)) {
    const keys = Object.values(KEYS).filter(({ where }) => where === place || (where === 'all' && place !== 'all')).flatMap((entry) => entry.keys);
    assert.ok(keys.length > 0, place);
    assert.equal(new Set(keys).size, keys.length, `${place}: ${keys}`);
  }
});

test('keys are compared as they are written', () => {
  assert.equal(written(press('z', { metaKey: true })), 'Ctrl+Z');
  assert.equal(written(press('Z', { ctrlKey: true, shiftKey: true })), 'Ctrl+Shift+Z');
  assert.equal(written(press('?', { shiftKey: true })), '?');
  assert.equal(written(press('G')), 'G', 'Caps Lock');
  assert.equal(written(press('ArrowUp', { shiftKey: true })), 'Shift+↑');
  assert.equal(written(press(' ')), 'Space');
  assert.equal(written(press('[', { ctrlKey: true, altKey: true })), '[', 'AltGr on Windows');
  assert.deepEqual(['Ctrl+Shift+Z', 'Alt+↑', 'Space', ',', '+', '−', 'Page Up'].map(spokenKey), ['Control+Shift+Z', 'Alt+ArrowUp', 'Space', ',', '+', '-', 'PageUp']);
});

test('a handler may leave a key to others; what has been used is left alone', () => {
  const target = new EventTarget();
  const heard = [];
  onKeys(target, { redo: (_, at) => heard.push(at), fit: () => false });
  const send = (key, modifiers) => {
    const event = Object.assign(new Event('keydown', { cancelable: true }), press(key, modifiers));
    target.dispatchEvent(event);
    return event.defaultPrevented;
  };
  assert.ok(send('y', { ctrlKey: true }));
  assert.ok(!send('y'));
  assert.ok(!send('Home'));
  assert.deepEqual(heard, [1]);
});

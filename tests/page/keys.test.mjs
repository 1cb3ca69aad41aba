// One list of keys: what it lists is handled, what is handled is listed, and no two entries of a place share a key.
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { KEYS, PLACES, onKeys, spokenKey, written } from '../../www/ui/keys.js';

const www = fileURLToPath(new URL('../../www/', import.meta.url));
const press = (key, modifiers = {}) => ({ key, ctrlKey: false, metaKey: false, altKey: false, shiftKey: false, ...modifiers });

/** Names of the handlers that are given to `onKeys`, from the source: its text up to the end of the call. */
function handled() {
  const files = readdirSync(www, { recursive: true }).filter((file) => file.endsWith('.js') && !/^(dist|pkg)|^ui.keys/.test(file));
  return files.flatMap((file) => {
    const source = readFileSync(join(www, file), 'utf8');
    return [...source.matchAll(/\bonKeys\(/g)].flatMap(({ index }) => {
      let depth = 0;
      let end = index;
      for (end = source.indexOf('(', index); ; end++) {
        depth += { '(': 1, ')': -1 }[source[end]] ?? 0;
        if (depth === 0) break;
      }
      const call = source.slice(index, end);
      const names = [...call.matchAll(/(?<=[{,]\s*|\/\/.*\n\s*)(\w+)(?=\s*(?::|\(|,|\}))/g)].map(([name]) => name);
      return names.filter((name) => name in KEYS);
    });
  });
}

test('every entry that is listed has a handler', () => {
  const names = handled();
  const missing = Object.keys(KEYS).filter((id) => !KEYS[id].by && !names.includes(id));
  assert.deepEqual(missing, []);
});

test('what a widget or the browser handles is given to no other handler, and the widget is there', () => {
  const names = handled();
  for (const [id, { by }] of Object.entries(KEYS)) {
    if (!by) continue;
    assert.ok(!names.includes(id), id);
    if (by !== 'browser') assert.match(readFileSync(join(www, by), 'utf8'), /\bkey\b|shiftKey/, `${by} listens to keys`);
  }
});

test('no two entries of a place share a key; every place has entries', () => {
  for (const place of Object.keys(PLACES)) {
    const keys = Object.values(KEYS).filter(({ where }) => where === place || (where === 'all' && place !== 'all')).flatMap((entry) => entry.keys);
    // In a table Escape and Enter are said once of each thing that they do.
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

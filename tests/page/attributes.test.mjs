// What the element's attributes mean, how states are written, and what is refused in words.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { MEANINGS, PANELS, WRITINGS } from '../../www/element/attributes.js';

test('an absent attribute means the default', () => {
  const absent = Object.fromEntries(Object.entries(MEANINGS).map(([name, meaning]) => [name, meaning(null)]));
  assert.deepEqual(absent, { loop: 'once', speed: 1, frame: 0, view: '', theme: '', panels: [], keys: 'element' });
});

test('what is written is read again as the same', () => {
  for (const loop of ['once', 'loop', 'bounce']) assert.equal(MEANINGS.loop(WRITINGS.loop(loop)), loop);
  for (const speed of [1, 0.25, 3]) assert.equal(MEANINGS.speed(WRITINGS.speed(speed)), speed);
  for (const frame of [0, 12]) assert.equal(MEANINGS.frame(WRITINGS.frame(frame)), frame);
  for (const view of ['', 'top', 'isometric']) assert.equal(MEANINGS.view(WRITINGS.view(view)), view);
});

test('letters of any size, lists with blanks or commas', () => {
  assert.equal(MEANINGS.loop('Bounce'), 'bounce');
  assert.equal(MEANINGS.loop(''), 'loop');
  assert.deepEqual(MEANINGS.panels(' info,Motion  charts '), ['info', 'motion', 'charts']);
  assert.deepEqual(MEANINGS.panels(PANELS.join(' ')), PANELS);
});

test('what cannot be meant is refused, with what would be accepted', () => {
  for (const [name, text, words] of [
    ['loop', 'forever', /loop is “forever”.*once, loop, bounce/],
    ['speed', 'fast', /speed is “fast”.*factor above zero/],
    ['speed', '-1', /speed/],
    ['speed', '', /speed/],
    ['frame', '1.5', /frame is “1.5”.*whole number from 0/],
    ['frame', '-1', /frame/],
    ['view', 'above', /view is “above”.*front/],
    ['theme', 'sepia', /theme.*light, dark, auto/],
    ['panels', 'info tables', /panels is “tables”.*mechanism/],
    ['keys', 'all', /keys.*element, page/],
  ]) {
    assert.throws(() => MEANINGS[name](text), words, `${name}=${text}`);
  }
});

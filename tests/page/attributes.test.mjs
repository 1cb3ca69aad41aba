// What the element's attributes mean, how states are written, and what is refused in words.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { ATTRIBUTES, PANELS, modeOf } from '../../www/element/attributes.js';
import { DESCRIPTIONS } from '../../www/element/descriptions.js';

test('an absent attribute means the default', () => {
  const absent = Object.fromEntries(Object.entries(ATTRIBUTES).map(([name, { read }]) => [name, read(null)]));
  assert.deepEqual(absent, {
    src: '', type: '', controls: false, autoplay: false, loop: false, bounce: false, frame: 0, speed: 1, view: '', theme: '', readonly: false,
    panels: [], interaction: 'ctrl', keys: 'element', loading: 'lazy', poster: '',
  });
});

test('what is written is read again as the same', () => {
  const values = {
    src: ['', 'a.json'], loop: [true, false], speed: [1, 0.25, 3], frame: [0, 12], view: ['', 'top', 'isometric'], theme: ['', 'auto'],
    panels: [[], ['info', 'charts']], interaction: ['none', 'ctrl', 'full'], loading: ['lazy', 'eager'],
  };
  for (const [name, all] of Object.entries(values)) {
    for (const value of all) assert.deepEqual(ATTRIBUTES[name].read(ATTRIBUTES[name].write(value)), value, `${name}=${value}`);
  }
  for (const [name, { read, write }] of Object.entries(ATTRIBUTES)) assert.equal(write(read(null)), null, `${name}: a default needs no attribute`);
});

test('letters of any size, lists with blanks or commas', () => {
  assert.equal(ATTRIBUTES.view.read('Top'), 'top');
  assert.deepEqual(ATTRIBUTES.panels.read(' info,Motion  charts '), ['info', 'motion', 'charts']);
  assert.deepEqual(ATTRIBUTES.panels.read(PANELS.join(' ')), PANELS);
});

test('what cannot be meant is refused, with what would be accepted', () => {
  for (const [name, text, words] of [
    ['speed', 'fast', /speed is “fast”.*factor above zero/],
    ['speed', '-1', /speed/],
    ['speed', '', /speed/],
    ['frame', '1.5', /frame is “1.5”.*whole number from 0/],
    ['frame', '-1', /frame/],
    ['view', 'above', /view is “above”.*front/],
    ['theme', 'sepia', /theme.*light, dark, auto/],
    ['panels', 'info tables', /panels is “tables”.*mechanism/],
    ['keys', 'all', /keys.*element, page/],
    ['interaction', 'some', /interaction.*none, ctrl, full/],
    ['loading', '', /loading.*lazy, eager/],
  ]) {
    assert.throws(() => ATTRIBUTES[name].read(text), words, `${name}=${text}`);
  }
});

test('loop and bounce are there or not; bounce goes before loop', () => {
  const modes = [[false, false], [true, false], [false, true], [true, true]].map(([loop, bounce]) => modeOf({ loop, bounce }));
  assert.deepEqual(modes, ['once', 'loop', 'bounce', 'bounce']);
  assert.equal(ATTRIBUTES.loop.read('false'), true, 'as everywhere in HTML: it stands there');
});

test('every attribute is described in one or more sentences', () => {
  assert.deepEqual(Object.keys(DESCRIPTIONS), Object.keys(ATTRIBUTES));
  for (const [name, text] of Object.entries(DESCRIPTIONS)) assert.match(text, /\.$/, name);
});

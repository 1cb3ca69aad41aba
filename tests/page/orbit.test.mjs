// What a mouse, a wheel and fingers on the canvas do with the view.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { createOrbit } from '../../www/view3d/scene/orbit.js';

/** A canvas 100 pixels high, with what was done with the view on it, in words. */
function begin() {
  const ownerDocument = new EventTarget();
  const held = new Set();
  const canvas = Object.assign(new EventTarget(), { ownerDocument, clientHeight: 100, style: {}, setPointerCapture: (id) => held.add(id) });
  /** @type {string[]} */
  const done = [];
  const round = (/** @type {number} */ value) => Number(value.toFixed(4)) + 0;
  const tell = (/** @type {string} */ what) => (/** @type {number[]} */ ...values) => done.push([what, ...values.map(round)].join(' '));
  const orbit = createOrbit(/** @type {any} */ (canvas), { start: tell('start'), turn: tell('turn'), shift: tell('shift'), zoom: tell('zoom') });
  const event = (/** @type {string} */ type, /** @type {object} */ data) => Object.assign(new Event(type, { cancelable: true }), { pointerId: 1, pointerType: 'mouse', button: 0, clientX: 0, clientY: 0, ...data });
  return {
    orbit,
    held,
    touchAction: () => canvas.style.touchAction,
    on: (/** @type {string} */ type, data = {}) => {
      const made = event(type, data);
      (/^pointer(move|up)$|^key/.test(type) ? ownerDocument : canvas).dispatchEvent(made);
      return made;
    },
    /** What was done since the last time. */
    get done() {
      return done.splice(0);
    },
  };
}

test('a mouse turns, with a modifier or its right button it shifts, with its middle one it zooms', () => {
  const view = begin();
  for (const [data, what] of /** @type {const} */ ([[{ button: 0 }, 'turn 0.1 0.2'], [{ button: 0, shiftKey: true }, 'shift 0.1 0.2'], [{ button: 2 }, 'shift 0.1 0.2'], [{ button: 2, ctrlKey: true }, 'turn 0.1 0.2'], [{ button: 1 }, `zoom ${Number((0.95 ** -0.2).toFixed(4))}`]])) {
    view.on('pointerdown', { ...data, clientX: 5, clientY: 5 });
    assert.deepEqual([...view.held], [1], 'it is followed beyond the canvas; the browser lets it go');
    view.on('pointermove', { clientX: 15, clientY: 25 });
    view.on('pointerup');
    view.on('pointermove', { clientX: 95, clientY: 95 });
    assert.deepEqual(view.done, ['start', what]);
  }
  assert.ok(view.on('contextmenu').defaultPrevented);
});

test('a wheel zooms by pixels, lines and pages, and a pinch on a touchpad further; not while a pointer turns', () => {
  const view = begin();
  const step = (/** @type {number} */ pixels) => `zoom ${Number((0.95 ** (-pixels / 100)).toFixed(4))}`;
  assert.ok(view.on('wheel', { deltaY: 100, deltaMode: 0 }).defaultPrevented);
  view.on('wheel', { deltaY: -3, deltaMode: 1 });
  view.on('wheel', { deltaY: 1, deltaMode: 2 });
  view.on('wheel', { deltaY: 5, deltaMode: 0, ctrlKey: true });
  view.on('keydown', { key: 'Control' });
  view.on('wheel', { deltaY: 5, deltaMode: 0, ctrlKey: true });
  assert.deepEqual(view.done.filter((what) => what !== 'start'), [100, -48, 100, 50, 5].map(step));
  view.on('pointerdown');
  assert.ok(!view.on('wheel', { deltaY: 100, deltaMode: 0 }).defaultPrevented);
  assert.deepEqual(view.done, ['start']);
  view.on('pointercancel');
  view.orbit.zooms = false;
  assert.ok(!view.on('wheel', { deltaY: 100, deltaMode: 0 }).defaultPrevented);
  assert.deepEqual(view.done, []);
});

test('one finger turns, two shift and zoom, and the one that stays goes on where it is', () => {
  const view = begin();
  const finger = (/** @type {string} */ type, /** @type {number} */ pointerId, /** @type {number} */ clientX, clientY = 0) => view.on(type, { pointerType: 'touch', pointerId, clientX, clientY });
  assert.equal(view.touchAction(), 'none');
  finger('pointerdown', 1, 0);
  finger('pointermove', 1, 10);
  finger('pointerdown', 2, 30);
  // From 20 pixels apart to 40, and the middle by 10.
  finger('pointermove', 2, 50);
  finger('pointerup', 1, 10);
  finger('pointermove', 2, 60);
  finger('pointerup', 2, 60);
  assert.deepEqual(view.done, ['start', 'turn 0.1 0', 'start', 'zoom 0.5', 'shift 0.1 0', 'start', 'turn 0.1 0']);
  assert.deepEqual([...view.held], [1]);
});

test('where one finger is the page’s, two turn and zoom; what is ended listens no more', () => {
  const view = begin();
  view.orbit.leavesOneFinger = true;
  const finger = (/** @type {string} */ type, /** @type {number} */ pointerId, /** @type {number} */ clientX) => view.on(type, { pointerType: 'touch', pointerId, clientX });
  finger('pointerdown', 1, 0);
  finger('pointermove', 1, 10);
  assert.deepEqual(view.done, []);
  finger('pointerdown', 2, 30);
  finger('pointermove', 2, 50);
  assert.deepEqual(view.done, ['start', 'zoom 0.5', 'turn 0.1 0']);
  view.orbit.dispose();
  finger('pointermove', 2, 90);
  finger('pointerdown', 3, 90);
  assert.deepEqual(view.done, []);
});

test('a pointer that is taken away turns no more, and two fingers in one place zoom to nothing', () => {
  const view = begin();
  view.on('pointerdown');
  view.on('lostpointercapture');
  view.on('pointermove', { clientX: 50 });
  assert.deepEqual(view.done, ['start']);
  view.on('pointerdown');
  view.on('pointermove', { clientX: 50 });
  assert.deepEqual(view.done, ['start', 'turn 0.5 0'], 'the next press begins anew');
  view.on('pointerup');
  for (const pointerId of [7, 8]) view.on('pointerdown', { pointerType: 'touch', pointerId });
  view.on('pointermove', { pointerType: 'touch', pointerId: 8, clientX: 20 });
  assert.deepEqual(view.done, ['start', 'start', 'shift 0.1 0']);
});

/**
 * The view cube in hand: a click on a face, an edge or a corner looks from there, and a drag turns the view. Loaded when a
 * pointer comes to it.
 *
 * @typedef {NonNullable<import('../element/workbench.js').App['scene']>} Scene
 */
import { HALF } from './view-cube.js';

/** Radians of a turn for each pixel of a drag. */
const TURN = 0.02;

/** A pointer that goes no farther has clicked, in pixels. */
const STEADY = 4;

/** How far from the middle of a face an edge begins. */
const EDGE = 0.6;

/** Which way each face looks. @type {Record<string, [import('../core/standard-views.js').StandardView, string]>} */
const FACES = {
  '0,-1,0': ['front', 'Front'],
  '0,1,0': ['back', 'Back'],
  '-1,0,0': ['left', 'Left'],
  '1,0,0': ['right', 'Right'],
  '0,0,1': ['top', 'Top'],
  '0,0,-1': ['bottom', 'Bottom'],
};

/**
 * Which way the face, the edge or the corner looks that is seen at a place.
 * @param {number} x @param {number} y from the cube's middle, in halves of it, y up
 * @param {number[]} m the camera's matrix: its axes to the right, up and towards it
 * @returns {number[] | null} −1, 0 or 1 along each axis; null beside the cube
 */
export function sideAt(x, y, m) {
  const from = [0, 1, 2].map((axis) => x * m[axis] + y * m[4 + axis]);
  const back = [m[8], m[9], m[10]];
  // Where the line of sight comes into the slab between two opposite faces, and where it is out of it again.
  const ways = back.map((step, axis) => {
    if (Math.abs(step) < 1e-9) return [Math.abs(from[axis]) > 1 ? Infinity : -Infinity, Infinity];
    return [(-Math.sign(step) - from[axis]) / step, (Math.sign(step) - from[axis]) / step];
  });
  const near = Math.min(...ways.map(([, out]) => out));
  if (near < Math.max(...ways.map(([into]) => into))) return null;
  return from.map((value, axis) => (Math.abs(value + near * back[axis]) > EDGE ? Math.sign(value + near * back[axis]) : 0));
}

/** A drag has ended, whose click is none. */
let hasTurned = false;

/** The view's keys hold from here on, as after a press into the view itself. @param {Scene} scene */
const focusView = ({ canvas }) => canvas.focus({ preventScroll: true });

/** @param {HTMLElement} place the cube's @param {Scene} scene @param {PointerEvent} event the press */
export function drag(place, scene, { pointerId, clientX, clientY }) {
  let [x, y] = [clientX, clientY];
  hasTurned = false;
  const over = new AbortController();
  const { signal } = over;
  // Its own window: the pointer leaves the cube.
  const listen = (/** @type {string} */ type, /** @type {(event: PointerEvent) => void} */ act) => place.ownerDocument.addEventListener(type, (event) => /** @type {PointerEvent} */ (event).pointerId === pointerId && act(/** @type {PointerEvent} */ (event)), { signal });
  listen('pointermove', (event) => {
    if (!event.buttons) return over.abort();
    if (!hasTurned && Math.hypot(event.clientX - x, event.clientY - y) < STEADY) return;
    hasTurned = true;
    scene.turn(TURN * (x - event.clientX), TURN * (y - event.clientY));
    [x, y] = [event.clientX, event.clientY];
  });
  for (const end of ['pointerup', 'pointercancel']) {
    listen(end, () => {
      over.abort();
      focusView(scene);
    });
  }
}

/**
 * @param {HTMLElement} place the cube's @param {Scene} scene @param {MouseEvent} event
 * @param {(view: import('../core/standard-views.js').StandardView, name: string) => void} turnTo
 */
export function click(place, scene, { clientX, clientY }, turnTo) {
  focusView(scene);
  const box = place.getBoundingClientRect();
  const side = hasTurned ? null : sideAt((clientX - box.x - box.width / 2) / HALF, (box.y + box.height / 2 - clientY) / HALF, scene.camera.matrixWorld.elements);
  hasTurned = false;
  if (!side) return;
  const face = FACES[String(side)];
  if (face) return turnTo(...face);
  const [x, y, z] = side;
  scene.lookFrom({ around: Math.atan2(x, -y), down: Math.acos(z / Math.hypot(x, y, z)) });
}

/**
 * The cube in a corner of the view: it shows from where the scene is seen; a click on a face, an edge or a corner looks from
 * there, and a drag turns the view. It is for pointers: the menu of views and the arrow keys do the same.
 */
import { element } from '../ui/dom.js';

/** Half the cube, in pixels, as style/view.css has it. */
const HALF = 22;

/** Radians of a turn for each pixel of a drag. */
const TURN = 0.02;

/** A pointer that goes no farther has clicked, in pixels. */
const STEADY = 4;

/** How far from the middle of a face an edge begins. */
const EDGE = 0.6;

/** Faces, which way each looks, and its turn from the front one. @type {[import('../core/standard-views.js').StandardView, string, string, string][]} */
const FACES = [
  ['front', 'Front', '0,-1,0', ''],
  ['right', 'Right', '1,0,0', 'rotateY(90deg)'],
  ['back', 'Back', '0,1,0', 'rotateY(180deg)'],
  ['left', 'Left', '-1,0,0', 'rotateY(-90deg)'],
  ['top', 'Top', '0,0,1', 'rotateX(90deg)'],
  ['bottom', 'Bottom', '0,0,-1', 'rotateX(-90deg)'],
];

/**
 * Which way the face, the edge or the corner looks that is seen at a place.
 * @param {number} x @param {number} y from the cube's middle, in halves of it, y up
 * @param {number[]} m the camera's matrix: its axes to the right, up and towards it
 * @returns {number[] | null} −1, 0 or 1 along each axis; null beside the cube
 */
export function sideAt(x, y, m) {
  const from = [0, 1, 2].map((axis) => x * m[axis] + y * m[4 + axis]);
  const back = [m[8], m[9], m[10]];
  // The nearest point of the line of sight that is still in the cube.
  const ways = back.map((step, axis) => (Math.abs(step) < 1e-9 ? [Math.abs(from[axis]) > 1 ? Infinity : -Infinity, Infinity] : [(-Math.sign(step) - from[axis]) / step, (Math.sign(step) - from[axis]) / step]));
  const near = Math.min(...ways.map(([, out]) => out));
  if (near < Math.max(...ways.map(([into]) => into))) return null;
  return from.map((value, axis) => (Math.abs(value + near * back[axis]) > EDGE ? Math.sign(value + near * back[axis]) : 0));
}

/** @param {Pick<import('../element/workbench.js').App, 'find' | 'store'> & {scene: NonNullable<import('../element/workbench.js').App['scene']>}} app @param {(view: import('../core/standard-views.js').StandardView, name: string) => void} turnTo */
export function createViewCube({ find, store, scene }, turnTo) {
  const place = find('cube');
  const cube = element('div');
  for (const [, name, , turn] of FACES) cube.appendChild(element('i', {}, name)).style.transform = `${turn} translateZ(${HALF}px)`;
  place.append(cube);
  const matrix = () => scene.camera.matrixWorld.elements;

  let shown = '';
  scene.drawn.add(() => {
    const m = matrix();
    const turn = `rotateX(${-Math.asin(m[10]).toFixed(3)}rad) rotateY(${-Math.atan2(m[8], -m[9]).toFixed(3)}rad)`;
    if (turn !== shown) cube.style.transform = shown = turn;
  });

  /** Where the pointer was last, and whether it has turned the view. @type {{x: number, y: number, turned: boolean} | null} */
  let held = null;
  place.addEventListener('pointerdown', ({ pointerId, clientX: x, clientY: y }) => {
    held = { x, y, turned: false };
    place.setPointerCapture(pointerId);
  });
  place.addEventListener('pointermove', ({ clientX: x, clientY: y }) => {
    if (!held || (!held.turned && Math.hypot(x - held.x, y - held.y) < STEADY)) return;
    scene.turn(TURN * (held.x - x), TURN * (held.y - y));
    held = { x, y, turned: true };
  });
  for (const end of ['pointerup', 'pointercancel']) {
    place.addEventListener(end, (event) => {
      const clicked = event.type === 'pointerup' && held && !held.turned;
      held = null;
      const { clientX, clientY } = /** @type {PointerEvent} */ (event);
      const box = place.getBoundingClientRect();
      const side = clicked && sideAt((clientX - box.x - box.width / 2) / HALF, (box.y + box.height / 2 - clientY) / HALF, matrix());
      if (!side) return;
      const face = FACES.find(([, , way]) => way === String(side));
      if (face) return turnTo(face[0], face[1]);
      store.setView({ side: '' });
      const [x, y, z] = side;
      scene.lookFrom({ around: Math.atan2(x, -y), down: Math.acos(z / Math.hypot(x, y, z)) });
    });
  }
}

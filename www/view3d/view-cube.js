/**
 * The cube in a corner of the view shows from where the scene is seen. It is for pointers, whose clicks and drags are loaded
 * when they come: the menu of views and the arrow keys do the same.
 */
import { element } from '../ui/dom.js';
import { withPart } from '../ui/lazy.js';

/** Half the cube, in pixels, as style/view.css has it. */
export const HALF = 22;

/** Faces, and the turn of each from the front one. */
const FACES = { Front: '', Right: 'rotateY(90deg)', Back: 'rotateY(180deg)', Left: 'rotateY(-90deg)', Top: 'rotateX(90deg)', Bottom: 'rotateX(-90deg)' };

/**
 * @param {import('../element/workbench.js').App} app @param {NonNullable<typeof app.scene>} scene
 * @param {(view: import('../core/standard-views.js').StandardView, name: string) => void} turnTo
 */
export function createViewCube(app, scene, turnTo) {
  const place = app.find('cube');
  const cube = element('div');
  for (const [name, turn] of Object.entries(FACES)) cube.appendChild(element('i', {}, name)).style.transform = `${turn} translateZ(${HALF}px)`;
  place.append(cube);
  let shown = '';
  scene.drawn.add(() => {
    const m = scene.camera.matrixWorld.elements;
    const turn = `rotateX(${-Math.asin(m[10]).toFixed(3)}rad) rotateY(${-Math.atan2(m[8], -m[9]).toFixed(3)}rad)`;
    if (turn !== shown) cube.style.transform = shown = turn;
  });
  const inHand = (/** @type {(hand: typeof import('./cube-hand.js')) => void} */ act) => withPart(app, 'The view cube', () => import('./cube-hand.js'), act);
  place.addEventListener('pointerdown', (event) => inHand(({ drag }) => drag(place, scene, event)));
  place.addEventListener('click', (event) => inHand(({ click }) => click(place, scene, event, turnTo)));
}

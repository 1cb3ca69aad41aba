/**
 * Pictures of the view in any size: a renderer of its own draws the same scene, so that the view stays as it is.
 *
 * @typedef {NonNullable<import('../element/workbench.js').App['scene']>} Scene
 * @typedef {object} Wish
 * @property {number} width in CSS pixels, as the names are sized
 * @property {number} height
 * @property {number} [ratio] pixels of the picture to one of those
 * @property {Background} [background] the view's, if it is not given
 * @property {boolean} [whole] the linkage with its motions fills the picture; otherwise what the view shows
 * @property {import('three').Vector3[]} [fit] points that fill it instead of the linkage
 * @property {import('three').Vector3} [from] direction that it is seen from, instead of the view's, where something fills it
 * @property {boolean} [names] with the names in the view
 * @property {import('./legend.js').Line[]} [legend] its lines, drawn at the foot
 * @property {boolean} [shadows] also where the view leaves them out while it moves
 *
 * White and clear pictures have no lines on the ground; a white one has the colours of the light scheme.
 * @typedef {'view' | 'white' | 'clear'} Background
 */
import { DirectionalLight, LineSegments, PerspectiveCamera, WebGLRenderer } from 'three';
import { frameWhole } from '../view3d/scene/framing.js';
import { boxOn, layOut, leaderOf, wayOf } from '../view3d/scene/label-layout.js';
import { placeOf } from '../view3d/scene/labels.js';
import { drawn } from '../view3d/scene/stroke.js';
import { drawLegend, legendFont, legendHeight } from './legend.js';
import { pointsOf } from './triangles.js';

export { pointsOf };

/** Share of a picture's height or width that stays free around a linkage that fills it: names stand beside their points. */
const EDGE = 0.06;

/** A flag with a name, as the style sheet has it. */
export const NAME = { padding: 5, height: 17, corner: 3, leader: 0.55 };

/** One for all pictures: a browser has few. @type {WebGLRenderer | null} */
let renderer = null;

export function pictureRenderer() {
  renderer ??= new WebGLRenderer({ antialias: true, alpha: true, preserveDrawingBuffer: true });
  renderer.shadowMap.enabled = true;
  return renderer;
}

/**
 * Calls `draw` while the view has the colours for a background.
 * @template T @param {Scene} scene @param {Background} background @param {() => T} draw
 */
export function dressed(scene, background, draw) {
  const view = /** @type {HTMLElement} */ (scene.canvas.parentElement);
  if (background !== 'white' || getComputedStyle(view).colorScheme === 'light') return draw();
  view.style.colorScheme = 'light';
  scene.paint();
  try {
    return draw();
  } finally {
    view.style.colorScheme = '';
    scene.paint();
  }
}

/** The part of the picture's height that its legend needs. @param {Wish} wish @param {string} font */
function legendShare({ legend = [], ...picture }, font) {
  const pen = new OffscreenCanvas(1, 1).getContext('2d');
  if (!pen) return 0;
  pen.font = legendFont(font);
  return legendHeight(legend, picture, (text) => pen.measureText(text).width) / picture.height;
}

/** What the view shows, without outlines and handles. @param {Scene} scene @param {Wish} wish @param {(camera: Scene['camera']) => void} draw */
export function withoutTools(scene, wish, draw) {
  const { width, height } = wish;
  /** @type {import('three').Object3D[]} */
  const hidden = [];
  const hide = (/** @type {import('three').Object3D} */ object) => {
    if (object.visible) hidden.push(object);
    object.visible = false;
  };
  for (const child of scene.root.children) if (!scene.pictured.includes(child)) hide(child);
  scene.root.traverse((object) => {
    if (object.userData.tool) hide(object);
    if (object instanceof LineSegments && (wish.background ?? 'view') !== 'view') hide(object);
  });
  const aspect = width / height;
  const camera = scene.camera.clone();
  // Nothing lies over a picture that it must be beside.
  if (wish.whole) camera.view = null;
  if (camera instanceof PerspectiveCamera) camera.aspect = aspect;
  else [camera.left, camera.right] = [camera.bottom * aspect, camera.top * aspect];
  camera.updateProjectionMatrix();
  if (wish.from) {
    const { centre } = scene.size;
    const far = camera.position.distanceTo(centre);
    camera.position.copy(centre).addScaledVector(wish.from, far);
    camera.lookAt(centre);
  }
  camera.updateMatrixWorld();
  if (wish.whole) {
    const foot = 2 * legendShare(wish, viewStyle(scene).font);
    frameWhole(camera, wish.fit ?? pointsOf(scene.pictured.filter(({ name }) => name !== 'ground')), { left: EDGE - 1, right: 1 - EDGE, bottom: EDGE - 1 + foot, top: 1 - 2 * EDGE });
  }
  const before = drawn.clone();
  drawn.set(width, height);
  try {
    draw(camera);
  } finally {
    drawn.copy(before);
    for (const object of hidden) object.visible = true;
  }
}

/**
 * Names with their flags in a picture, and the ends of their leaders.
 * @param {Scene} scene @param {Scene['camera']} camera @param {Wish} wish
 * @param {(text: string) => number} widthOf a text
 */
export function placedNames(scene, camera, wish, widthOf) {
  const { width, height } = wish;
  const { link, centre } = scene.size;
  const room = { x: 0, y: 0, width, height: height * (1 - legendShare(wish, viewStyle(scene).font)) };
  const place = (/** @type {import('three').Vector3} */ at) => placeOf(at, camera, width, height, link);
  const names = scene.names
    .map(({ at, text }) => ({ ...place(at), text, width: widthOf(text) + 2 * NAME.padding, height: NAME.height, rank: 0, kept: true, spot: -1 }))
    .filter(({ out }) => !out);
  return layOut(names, [], room, place(centre)).flatMap((spot, index) => {
    if (spot < 0) return [];
    const { text, x, y } = names[index];
    const [right, down] = wayOf(spot);
    const long = leaderOf(names[index], spot) / Math.hypot(right, down);
    return [{ text, box: boxOn(names[index], spot), leader: [x, y, x + right * long, y + down * long] }];
  });
}

/** The view's colours as they are now. @param {Scene} scene @param {Background} [background] */
export function viewStyle(scene, background = 'view') {
  const view = /** @type {HTMLElement} */ (scene.canvas.parentElement);
  const { backgroundImage, fontFamily } = getComputedStyle(view);
  const sky = backgroundImage.match(/(rgba?|color)\([^)]*\)/g) ?? [];
  const tag = view.querySelector('#labels span');
  const { color, backgroundColor } = getComputedStyle(tag ?? view);
  return { sky, font: `11.5px ${fontFamily}`, ink: color, paper: background === 'white' ? 'rgb(255 255 255 / 0.8)' : backgroundColor };
}

/**
 * Draws the view as it is now.
 * @param {Scene} scene
 * @param {Wish} wish
 * @param {HTMLCanvasElement} [canvas] is drawn over, if given
 */
export const drawPicture = (scene, wish, canvas = document.createElement('canvas')) => dressed(scene, wish.background ?? 'view', () => draw(scene, wish, canvas));

/** @param {Scene} scene @param {Wish} wish @param {HTMLCanvasElement} canvas */
function draw(scene, wish, canvas) {
  const { width, height, ratio = 1, background = 'view', names = true, legend = [], shadows = false } = wish;
  const renderer = pictureRenderer();
  const [across, down] = [Math.round(width * ratio), Math.round(height * ratio)];
  // A canvas that is given its own size again would be emptied and allocated anew.
  if (canvas.width !== across || canvas.height !== down) Object.assign(canvas, { width: across, height: down });
  if (renderer.domElement.width !== across || renderer.domElement.height !== down) renderer.setSize(across, down, false);
  const pen = canvas.getContext('2d');
  if (!pen) throw new Error('the browser has no room for a picture of this size');
  const style = viewStyle(scene, background);
  pen.clearRect(0, 0, across, down);
  if (background === 'white') {
    pen.fillStyle = '#fff';
    pen.fillRect(0, 0, across, down);
  } else if (background === 'view') {
    const sky = pen.createLinearGradient(0, 0, 0, down);
    style.sky.forEach((colour, index) => sky.addColorStop(index / Math.max(1, style.sky.length - 1), colour));
    pen.fillStyle = sky;
    pen.fillRect(0, 0, across, down);
  }
  withoutTools(scene, wish, (camera) => {
    // The first; the other casts no shadow.
    const suns = scene.pictured.filter((object) => object instanceof DirectionalLight).slice(0, 1);
    const cast = suns.map((sun) => sun.castShadow);
    for (const sun of suns) sun.castShadow ||= shadows;
    renderer.render(scene.root, camera);
    suns.forEach((sun, index) => {
      sun.castShadow = cast[index];
    });
    pen.drawImage(renderer.domElement, 0, 0);
    pen.save();
    pen.scale(ratio, ratio);
    drawLegend(pen, legend, { width, height }, style);
    pen.font = style.font;
    pen.textBaseline = 'middle';
    pen.strokeStyle = style.ink;
    for (const { text, box, leader } of names ? placedNames(scene, camera, wish, (text) => pen.measureText(text).width) : []) {
      pen.globalAlpha = NAME.leader;
      pen.beginPath();
      pen.moveTo(leader[0], leader[1]);
      pen.lineTo(leader[2], leader[3]);
      pen.stroke();
      pen.globalAlpha = 1;
      pen.fillStyle = style.paper;
      pen.beginPath();
      pen.roundRect(box.x, box.y, box.width, box.height, NAME.corner);
      pen.fill();
      pen.fillStyle = style.ink;
      pen.fillText(text, box.x + NAME.padding, box.y + box.height / 2);
    }
    pen.restore();
  });
  return canvas;
}

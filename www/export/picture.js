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
 * @property {boolean} [names] with the names in the view
 * @property {import('./legend.js').Line[]} [legend] its lines, drawn at the foot
 * @property {boolean} [shadows] also where the view leaves them out while it moves
 *
 * White and clear pictures have no lines on the ground; a white one has the colours of the light scheme.
 * @typedef {'view' | 'white' | 'clear'} Background
 */
import { DirectionalLight, LineSegments, PerspectiveCamera, Vector3, WebGLRenderer } from 'three';
import { frameWhole } from '../view3d/scene/framing.js';
import { drawn } from '../view3d/scene/stroke.js';
import { drawLegend, legendFont, legendHeight } from './legend.js';
import { pointsOf } from './triangles.js';

/** Share of a picture's height or width that stays free around a linkage that fills it: names stand beside their points. */
const EDGE = 0.06;

/** Where a name stands beside its point, as the style sheet has it. */
export const NAME = { left: 8, top: -22, padding: 5, height: 17, corner: 3 };

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
  if (camera instanceof PerspectiveCamera) camera.aspect = aspect;
  else [camera.left, camera.right] = [camera.bottom * aspect, camera.top * aspect];
  camera.updateProjectionMatrix();
  camera.updateMatrixWorld();
  if (wish.whole) {
    const foot = 2 * legendShare(wish, viewStyle(scene).font);
    frameWhole(camera, pointsOf(scene.pictured.filter(({ name }) => name !== 'ground')), { left: EDGE - 1, right: 1 - EDGE, bottom: EDGE - 1 + foot, top: 1 - 2 * EDGE });
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

/** Names with their places in a picture. @param {Scene} scene @param {Scene['camera']} camera @param {number} width @param {number} height */
export function placedNames(scene, camera, width, height) {
  return scene.names
    .map(({ at, text }) => {
      const seen = new Vector3().copy(at).project(camera);
      return { text, x: ((seen.x + 1) / 2) * width, y: ((1 - seen.y) / 2) * height, seen: seen.z <= 1 };
    })
    .filter(({ x, y, seen }) => seen && x >= 0 && x <= width && y >= 0 && y <= height);
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
    const suns = scene.pictured.filter((object) => object instanceof DirectionalLight);
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
    for (const { text, x, y } of names ? placedNames(scene, camera, width, height) : []) {
      pen.fillStyle = style.paper;
      pen.beginPath();
      pen.roundRect(x + NAME.left, y + NAME.top, pen.measureText(text).width + 2 * NAME.padding, NAME.height, NAME.corner);
      pen.fill();
      pen.fillStyle = style.ink;
      pen.fillText(text, x + NAME.left + NAME.padding, y + NAME.top + NAME.height / 2);
    }
    pen.restore();
  });
  return canvas;
}

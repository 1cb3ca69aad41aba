/**
 * Pictures of the view in any size: a renderer of its own draws the same scene, so that the view stays as it is.
 *
 * @typedef {NonNullable<import('../element/workbench.js').App['scene']>} Scene
 * @typedef {object} Wish
 * @property {number} width in CSS pixels, as the names are sized
 * @property {number} height
 * @property {number} [ratio] pixels of the picture to one of those
 * @property {boolean} [transparent] without the view's background
 * @property {boolean} [names] with the names in the view
 * @property {boolean} [shadows] also where the view leaves them out while it moves
 */
import { DirectionalLight, Mesh, PerspectiveCamera, ShaderMaterial, Vector3, WebGLRenderer } from 'three';

/** Where a name stands beside its point, as the style sheet has it. */
export const NAME = { left: 8, top: -22, padding: 5, height: 17, corner: 3 };

/** One for all pictures: a browser has few. @type {WebGLRenderer | null} */
let renderer = null;

export function pictureRenderer() {
  renderer ??= new WebGLRenderer({ antialias: true, alpha: true, preserveDrawingBuffer: true });
  renderer.shadowMap.enabled = true;
  return renderer;
}

/** What the view shows, without outlines and handles. @param {Scene} scene @param {number} aspect @param {(camera: Scene['camera']) => void} draw */
export function withoutTools(scene, aspect, draw) {
  /** @type {import('three').Object3D[]} */
  const hidden = [];
  const hide = (/** @type {import('three').Object3D} */ object) => {
    if (object.visible) hidden.push(object);
    object.visible = false;
  };
  for (const child of scene.root.children) if (!scene.pictured.includes(child)) hide(child);
  scene.root.traverse((object) => {
    if (object instanceof Mesh && object.material instanceof ShaderMaterial) hide(object);
  });
  const camera = scene.camera.clone();
  if (camera instanceof PerspectiveCamera) camera.aspect = aspect;
  else [camera.left, camera.right] = [camera.bottom * aspect, camera.top * aspect];
  camera.updateProjectionMatrix();
  camera.updateMatrixWorld();
  try {
    draw(camera);
  } finally {
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

/** The view's colours as they are now. @param {Scene} scene */
export function viewStyle(scene) {
  const view = /** @type {HTMLElement} */ (scene.canvas.parentElement);
  const { backgroundImage, fontFamily } = getComputedStyle(view);
  const sky = backgroundImage.match(/(rgba?|color)\([^)]*\)/g) ?? [];
  const tag = view.querySelector('#labels span');
  const { color, backgroundColor } = getComputedStyle(tag ?? view);
  return { sky, font: `11.5px ${fontFamily}`, ink: color, paper: backgroundColor };
}

/**
 * Draws the view as it is now.
 * @param {Scene} scene
 * @param {Wish} wish
 * @param {HTMLCanvasElement} [canvas] is drawn over, if given
 */
export function drawPicture(scene, { width, height, ratio = 1, transparent = false, names = true, shadows = false }, canvas = document.createElement('canvas')) {
  const renderer = pictureRenderer();
  const [across, down] = [Math.round(width * ratio), Math.round(height * ratio)];
  // A canvas that is given its own size again would be emptied and allocated anew.
  if (canvas.width !== across || canvas.height !== down) Object.assign(canvas, { width: across, height: down });
  if (renderer.domElement.width !== across || renderer.domElement.height !== down) renderer.setSize(across, down, false);
  const pen = canvas.getContext('2d');
  if (!pen) throw new Error('the browser has no room for a picture of this size');
  const style = viewStyle(scene);
  pen.clearRect(0, 0, across, down);
  if (!transparent) {
    const sky = pen.createLinearGradient(0, 0, 0, down);
    style.sky.forEach((colour, index) => sky.addColorStop(index / Math.max(1, style.sky.length - 1), colour));
    pen.fillStyle = sky;
    pen.fillRect(0, 0, across, down);
  }
  withoutTools(scene, width / height, (camera) => {
    const suns = scene.pictured.filter((object) => object instanceof DirectionalLight);
    const cast = suns.map((sun) => sun.castShadow);
    for (const sun of suns) sun.castShadow ||= shadows;
    renderer.render(scene.root, camera);
    suns.forEach((sun, index) => {
      sun.castShadow = cast[index];
    });
    pen.drawImage(renderer.domElement, 0, 0);
    if (!names) return;
    pen.save();
    pen.scale(ratio, ratio);
    pen.font = style.font;
    pen.textBaseline = 'middle';
    for (const { text, x, y } of placedNames(scene, camera, width, height)) {
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

/**
 * The one renderer that draws every view of the page: a browser has few graphics contexts. It draws into a canvas as large as
 * the largest view, from which each view's own canvas has its part copied, and keeps it. The only view of a page shows that
 * canvas itself, over its own: a copy waits until the picture is made, which without a graphics card takes long.
 */
import { WebGLRenderer } from 'three';
import { windowOf } from '../../ui/dom.js';
import { createSmoothScreen } from './smooth-screen.js';
import { drawn as pictureSize } from './stroke.js';

/** @type {{renderer: WebGLRenderer, context: WebGL2RenderingContext, screen: ReturnType<typeof createSmoothScreen>, slow: boolean} | null} */
let shared = null;

/**
 * Views in the page, with their sizes in CSS pixels; `again` draws what was drawn last.
 * @type {Set<{canvas: HTMLCanvasElement, width: number, height: number, again: () => void}>}
 */
const views = new Set();

/** @returns {typeof shared} null where the browser has no WebGL 2 */
function theRenderer() {
  if (shared) return shared;
  const canvas = document.createElement('canvas');
  canvas.className = 'drawn';
  const context = canvas.getContext('webgl2', { antialias: false, alpha: true });
  if (!context) return null;
  const renderer = new WebGLRenderer({ canvas, context });
  renderer.shadowMap.enabled = true;
  renderer.setScissorTest(true);
  // What happens to it happens to every view.
  for (const name of ['webglcontextlost', 'webglcontextrestored']) canvas.addEventListener(name, () => views.forEach((view) => view.canvas.dispatchEvent(new Event(name))));
  return (shared = { renderer, context, screen: createSmoothScreen(renderer, context), slow: isSoftware(context) });
}

/**
 * @param {HTMLCanvasElement} canvas the view's own
 * @param {import('three').Scene} root what is drawn
 * @param {AbortSignal} [signal] ends it, and frees what it has in the graphics card
 * @returns null where the browser has no WebGL 2
 */
export function createDrawing(canvas, root, signal) {
  const all = theRenderer();
  const pen = canvas.getContext('2d');
  if (!all || !pen) return null;
  const { renderer, context, screen, slow } = all;
  const drawn = renderer.domElement;
  const view = { canvas, width: 0, height: 0, again: () => {} };
  let sharpness = 1;
  /** Pixels to a CSS pixel. */
  const pixelRatio = () => Math.min(2, windowOf(canvas).devicePixelRatio) * sharpness;
  views.add(view);
  // One that was alone has its picture copied from now on.
  if (drawn.isConnected) for (const { again } of views) again();
  /** For paper it is copied too: what the graphics card shows need not be printed; and for another window, which may be closed. */
  const isAlone = () => views.size === 1 && sharpness === 1 && canvas.ownerDocument === document;
  signal?.addEventListener('abort', () => {
    views.delete(view);
    // Out of the view, and out of the document into which the view may have taken it.
    if (drawn.previousSibling === canvas) document.adoptNode(drawn);
    root.traverse(free);
  });
  return {
    /** Whether pictures are computed without a graphics card. */
    slow,
    /** Not while the context is lost, nor when it has ended. */
    get isReady() {
      return views.has(view) && !context.isContextLost();
    },
    /** How many times as sharp as a screen needs; from the next change of size on. @param {number} next */
    setSharpness(next) {
      sharpness = next;
    },
    /** The canvas is empty then. @param {number} width @param {number} height in CSS pixels */
    resize(width, height) {
      Object.assign(view, { width, height });
      const ratio = pixelRatio();
      Object.assign(canvas, { width: Math.floor(width * ratio), height: Math.floor(height * ratio) });
    },
    /**
     * Makes the programs for such things, and does not wait for them. They are only finished when something is drawn with them: one
     * pixel is, which the first picture takes the place of.
     * @param {import('three').Object3D[]} things that have programs of their own
     * @param {import('three').Group} samples what is in the scene meanwhile, so that each of them has something to draw
     * @param {import('three').Camera} camera
     */
    async prepare(things, samples, camera) {
      if (context.getExtension('KHR_parallel_shader_compile')) await Promise.all(things.map((one) => renderer.compileAsync(one, camera, root)));
      else {
        for (const one of things) renderer.compile(one, camera, root);
        // Whether they are linked cannot be asked; they should be once the page has been made.
        await new Promise((done) => setTimeout(done));
      }
      if (!this.isReady || drawn.isConnected || views.size > 1) return;
      for (const set of /** @type {const} */ (['setViewport', 'setScissor'])) renderer[set](0, 0, 1, 1);
      root.add(samples);
      renderer.render(root, camera);
      root.remove(samples);
      // What they are made of ends here; only their programs stay.
      samples.traverse((one) => /** @type {Partial<import('three').Mesh>} */ (one).geometry?.dispose());
      // Else it begins with the first picture.
      context.flush();
    },
    /** @param {import('three').Camera} camera @param {boolean} smooth whether edges are */
    draw(camera, smooth) {
      const { width, height } = canvas;
      // It has no size yet, or none any more.
      if (!view.width || !view.height) return;
      const ratio = pixelRatio();
      makeRoom(renderer, ratio);
      // The part at the upper left; the renderer counts from below.
      const below = drawn.height - height;
      pictureSize.set(view.width, view.height);
      if (smooth) screen.begin(0, below, width, height);
      else for (const set of /** @type {const} */ (['setViewport', 'setScissor'])) renderer[set](0, below / ratio, width / ratio, height / ratio);
      renderer.render(root, camera);
      if (smooth) screen.end();
      view.again = () => this.draw(camera, smooth);
      if (isAlone()) {
        if (drawn.previousSibling === canvas) return;
        pen.clearRect(0, 0, width, height);
        canvas.after(drawn);
      } else {
        // In place of what was there.
        pen.globalCompositeOperation = 'copy';
        pen.drawImage(drawn, 0, 0, width, height, 0, 0, width, height);
        if (drawn.previousSibling === canvas) drawn.remove();
      }
    },
  };
}

/** @param {WebGLRenderer} renderer @param {number} ratio */
function makeRoom(renderer, ratio) {
  const most = (/** @type {'width' | 'height'} */ side) => Math.max(...[...views].map((view) => view[side]));
  const [width, height] = [most('width'), most('height')];
  if (renderer.getPixelRatio() !== ratio) renderer.setPixelRatio(ratio);
  const { width: across, height: down } = renderer.domElement;
  if (across !== Math.floor(width * ratio) || down !== Math.floor(height * ratio)) renderer.setSize(width, height, false);
}

/** @param {any} object of a scene that is drawn no more */
function free(object) {
  object.geometry?.dispose();
  for (const one of [object.material ?? []].flat()) one.dispose();
  // Shadows of a light, places of copies.
  object.dispose?.();
}

/** @param {WebGL2RenderingContext} context */
function isSoftware(context) {
  const names = context.getExtension('WEBGL_debug_renderer_info');
  const name = context.getParameter(names ? names.UNMASKED_RENDERER_WEBGL : context.RENDERER);
  return /swiftshader|llvmpipe|software|basic render/i.test(String(name));
}

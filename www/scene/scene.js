/**
 * The 3D view: light, ground, linkage, motions. Draws when it is told to, and tells when it has something to draw.
 *
 * @typedef {import('../types.js').Motion} Motion
 * @typedef {import('../types.js').Result} Result
 */
import { Scene, WebGLRenderer } from 'three';
import { createCamera } from './camera.js';
import { createGround } from './ground.js';
import { createLabels } from './labels.js';
import { createLight } from './light.js';
import { Linkage } from './linkage.js';
import { createMaterials } from './materials.js';
import { createMeasure } from './measure.js';
import { MotionPaths } from './motion-paths.js';
import { readPalette } from './palette.js';

/**
 * @param {{canvas: HTMLCanvasElement, labels: HTMLElement}} place
 * @param {() => void} changed
 * @returns null where the browser has no WebGL 2
 */
export function createScene({ canvas, labels: layer }, changed) {
  const context = canvas.getContext('webgl2', { antialias: true, alpha: true });
  if (!context) return null;
  const renderer = new WebGLRenderer({ canvas, context });
  renderer.shadowMap.enabled = true;
  const root = new Scene();
  const view = createCamera(canvas, changed);
  const labels = createLabels(layer);
  const materials = createMaterials();
  const light = createLight(isSoftware(context), changed);
  const ground = createGround();
  const linkage = new Linkage(materials);
  const paths = new MotionPaths(materials);
  const { size, take } = createMeasure();
  root.add(...light.objects, ground.group, linkage.group, paths.group);

  function paint() {
    const palette = readPalette(canvas);
    materials.paint(palette);
    light.sky.groundColor.copy(palette.ground);
    ground.material.color.copy(palette.grid);
    changed();
  }
  paint();
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', paint);
  addEventListener('themechange', paint);

  let width = 1;
  let height = 1;
  function resize() {
    width = Math.max(1, canvas.clientWidth);
    height = Math.max(1, canvas.clientHeight);
    renderer.setPixelRatio(Math.min(2, devicePixelRatio));
    renderer.setSize(width, height, false);
    view.setAspect(width / height);
    changed();
  }
  new ResizeObserver(resize).observe(canvas);
  resize();

  let built = false;
  let draws = 0;
  return {
    fit: view.fit,

    /**
     * @param {Result} result with a motion
     * @param {boolean} afresh another mechanism: look at it from the front again
     */
    show({ motion, document }, afresh) {
      if (!motion || !document) return;
      built = true;
      if (take(motion, document, afresh)) {
        view.setHome(size.centre, size.radius * 0.95);
        light.aim(size.centre, size.radius);
      }
      ground.lay(size.centre, size.radius, size.ground);
      linkage.update(motion, document, size.link, size.ground);
      paths.update(motion, document, size.link, linkage.body);
      labels.set([...paths.labels, ...linkage.bases.map((at, index) => ({ at, text: String(index + 1), place: `chains[${index}].base` }))]);
      if (afresh) view.fit();
      changed();
    },

    /** @param {import('./frame.js').Shown} what the columns and the frame in them that are drawn */
    draw(what) {
      if (built) {
        linkage.show(what);
        paths.show(what);
      }
      light.beforeDraw();
      renderer.render(root, view.camera);
      labels.place(view.camera, width, height);
      canvas.dataset.draws = String(++draws);
    },
  };
}

/** Whether pictures are computed without a graphics card. @param {WebGL2RenderingContext} context */
function isSoftware(context) {
  const names = context.getExtension('WEBGL_debug_renderer_info');
  const name = context.getParameter(names ? names.UNMASKED_RENDERER_WEBGL : context.RENDERER);
  return /swiftshader|llvmpipe|software|basic render/i.test(String(name));
}

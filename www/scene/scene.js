/**
 * The 3D view: light, ground, linkage, motions. Draws when it is told to, and tells when it has something to draw.
 *
 * @typedef {import('../types.js').Motion} Motion
 * @typedef {import('../types.js').Result} Result
 */
import {
  Box3, DirectionalLight, DoubleSide, HemisphereLight, MeshBasicMaterial, MeshStandardMaterial, Scene, Sphere, Vector3, WebGLRenderer,
} from 'three';
import { createCamera } from './camera.js';
import { POSE, originOf } from './frame.js';
import { createGround } from './ground.js';
import { createLabels } from './labels.js';
import { Linkage } from './linkage.js';
import { MotionPaths } from './motion-paths.js';
import { readPalette } from './palette.js';

/** A link's radius as a share of the scene's. */
const LINK_RADIUS = 0.024;

/** How much the scene may grow or shrink before its bodies are drawn in new proportions: typing should not pump them. */
const KEEP_SIZE = 1.5;

/** Without a graphics card, the rest in milliseconds after which the picture is drawn once more, with shadows. */
const REST = 250;

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
  const slow = isSoftware(context);
  const scene = new Scene();
  const view = createCamera(canvas, changed);
  const labels = createLabels(layer);
  const linkage = new Linkage();
  const paths = new MotionPaths();

  const solid = () => new MeshStandardMaterial({ roughness: 0.55, metalness: 0.05 });
  const materials = {
    chain: Array.from({ length: 5 }, () => new MeshStandardMaterial({ roughness: 0.5, metalness: 0.05, side: DoubleSide })),
    metal: new MeshStandardMaterial({ roughness: 0.4, metalness: 0.15 }),
    dark: new MeshStandardMaterial({ roughness: 0.45, metalness: 0.1 }),
    workpiece: solid(),
    goal: new MeshStandardMaterial({ roughness: 0.8 }),
    closest: new MeshStandardMaterial({ roughness: 0.8 }),
    gap: new MeshBasicMaterial(),
    ghost: new MeshStandardMaterial({ transparent: true, opacity: 0.26, depthWrite: false, roughness: 0.9 }),
    axes: [0, 1, 2].map(() => new MeshBasicMaterial()),
    faintAxes: [0, 1, 2].map(() => new MeshBasicMaterial({ transparent: true, opacity: 0.35 })),
  };

  const sky = new HemisphereLight(0xffffff, 0xb9b4ac, 1.9);
  sky.position.set(0, 0, 1);
  const sun = new DirectionalLight(0xffffff, 2.0);
  sun.castShadow = true;
  sun.shadow.mapSize.set(1024, 1024);
  sun.shadow.radius = 5;
  sun.shadow.bias = -0.0006;
  sun.shadow.normalBias = 0.01;
  const ground = createGround();
  scene.add(sky, sun, sun.target, ground.group, linkage.group, paths.group);

  function paint() {
    const palette = readPalette(canvas);
    materials.chain.forEach((material, index) => material.color.copy(palette[/** @type {'chain-0'} */ (`chain-${index}`)]));
    materials.metal.color.copy(palette.metal);
    materials.dark.color.copy(palette['dark-metal']);
    materials.workpiece.color.copy(palette.workpiece);
    materials.goal.color.copy(palette.goal);
    materials.closest.color.copy(palette.closest);
    materials.gap.color.copy(palette.gap);
    materials.ghost.color.copy(palette.goal);
    for (const axes of [materials.axes, materials.faintAxes]) {
      axes.forEach((material, axis) => material.color.copy(palette[/** @type {'axis-x'} */ (`axis-${'xyz'[axis]}`)]));
    }
    sky.groundColor.copy(palette.ground);
    ground.material.color.copy(palette.grid);
    changed();
  }
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', paint);

  const size = { radius: 0, centre: new Vector3() };

  /** Measures the motion; keeps the old proportions if they still do. @param {Motion} motion @param {boolean} afresh */
  function measure(motion, afresh) {
    const box = new Box3();
    for (const column of [motion.rows, motion.pose, motion.goal]) {
      for (let i = 0; i * POSE < column.length; i++) box.expandByPoint(originOf(column, i));
    }
    const { center, radius } = box.getBoundingSphere(new Sphere());
    const ratio = radius / size.radius;
    if (!afresh && ratio < KEEP_SIZE && ratio > 1 / KEEP_SIZE) return;
    size.radius = Math.max(radius, 1e-6);
    size.centre.copy(center);
    view.setHome(center, size.radius * 0.95);
  }

  function setSun() {
    const { radius, centre } = size;
    sun.position.copy(centre).add(new Vector3(0.9, -0.7, 2.2).multiplyScalar(radius * 1.6));
    sun.target.position.copy(centre);
    const reach = 1.7 * radius;
    Object.assign(sun.shadow.camera, { left: -reach, right: reach, top: reach, bottom: -reach, near: 0.1 * radius, far: 9 * radius });
    sun.shadow.camera.updateProjectionMatrix();
  }

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

  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let rest;
  let resting = false;
  /** Shadows double the work: on a slow machine they wait until nothing moves. */
  function waitForRest() {
    sun.castShadow = resting;
    clearTimeout(rest);
    if (!resting) {
      rest = setTimeout(() => {
        resting = true;
        changed();
      }, REST);
    }
    resting = false;
  }

  let built = false;
  return {
    fit: view.fit,

    /**
     * @param {Result} result with a motion
     * @param {boolean} afresh another mechanism: look at it from the front again
     */
    show({ motion, document }, afresh) {
      if (!motion || !document) return;
      built = true;
      measure(motion, afresh);
      const r = LINK_RADIUS * size.radius;
      const bases = document.chains.map((chain) => Number(chain.base?.z) || 0);
      const height = Math.min(...bases) - 3.5 * r;
      ground.lay(size.centre, size.radius, height);
      setSun();
      linkage.build(motion, document, materials, r, height);
      paths.build(motion, document, materials, r, linkage.body);
      labels.set(paths.labels);
      paint();
      if (afresh) view.fit();
      changed();
    },

    /** @param {import('./frame.js').Shown} what the columns and the frame in them that are drawn */
    draw(what) {
      if (built) {
        linkage.show(what);
        paths.show(what);
      }
      if (slow) waitForRest();
      renderer.render(scene, view.camera);
      labels.place(view.camera, width, height);
    },
  };
}

/** Whether pictures are computed without a graphics card. @param {WebGL2RenderingContext} context */
function isSoftware(context) {
  const names = context.getExtension('WEBGL_debug_renderer_info');
  const name = context.getParameter(names ? names.UNMASKED_RENDERER_WEBGL : context.RENDERER);
  return /swiftshader|llvmpipe|software|basic render/i.test(String(name));
}

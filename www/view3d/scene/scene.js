/**
 * The 3D view: light, ground, linkage, motions. Draws when it is told to, and tells when it has something to draw.
 *
 * @typedef {import('../../core/types.js').Motion} Motion
 * @typedef {import('../../core/types.js').Result} Result
 */
import { Scene, Sphere } from 'three';
import { createAdded } from './added.js';
import { createCamera } from './camera.js';
import { gapSteps } from './gap-lines.js';
import { ghostFrames } from './ghosts.js';
import { WHOLE, freeShare, stayingOver } from './free-rectangle.js';
import { createGround } from './ground.js';
import { createLight } from './light.js';
import { Linkage } from './linkage.js';
import { createMarks } from './marks.js';
import { createMaterials } from './materials.js';
import { createMeasure } from './measure.js';
import { MotionPaths } from './motion-paths.js';
import { hasNoGoal, isDriven } from '../../core/shown.js';
import { STANDARD_VIEWS } from '../../core/standard-views.js';
import { pack } from './packed.js';
import { readPalette } from './palette.js';
import { createPicker } from './pick.js';
import { watchPointers } from './refit.js';
import { createDrawing } from './renderer.js';
import { createRest } from './rest.js';
import { samplesOf } from './samples.js';
import { windowOf } from '../../ui/dom.js';

/** How many times as sharp as the screen's a picture on paper is. */
const PAPER = 2;

/**
 * @param {{canvas: HTMLCanvasElement, labels: HTMLElement, signal?: AbortSignal, turned?: () => void}} place where it is, until when, and who is told when a
 *   hand turns it
 * @param {() => void} changed
 * @returns null where the browser has no WebGL 2
 */
export function createScene({ canvas, labels: layer, signal, turned = () => {} }, changed) {
  const root = new Scene();
  const drawing = createDrawing(canvas, root, signal);
  if (!drawing) return null;
  const window = windowOf(canvas);
  const view = createCamera(canvas, changed, turned, () => (printing ? room : (room = freeShare(canvas))).free);
  /** The part of the view that it was fitted into, and what lay over the view then. @type {ReturnType<typeof freeShare>} */
  let room = { free: WHOLE, over: [] };
  /** What lies over the view is not on paper, where the picture is still the same. */
  let printing = false;
  const materials = createMaterials();
  const light = createLight(!drawing.slow);
  const rest = createRest(drawing.slow, changed, () => pointing());
  const ground = createGround();
  const linkage = new Linkage(materials);
  linkage.group.name = 'linkage';
  const paths = new MotionPaths(materials);
  const { size, take } = createMeasure();
  const pointing = watchPointers(() => built && view.refit(), signal);
  const things = [linkage.group, paths.group];
  /** By the materials of their parts. @type {Map<import('three').Material, import('./packed.js').Packed>} */
  const packs = new Map();
  /** @type {import('./packed.js').DrawAsOne} */
  function drawAsOne(packed, materials) {
    for (const material of materials) packs.set(material, packed);
    root.add(packed);
  }
  const marks = createMarks(canvas, things, layer, drawAsOne);
  const pick = createPicker(things, canvas, () => view.camera);
  const packed = materials.packs.map(([one]) => one);
  const pictured = [...light.objects, ground.group, linkage.group, paths.group, ...packed];
  root.add(...pictured);
  for (const [one, own] of materials.packs) drawAsOne(one, own);
  // Of pictures that are exported too, which may have shadows where the view has none.
  root.onBeforeRender = () => {
    ground.beforeDraw(light.sun.castShadow);
    pack(root, packs);
  };
  const samples = samplesOf(materials);
  drawing.prepare([ground.lines, samples.own, ...packed], samples.all, view.camera);

  const added = createAdded(
    (part) => {
      for (const list of [things, pictured]) list.push(part.group);
      root.add(part.group);
      part.paint(readPalette(canvas));
    },
    () => {
      name();
      changed();
    },
  );

  function paint() {
    const palette = readPalette(canvas);
    materials.paint(palette);
    marks.paint(palette.accent);
    light.sky.groundColor.copy(palette.ground);
    ground.paint(palette);
    added.paint(palette);
    changed();
  }
  paint();
  window.matchMedia('(prefers-color-scheme: dark)').addEventListener('change', paint, { signal });
  addEventListener('synthetica-theme', paint, { signal });

  let width = 1;
  let height = 1;
  /** What was drawn last. @type {import('../../core/poses.js').Shown | null} */
  let last = null;
  function resize() {
    width = Math.max(1, canvas.clientWidth);
    height = Math.max(1, canvas.clientHeight);
    drawing?.resize(width, height);
    view.setAspect(width / height);
    marks.resize(width, height);
    // At once: a canvas of another size is empty.
    if (last) draw(last);
    changed();
  }
  const sizes = new window.ResizeObserver(resize);
  sizes.observe(canvas);
  resize();
  const over = new window.ResizeObserver(() => !pointing() && view.settle());
  for (const one of stayingOver(canvas)) over.observe(one);

  const names = () => [...paths.labels, ...linkage.bases.map((at, index) => ({ at, text: String(index + 1), place: `chains[${index}].base` })), ...added.names()];

  const name = () => marks.name(options.show.names ? names() : []);

  /** @type {Pick<import('../../core/types.js').View, 'show' | 'ghosts' | 'posture'>} */
  let options = { show: { goal: true, closest: true, gaps: true, names: true, ground: true, axes: true, holds: true, freedoms: false }, ghosts: 'none', posture: null };
  /** @type {Pick<Result, 'motion' | 'doc'>} */
  let shown = { motion: null, doc: null };

  /** Nothing is drawn of a goal where there is none. */
  function showParts() {
    const { show } = options;
    materials.show(hasNoGoal({ result: shown, view: options }) ? { ...show, goal: false, gaps: false } : show);
  }

  let built = false;
  let draws = 0;

  /** @param {import('../../core/poses.js').Shown} what */
  function pose(what) {
    if (!built) return;
    linkage.show(what);
    paths.show(what);
    added.pose(what);
  }

  /** @param {import('../../core/poses.js').Shown} what the columns and the frame in them that are drawn */
  function draw(what) {
    if (!drawing?.isReady) return;
    last = what;
    view.step();
    view.camera.updateMatrixWorld();
    pose(what);
    marks.follow();
    for (const tell of drawn) tell(width, height);
    const fine = printing || rest.next();
    light.beforeDraw(view.camera, fine);
    drawing.draw(view.camera, fine);
    const over = room.over.map((box) => ({ x: box.x * width, y: box.y * height, width: box.width * width, height: box.height * height }));
    marks.labels.place(view.camera, width, height, size, [...over, ...[...covering].flatMap((boxes) => boxes())]);
    canvas.dataset.draws = String(++draws);
  }

  // It listens to the document too.
  signal?.addEventListener('abort', () => {
    view.controls.dispose();
    sizes.disconnect();
    over.disconnect();
  });

  /** @type {Set<(event: PointerEvent) => boolean>} */
  const claimants = new Set();
  /** @type {Set<(width: number, height: number) => void>} */
  const drawn = new Set();
  /** @type {Set<() => import('./label-layout.js').Box[]>} */
  const covering = new Set();
  return {
    canvas,
    /** Where other bodies, such as handles, are added. */
    root,
    drawAsOne,
    changed,
    /** Takes the colours that its place has by now. */
    paint,
    /** What others add, with what the legend says of it. */
    added,
    /** What belongs into a picture; handles and the like do not. */
    pictured,
    /** The names that always stand in the scene. */
    get names() {
      return names();
    },
    fit: view.fit,
    /** @param {import('../../core/standard-views.js').StandardView} side @param {boolean} [smooth] */
    turnTo: (side, smooth) => view.turnTo(STANDARD_VIEWS[side], smooth),
    /** By a hand. @param {{around: number, down: number}} from */
    lookFrom(from) {
      turned();
      view.turnTo(from);
    },
    turn: view.turn,
    setParallel: view.setParallel,
    /** The sizes at which gaps are drawn in another way, in lengths. */
    get gapSteps() {
      return gapSteps(size.radius);
    },
    /** What is drawn, and where ghosts stand. @param {Pick<import('../../core/types.js').View, 'show' | 'ghosts' | 'posture'>} next */
    choose({ show, ghosts, posture }) {
      const before = options;
      options = { show, ghosts, posture };
      showParts();
      if (show === before.show && ghosts === before.ghosts && isDriven(posture) === isDriven(before.posture)) return;
      ground.group.visible = show.ground;
      const { motion, doc } = shown;
      if (motion && doc) paths.showGhosts(motion, ghostFrames(ghosts, motion, doc), linkage.body);
      name();
      changed();
    },
    /** Brings a thing into the middle. @param {string} place @returns {boolean} false if there is no such thing */
    fitTo(place) {
      const box = marks.boxOf(place);
      if (box.isEmpty()) return false;
      const { center, radius } = box.getBoundingSphere(new Sphere());
      view.fitTo(center, Math.max(1.3 * radius, 0.1 * size.radius));
      return true;
    },
    /** Turning, shifting and zooming by hand. */
    controls: view.controls,
    get camera() {
      return view.camera;
    },
    size,
    /** Of the scene, and of a link. */
    get radius() {
      return size.radius;
    },
    get linkRadius() {
      return size.link;
    },
    /** The place of the thing under a pointer; empty for none. */
    pick,
    /** Asked before a pointer points at a thing or selects it: true takes the pointer. */
    claimants,
    /** @param {PointerEvent} event */
    claims: (event) => [...claimants].some((claim) => claim(event)),
    /** Called before every draw, with the size of the canvas in CSS pixels. */
    drawn,
    /** Asked in every draw for what stands over the view, which the names must not cover. */
    covering,

    /**
     * Outlines what is chosen and what is pointed at, and names them unless the text is empty.
     * @param {{place: string, text: string}} select
     * @param {{place: string, text: string}} point
     */
    highlight(select, point) {
      if (!built) return;
      // An outline is of a body, which must be there first.
      const other = shown.doc && paths.keep(select.place, shown.doc);
      if (!marks.set(select, point)) {
        if (!other) return;
        marks.outline();
      }
      name();
      changed();
    },

    /**
     * @param {Result} result with a motion
     * @param {boolean} afresh another mechanism: look at it from the front again
     * @param {boolean} [moving] whether a hand moves something: it is to be shown again when the hand rests
     */
    show({ motion, plain: doc }, afresh, moving = false) {
      if (!motion || !doc) return;
      built = true;
      shown = { motion, doc };
      showParts();
      // It is measured when the hand rests: neither the ground nor the bodies' widths jump under it.
      if (!moving || afresh) {
        if (take(motion, doc, afresh)) light.aim(size.centre, size.radius);
        view.setHome(size.home);
        ground.lay(size.centre, size.radius, size.ground);
      }
      const bodies = linkage.update(motion, doc, size.link, size.ground);
      const keys = paths.update(motion, doc, size, linkage.body, ghostFrames(options.ghosts, motion, doc));
      if (bodies || keys) marks.outline();
      name();
      if (afresh) view.begin();
      else if (!pointing()) view.refit();
      changed();
    },

    /** Puts everything where it is, without drawing. @param {import('../../core/poses.js').Shown} what the columns and the frame in them */
    pose,

    draw,

    /** For paper: sharper, in the colours that its place has by then, and without handles. @param {boolean} on */
    print(on) {
      printing = on;
      const handles = root.children.filter((thing) => on && thing.visible && !pictured.includes(thing));
      for (const one of handles) one.visible = false;
      drawing.setSharpness(on ? PAPER : 1);
      paint();
      resize();
      for (const one of handles) one.visible = true;
    },
  };
}

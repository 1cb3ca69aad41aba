/**
 * The axes of chains by axes, drawn at the home position while they are typed, and points picked in the view: on what is there
 * already, which snaps, else on the ground plane z = 0, else beside the workpiece.
 *
 * @typedef {import('../core/types.js').Joint} Joint
 */
import { ConeGeometry, Group, Mesh, MeshBasicMaterial, CylinderGeometry, Plane, Quaternion, Raycaster, SphereGeometry, Vector2, Vector3 } from 'three';
import { isByAxes } from '../core/by-axes.js';
import { POSE, originOf } from '../core/poses.js';
import { groupAt, shown } from '../core/shown.js';
import { typedNumber } from '../core/typed-number.js';
import { readPalette } from './scene/palette.js';
import { drawnRows } from './scene/spherical.js';

/** How near to a known point a click takes it, in pixels. */
const SNAP = 16;
/** Sizes in link radii. */
const LONG = 9;
const THIN = 0.22;
const UP = new Vector3(0, 1, 0);

/** @param {import('../panels/tables/typed-parts.js').View & {scene: NonNullable<import('../element/workbench.js').App['scene']>}} app */
export function createAxesView({ store, scene, signal }) {
  const group = new Group();
  group.visible = false;
  scene.root.add(group);
  const palette = readPalette(scene.canvas);
  const plain = new MeshBasicMaterial({ color: palette.closest, depthTest: false, transparent: true, opacity: 0.85 });
  const lit = new MeshBasicMaterial({ color: palette.accent, depthTest: false, transparent: true });
  const shapes = { shaft: new CylinderGeometry(1, 1, 1, 10), tip: new ConeGeometry(1, 1, 14), ball: new SphereGeometry(1, 14, 10) };
  let active = '';

  /** A vector of the document, as far as its numbers are known. @param {string} path @returns {Vector3 | null} */
  function vectorAt(path) {
    const numbers = [0, 1, 2].map((i) => typedNumber(store, `${path}[${i}]`));
    return numbers.every((value) => value !== null) ? new Vector3(.../** @type {[number, number, number]} */ (numbers)) : null;
  }

  /** The points of a chain's joints; one without takes that of its neighbour. @param {number} chain */
  function pointsOf(chain) {
    const points = store.doc.chains[chain].joints.map((_, j) => vectorAt(`chains[${chain}].joints[${j}].point`));
    return points.map((point, j) => point ?? points.slice(0, j).reverse().find(Boolean) ?? points.find(Boolean) ?? null);
  }

  /** @param {Vector3} at @param {Vector3} direction @param {number} long @param {import('three').Material} material */
  function arrow(at, direction, long, material) {
    const r = scene.linkRadius;
    const along = direction.clone().normalize();
    const [shaft, tip] = [new Mesh(shapes.shaft, material), new Mesh(shapes.tip, material)];
    shaft.scale.set(THIN * r, 2 * long * r, THIN * r);
    tip.scale.set(3 * THIN * r, r, 3 * THIN * r);
    tip.position.y = long * r;
    const whole = new Group();
    whole.add(shaft, tip);
    whole.position.copy(at);
    whole.quaternion.copy(new Quaternion().setFromUnitVectors(UP, along));
    group.add(whole);
  }

  function lay() {
    group.clear();
    store.doc.chains.forEach((chain, c) => {
      if (!isByAxes(chain)) return;
      const points = pointsOf(c);
      chain.joints.forEach((_, j) => {
        const place = `chains[${c}].joints[${j}]`;
        const at = points[j];
        const material = place === active ? lit : plain;
        if (!at) return;
        const ball = new Mesh(shapes.ball, material);
        ball.position.copy(at);
        ball.scale.setScalar(2.4 * THIN * scene.linkRadius);
        group.add(ball);
        for (const [field, long] of /** @type {const} */ ([['axis', LONG], ['second', LONG / 2]])) {
          const direction = vectorAt(`${place}.${field}`);
          if (direction && direction.lengthSq() > 0 && Number.isFinite(direction.lengthSq())) arrow(at, direction, long, material);
        }
      });
    });
    for (const mesh of group.children) mesh.traverse((part) => (part.renderOrder = 3));
    scene.canvas.dataset.axes = String(group.visible ? group.children.length : 0);
    scene.changed();
  }
  const follow = () => group.visible && lay();
  store.subscribe('document', follow);
  store.subscribe('result', follow);
  signal.addEventListener('abort', () => group.removeFromParent());

  /** Points that a click takes exactly: those of joints, the origins of the shown joints where they are drawn, key frames and the workpiece. */
  function known() {
    const points = store.doc.chains.flatMap((chain, c) => (isByAxes(chain) ? pointsOf(c).filter((point) => point !== null) : []));
    const [now, { motion }] = [shown(store), store.result];
    if (now && motion) {
      const rows = drawnRows(groupAt(now.rows, now), motion.report);
      for (let i = 0; i < rows.length / POSE; i++) points.push(originOf(rows, i));
      points.push(originOf(now.pose, now.index));
    }
    store.doc.motion.key_frames?.forEach((_, k) => {
      const point = ['x', 'y', 'z'].map((name) => typedNumber(store, `motion.key_frames[${k}].${name}`) ?? 0);
      points.push(new Vector3(...point));
    });
    return points;
  }

  /** The point under a click. @param {PointerEvent} event @returns {number[] | null} */
  function pointAt(event) {
    const { camera, canvas } = scene;
    const box = canvas.getBoundingClientRect();
    const [x, y] = [event.clientX - box.left, event.clientY - box.top];
    /** @type {Vector3 | null} */
    let nearest = null;
    let least = SNAP;
    for (const point of known()) {
      const screen = point.clone().project(camera);
      if (Math.abs(screen.z) > 1) continue;
      const far = Math.hypot(((screen.x + 1) / 2) * box.width - x, ((1 - screen.y) / 2) * box.height - y);
      if (far < least) [nearest, least] = [point, far];
    }
    // What is known is taken as it is, but for rounding.
    if (nearest) return /** @type {Vector3} */ (nearest).toArray().map((/** @type {number} */ value) => Number(value.toPrecision(12)) || 0);
    const ray = new Raycaster();
    ray.setFromCamera(new Vector2((x / box.width) * 2 - 1, 1 - (y / box.height) * 2), camera);
    const ground = ray.ray.intersectPlane(new Plane(new Vector3(0, 0, 1), 0), new Vector3());
    const now = shown(store);
    const centre = now ? originOf(now.pose, now.index) : new Vector3();
    const facing = new Plane().setFromNormalAndCoplanarPoint(camera.getWorldDirection(new Vector3()), centre);
    // A ground that is seen from its edge, or lies behind, is far away.
    const hit = ground && ground.distanceTo(centre) < 20 * scene.radius ? ground : ray.ray.intersectPlane(facing, new Vector3());
    if (!hit) return null;
    const step = 10 ** Math.floor(Math.log10(scene.radius / 100));
    return hit.toArray().map((value) => Number((Math.round(value / step) * step).toPrecision(12)) || 0);
  }

  return {
    /** @param {boolean} on @param {string} joint the one that is marked */
    show(on, joint) {
      group.visible = on;
      active = joint;
      lay();
    },
    /** A joint's point. @param {string} place @returns {number[] | null} */
    pointOf(place) {
      const [, chain, joint] = /^chains\[(\d+)\]\.joints\[(\d+)\]/.exec(place) ?? [];
      return pointsOf(Number(chain))[Number(joint)]?.toArray() ?? null;
    },
    /** The next point that is clicked; null after Escape. @param {AbortSignal} end @returns {Promise<number[] | null>} */
    pick(end) {
      const { canvas } = scene;
      return new Promise((resolve) => {
        const life = new AbortController();
        const claim = () => true;
        /** @type {PointerEvent | null} */
        let press = null;
        const done = (/** @type {number[] | null} */ point) => {
          life.abort();
          scene.claimants.delete(claim);
          canvas.classList.remove('picking');
          resolve(point);
        };
        scene.claimants.add(claim);
        canvas.classList.add('picking');
        const options = { signal: life.signal };
        canvas.addEventListener('pointerdown', (event) => (press = event), options);
        canvas.addEventListener('pointerup', (event) => {
          // A drag turns the view.
          if (!press || Math.hypot(event.clientX - press.clientX, event.clientY - press.clientY) > 8) return;
          const point = pointAt(event);
          if (point) done(point);
        }, options);
        window.addEventListener('keydown', (event) => {
          if (event.key === 'Escape') done(null);
        }, { ...options, capture: true });
        end.addEventListener('abort', () => done(null), options);
        if (end.aborted) done(null);
      });
    },
  };
}

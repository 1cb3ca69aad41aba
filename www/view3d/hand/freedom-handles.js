/**
 * Handles of the freedoms that the workpiece has here: a double arrow along each screw's path. A shift is a straight
 * one, a turn an arc about its axis, a screw a helix.
 *
 * @typedef {import('../../core/types.js').Insight['freedoms'][number]} Screw
 * @typedef {import('./pointer-drags.js').Pointer} Pointer
 * @typedef {{screw: Screw, origin: number[], from: Vector3, picker: Group, tip: Vector3, made: Group}} Handle
 */
import { CatmullRomCurve3, Group, Mesh, Raycaster, SphereGeometry, TubeGeometry, Vector2, Vector3 } from 'three';
import { POINTS, REACH, arrow, footOn, free, line, screwPath, tint } from './screw-shapes.js';
import { movePoint } from './screws.js';

/** Lengths as shares of the scene's radius. */
const HEAD = 0.038;
const PICK = { fine: 0.045, coarse: 0.09 };

/** Of a handle's line, in CSS pixels. */
const WIDTH = 4;

/** @param {NonNullable<import('../../element/workbench.js').App['scene']>} scene */
export function createFreedomHandles(scene) {
  const group = new Group();
  scene.root.add(group);
  /** @type {Handle[]} */
  let handles = [];
  let lit = -1;
  const colours = { plain: 0, lit: 0 };
  const raycaster = new Raycaster();

  /** @param {import('../scene/palette.js').Palette} palette */
  function paint(palette) {
    colours.plain = palette.closest.getHex();
    colours.lit = palette.gap.getHex();
    handles.forEach(({ made }, index) => tint(made, index === lit ? colours.lit : colours.plain));
  }

  /** @param {Screw} screw @param {ArrayLike<number>} pose @param {number} index */
  function build(screw, pose, index) {
    const r = scene.radius;
    const origin = Array.from(pose).slice(0, 3);
    const { from, points } = screwPath(screw, origin, r);
    const curve = new CatmullRomCurve3(points);
    const made = arrow(points, true, HEAD * r, WIDTH);
    if (screw.pitch !== null) {
      const axis = new Vector3(...screw.direction).multiplyScalar(REACH * r);
      const foot = footOn(screw, from);
      made.add(line([foot.clone().sub(axis), foot.clone().add(axis)], 1));
    }
    tint(made, colours.plain);
    const coarse = matchMedia('(pointer: coarse)').matches;
    const width = (coarse ? PICK.coarse : PICK.fine) * r;
    const picker = new Group();
    picker.add(new Mesh(new TubeGeometry(curve, POINTS, width, 6)));
    for (const end of [0, POINTS]) {
      const ball = new Mesh(new SphereGeometry(1.5 * width, 12, 8));
      ball.position.copy(points[end]).addScaledVector(curve.getTangent(end / POINTS), (end ? 1 : -1) * 1.3 * HEAD * r);
      picker.add(ball);
    }
    for (const part of picker.children) part.userData.index = index;
    picker.updateMatrixWorld();
    group.add(made);
    // The label stands beyond the arrow's head.
    const tip = points[POINTS].clone().addScaledVector(curve.getTangent(1), 2.6 * HEAD * r);
    return { screw, origin, from, picker, tip, made };
  }

  function clear() {
    free(group);
    for (const { picker } of handles) for (const part of picker.children) if (part instanceof Mesh) part.geometry.dispose();
    group.clear();
    if (handles.length) scene.changed();
    handles = [];
    lit = -1;
  }

  /** Which handle is at a place of the canvas; −1 for none. @param {Pointer} at */
  function pick(at) {
    raycaster.setFromCamera(new Vector2(at.x, at.y), scene.camera);
    const [hit] = raycaster.intersectObjects(handles.map(({ picker }) => picker));
    return hit ? /** @type {number} */ (hit.object.userData.index) : -1;
  }

  /** @param {number} index */
  function light(index) {
    if (index === lit) return;
    lit = index;
    handles.forEach(({ made }, i) => tint(made, i === lit ? colours.lit : colours.plain));
    scene.changed();
  }

  return {
    paint,
    pick,
    light,
    /** @param {Screw[]} screws @param {ArrayLike<number>} pose of the workpiece */
    show(screws, pose) {
      clear();
      handles = screws.map((screw, index) => build(screw, pose, index));
      scene.changed();
    },
    clear,
    /** The places of their names. */
    tips: () => handles.map(({ tip }) => tip),
    /**
     * How far along its screw a handle must go so that the point taken hold of stays under the pointer.
     * @param {number} index @param {Pointer} at where it was taken
     * @returns {(at: Pointer) => number} rad, or a length
     */
    follow(index, at) {
      const { screw, origin, picker } = handles[index];
      raycaster.setFromCamera(new Vector2(at.x, at.y), scene.camera);
      const [hit] = raycaster.intersectObject(picker);
      const taken = hit?.point.clone() ?? handles[index].from.clone();
      const along = { twist: screw.twist, origin };
      const seen = (/** @type {number} */ s) => movePoint(along, s, taken.clone()).project(scene.camera);
      // Along the screw: a length for a shift, else a radian.
      const unit = screw.pitch === null ? scene.radius : 1;
      const step = 1e-4 * unit;
      const aspect = scene.canvas.clientWidth / scene.canvas.clientHeight;
      // On the screen, in half heights of the canvas.
      const flat = (/** @type {Vector3} */ p) => new Vector2(p.x * aspect, p.y);
      const start = flat(seen(0));
      const offset = flat(new Vector3(at.x, at.y, 0)).sub(start);
      let s = 0;
      return (now) => {
        const wanted = flat(new Vector3(now.x, now.y, 0)).sub(offset);
        for (let round = 0; round < 8; round++) {
          const here = flat(seen(s));
          const slope = flat(seen(s + step)).sub(here).divideScalar(step);
          const steep = slope.lengthSq();
          // Seen end on, a path goes nowhere on the screen.
          if (steep * unit * unit < 1e-6) break;
          const most = screw.pitch === null ? scene.radius : 0.5;
          const change = Math.max(-most, Math.min(most, wanted.clone().sub(here).dot(slope) / steep));
          s += change;
          if (Math.abs(change) < step) break;
        }
        return s;
      };
    },
  };
}

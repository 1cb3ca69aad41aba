/**
 * The goal motion (dark) and the closest motion (light), key frames, the goal's ghost and the gap at the playhead.
 *
 * @typedef {import('../types.js').Motion} Motion
 * @typedef {import('three').Material} Material
 * @typedef {{goal: Material, closest: Material, gap: Material, ghost: Material, axes: Material[], faintAxes: Material[]}} PathMaterials
 */
import { Group, Mesh, Vector3 } from 'three';
import { frameMatrix, moveTo, originOf } from './frame.js';
import { dispose, layRod, rod, triad, tube } from './solids.js';

export class MotionPaths {
  group = new Group();
  /** Key frames' places and names. @type {{at: Vector3, text: string}[]} */
  labels = [];
  #ghost = new Group();
  #reached = new Group();
  /** @type {Group | null} */
  #gap = null;

  /**
   * @param {Motion} motion
   * @param {import('../types.js').MechanismDocument} document
   * @param {PathMaterials} materials
   * @param {number} r radius of a link
   * @param {import('three').BufferGeometry | null} body the workpiece's shape
   */
  build(motion, document, materials, r, body) {
    dispose(this.group);
    this.group.clear();
    this.#ghost.clear();
    this.#reached.clear();
    const points = (/** @type {Float64Array} */ column) => Array.from({ length: motion.frames }, (_, frame) => originOf(column, frame));
    this.group.add(new Mesh(tube(points(motion.goal), 0.42 * r), materials.goal));
    this.group.add(new Mesh(tube(points(motion.pose), 0.42 * r), materials.closest));

    this.labels = document.motion.key_frames.map((key, index) => {
      const place = triad(7 * r, materials.axes);
      frameMatrix(key).decompose(place.position, place.quaternion, place.scale);
      this.group.add(place);
      return { at: place.position.clone(), text: key.name || `key ${index + 1}` };
    });

    this.#gap = rod(new Vector3(), new Vector3(), 0.3 * r, materials.gap);
    if (body) this.#ghost.add(new Mesh(body, materials.ghost));
    this.#ghost.add(triad(6 * r, materials.faintAxes));
    this.#reached.add(triad(6 * r, materials.axes));
    this.group.add(this.#ghost, this.#reached, this.#gap);
    this.show({ ...motion, index: 0 });
  }

  /** @param {Pick<import('./frame.js').Shown, 'goal' | 'pose' | 'index'>} what */
  show({ goal, pose, index }) {
    moveTo(this.#ghost, goal, index);
    moveTo(this.#reached, pose, index);
    if (this.#gap) layRod(this.#gap, this.#ghost.position, this.#reached.position);
  }
}

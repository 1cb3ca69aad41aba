/**
 * The linkage as solid bodies: its chains and the workpiece they carry. Only what changed is built anew.
 *
 * @typedef {import('../../core/types.js').Motion} Motion
 * @typedef {import('../../core/types.js').MechanismDocument} MechanismDocument
 * @typedef {import('three').Material} Material
 * @typedef {{chain: Material[], metal: Material, dark: Material, contact: Material, limit: Material, workpiece: Material, axes: Material[]}} LinkageMaterials
 */
import { Group, Mesh, Quaternion, Vector3 } from 'three';
import { groupAt } from '../../core/shown.js';
import { ChainBody, PER_ROW } from './chain-body.js';
import { moveTo, originOf, turnOf } from '../../core/poses.js';
import { barrel, part } from './joint-shapes.js';
import { rod, roundedHull, solid } from './solids.js';
import { ballOf, onBall } from './spherical.js';

/** Widths in link radii. */
const BODY = 1.25;
const STALK = 0.7;

export class Linkage {
  group = new Group();
  /** The workpiece's shape, which the ghosts share. @type {import('three').BufferGeometry | null} */
  body = null;
  #materials;
  #workpiece = new Group();
  #bodyShape = '';
  /** `from`: the chain of a document that it was built for, which an edit of something else keeps. @type {{body: ChainBody, shape: string, from: object}[]} */
  #chains = [];
  /** @type {ReturnType<typeof ballOf>} */
  #ball = null;

  /** @param {LinkageMaterials} materials */
  constructor(materials) {
    this.#materials = materials;
    this.#workpiece.userData.place = 'workpiece';
    this.group.add(this.#workpiece);
  }

  /** Where the chains stand, in the fixed frame. */
  get bases() {
    return this.#chains.map(({ body }) => body.base.seat.position);
  }

  /**
   * @param {Motion} motion
   * @param {MechanismDocument} doc
   * @param {number} r radius of a link
   * @param {number} ground height of the ground plane
   * @returns {boolean} whether bodies were built anew
   */
  update(motion, doc, r, ground) {
    this.#ball = ballOf(motion);
    // What is built anew is built for the first frame.
    const placed = this.#ball ? { ...motion, rows: onBall(this.#ball, groupAt(motion.rows, { index: 0, frames: motion.frames })) } : motion;
    let anew = this.#chains.length !== motion.report.chains.length;
    let firstRow = 0;
    motion.report.chains.forEach((chain, index) => {
      const { joints, base } = doc.chains[index];
      const own = this.#chains[index];
      const size = `${r} ${firstRow} ${this.#ball?.reaches} `;
      const shape = own?.from === doc.chains[index] && own.shape.startsWith(size) ? own.shape : size + JSON.stringify([base, joints.map(({ type, rows }) => [type, rows])]);
      if (own?.shape !== shape) {
        anew = true;
        own?.body.group.removeFromParent();
        const link = this.#materials.chain[index % this.#materials.chain.length];
        const body = new ChainBody(placed, { index, firstRow, base }, { ...this.#materials, link }, r);
        this.#chains[index] = { body, shape, from: doc.chains[index] };
        this.group.add(body.group);
      }
      this.#chains[index].from = doc.chains[index];
      const { body } = this.#chains[index];
      body.base.stand(ground);
      body.fit(motion, joints);
      firstRow += chain.rows.length;
    });
    for (const { body } of this.#chains.splice(motion.report.chains.length)) body.group.removeFromParent();
    return this.#shapeWorkpiece(placed, r) || anew;
  }

  /** @param {Pick<import('../../core/poses.js').Shown, 'rows' | 'pose' | 'frames' | 'index'>} what */
  show({ rows, pose, frames, index }) {
    moveTo(this.#workpiece, pose, index);
    const own = groupAt(rows, { index, frames });
    const placed = this.#ball ? onBall(this.#ball, own) : own;
    for (const { body } of this.#chains) body.show(placed);
  }

  /** The hull of the chains' ends, with a flange where each chain holds it. @param {Motion} motion @param {number} r */
  #shapeWorkpiece(motion, r) {
    const ends = this.#ends(motion);
    // A hull takes longer than all else here, and most edits leave the workpiece as it is.
    const shape = JSON.stringify([r, ends.map((end) => end.toArray().map((value) => Math.round((value / r) * 1e4)))]);
    if (shape === this.#bodyShape) return false;
    this.#bodyShape = shape;
    this.body?.dispose();
    // What one chain carries reaches to its own origin, where the goal is.
    const corners = ends.length > 1 ? ends : [...ends, new Vector3()];
    this.body = roundedHull(corners, BODY * r);
    const middle = ends.reduce((sum, p) => sum.add(p), new Vector3()).divideScalar(ends.length);
    this.#workpiece.clear();
    this.#workpiece.add(solid(new Mesh(this.body, this.#materials.workpiece)));
    if (ends.length > 1 && middle.length() > 3 * r) this.#workpiece.add(rod(middle, new Vector3(), STALK * r, this.#materials.workpiece));
    ends.forEach((end, index) => this.#workpiece.add(this.#flange(end, ends.length > 1 ? middle : new Vector3(), index, r)));
    return true;
  }

  /** The chains' ends in the workpiece's frame, as they are in frame 0. @param {Motion} motion */
  #ends({ rows, pose, report }) {
    const origin = originOf(pose, 0);
    const turn = turnOf(pose, 0).invert();
    let row = 0;
    return report.chains.map((chain) => {
      row += chain.rows.length;
      return originOf(rows, PER_ROW * (row - 1) + 1).sub(origin).applyQuaternion(turn);
    });
  }

  /** A collar in the chain's colour on the side of its end that the workpiece is. @param {Vector3} end @param {Vector3} towards @param {number} index @param {number} r */
  #flange(end, towards, index, r) {
    const flange = new Group();
    const along = towards.clone().sub(end);
    const distance = along.length();
    along.normalize();
    flange.position.copy(end).addScaledVector(along, Math.min(3.1 * r, distance / 2));
    flange.quaternion.copy(new Quaternion().setFromUnitVectors(new Vector3(0, 0, 1), distance > 1e-9 * r ? along : new Vector3(0, 0, 1)));
    const { chain, metal } = this.#materials;
    flange.add(part(barrel(1.9, 0.9, 28), chain[index % chain.length]), part(barrel(2.15, 0.3, 28), metal, 0.36));
    flange.scale.setScalar(r);
    flange.userData.place = `chains[${index}].gripper`;
    return flange;
  }
}

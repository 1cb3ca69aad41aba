/**
 * The linkage as solid bodies: bases, joints by type, links along the common normals, the workpiece.
 * Every place comes from the planner's `rows` and `pose` columns; nothing is solved here.
 *
 * @typedef {import('../types.js').Motion} Motion
 * @typedef {import('../types.js').MechanismDocument} MechanismDocument
 * @typedef {import('../types.js').JointType} JointType
 * @typedef {import('./joint-shapes.js').JointShape} JointShape
 * @typedef {import('three').Material} Material
 * @typedef {{chain: Material[], metal: Material, dark: Material, workpiece: Material}} LinkageMaterials
 */
import { CylinderGeometry, Group, Mesh, Quaternion, Vector3 } from 'three';
import { POSE, frameMatrix, moveTo, originOf, turnOf } from './frame.js';
import { jointShape, part } from './joint-shapes.js';
import { dispose, rod, roundedHull } from './solids.js';

/** Poses of one row: its seat, then the moved frame. */
const PER_ROW = 2;

/** Widths in link radii. */
const LINK = 0.95;
const SHAFT = 0.75;
const BODY = 1.25;
const STALK = 0.7;

export class Linkage {
  group = new Group();
  /** The workpiece's shape, which the ghost at the goal shares. @type {import('three').BufferGeometry | null} */
  body = null;
  #bodyShape = '';
  #workpiece = new Group();
  /** @type {{shape: JointShape, first: number, last: number}[]} */
  #joints = [];

  /**
   * @param {Motion} motion
   * @param {MechanismDocument} document
   * @param {LinkageMaterials} materials
   * @param {number} r radius of a link
   * @param {number} ground height of the ground plane
   */
  build(motion, document, materials, r, ground) {
    dispose(this.group);
    this.group.clear();
    this.#workpiece.clear();
    this.#joints = [];
    const { rows } = motion;
    const up = new Vector3(0, 0, 1);
    let row = 0;
    /** Ends of the chains in the workpiece's frame. @type {Vector3[]} */
    const ends = [];
    const piece = { origin: originOf(motion.pose, 0), turn: turnOf(motion.pose, 0).invert() };

    motion.report.chains.forEach((chain, index) => {
      const link = materials.chain[index % materials.chain.length];
      const base = new Group();
      frameMatrix(document.chains[index]?.base).decompose(base.position, base.quaternion, base.scale);
      this.#addFoot(base.position, link, materials.metal, r, ground);
      this.group.add(base);
      /** The body that the next link belongs to, its place in frame 0, and the point before it. */
      let body = base;
      let before = base.position.clone().addScaledVector(up, -1);

      for (const [first, last, type] of jointsOf(chain.rows, row)) {
        const travel = travels(motion, first, last).map((t) => (type === 'E' ? withZero(t) : t));
        const shape = jointShape(type, r, { link, metal: materials.metal, dark: materials.dark }, travel);
        const seat = originOf(rows, PER_ROW * first);
        const end = originOf(rows, PER_ROW * last + 1);
        this.#addRod(body, placeOf(body), seat, LINK * r, link);
        if (seat.distanceTo(placeOf(body)) > r) before = placeOf(body);
        moveTo(shape.fixed, rows, PER_ROW * first);
        moveTo(shape.moved, rows, PER_ROW * last + 1);
        if (type === 'S') faceSocket(shape.fixed, before);
        // A constant offset along a revolute axis: the shaft lies on the axis, so it may turn with either side.
        if (type === 'R') this.#addRod(shape.moved, end, seat, SHAFT * r, materials.dark);
        this.group.add(shape.fixed, shape.moved);
        for (const extra of [shape.cross, shape.slide?.mesh]) if (extra) this.group.add(extra);
        if (shape.plate) layPlate(shape, motion, first, travel);
        this.#joints.push({ shape, first, last });
        if (end.distanceTo(seat) > r) before = seat;
        body = shape.moved;
      }
      ends.push(placeOf(body).sub(piece.origin).applyQuaternion(piece.turn));
      row += chain.rows.length;
    });

    // A hull takes longer than all else here, and most edits leave the workpiece as it is.
    const shape = JSON.stringify([r, ends.map((end) => end.toArray().map((value) => Number(value.toFixed(9))))]);
    if (shape !== this.#bodyShape || !this.body) this.body = roundedHull(ends, BODY * r);
    this.#bodyShape = shape;
    const solid = new Mesh(this.body, materials.workpiece);
    solid.castShadow = true;
    solid.receiveShadow = true;
    const middle = ends.reduce((sum, p) => sum.add(p), new Vector3()).divideScalar(ends.length);
    this.#workpiece.add(solid);
    if (middle.length() > 3 * r) this.#workpiece.add(rod(middle, new Vector3(), STALK * r, materials.workpiece));
    this.group.add(this.#workpiece);
    this.show({ ...motion, index: 0 });
  }

  /** @param {Pick<import('./frame.js').Shown, 'rows' | 'pose' | 'frames' | 'index'>} what */
  show({ rows, pose, frames, index }) {
    const offset = index * (rows.length / frames / POSE);
    const at = (/** @type {number} */ row) => offset + PER_ROW * row;
    moveTo(this.#workpiece, pose, index);
    for (const { shape, first, last } of this.#joints) {
      const seatTurn = shape.fixed.userData.turn;
      moveTo(shape.fixed, rows, at(first));
      if (seatTurn) shape.fixed.quaternion.multiply(seatTurn);
      moveTo(shape.moved, rows, at(last) + 1);
      if (shape.cross) moveTo(shape.cross, rows, at(first + 1));
      if (shape.slide) {
        const { mesh, before, after } = shape.slide;
        const seat = originOf(rows, at(first));
        const axis = new Vector3(0, 0, 1).applyQuaternion(turnOf(rows, at(first)));
        const travel = originOf(rows, at(first) + 1).sub(seat).dot(axis);
        const from = Math.min(0, travel) - (travel < 0 ? after : before);
        const to = Math.max(0, travel) + (travel < 0 ? before : after);
        // The rod turns with the link after the joint.
        moveTo(mesh, rows, at(first) + 1);
        mesh.position.copy(seat).addScaledVector(axis, (from + to) / 2);
        mesh.scale.z = Math.max(to - from, 1e-9);
      }
    }
  }

  /**
   * A rod in a moving body between two points given in the fixed frame, as they lie in frame 0.
   * @param {Group} body @param {Vector3} from @param {Vector3} to @param {number} radius @param {Material} material
   */
  #addRod(body, from, to, radius, material) {
    if (from.distanceTo(to) < radius * 0.2) return;
    const turn = body.quaternion.clone().invert();
    const local = (/** @type {Vector3} */ point) => point.clone().sub(body.position).applyQuaternion(turn);
    body.add(rod(local(from), local(to), radius, material));
  }

  /**
   * A foot under a base, with a post down to the ground if the base is above it.
   * @param {Vector3} at @param {Material} link @param {Material} metal @param {number} r @param {number} ground
   */
  #addFoot(at, link, metal, r, ground) {
    const foot = new Group();
    const height = at.z - ground;
    foot.position.set(at.x, at.y, ground);
    foot.add(part(new CylinderGeometry(3.6 * r, 4.0 * r, 0.8 * r, 40).rotateX(Math.PI / 2), link, 0.4 * r));
    foot.add(part(new CylinderGeometry(1.1 * r, 1.7 * r, Math.max(height, r), 28).rotateX(Math.PI / 2), metal, Math.max(height, r) / 2));
    this.group.add(foot);
  }
}

/** @param {import('three').Object3D} body */
const placeOf = (body) => body.position.clone();

/**
 * First row, last row and type of each joint of a chain.
 * @param {{kind: string, joint: number}[]} rows
 * @param {number} start
 * @returns {[number, number, JointType][]}
 */
function jointsOf(rows, start) {
  /** @type {[number, number, JointType][]} */
  const found = [];
  rows.forEach(({ kind, joint }, index) => {
    if (index > 0 && rows[index - 1].joint === joint) found[found.length - 1][1] = start + index;
    else found.push([start + index, start + index, /** @type {JointType} */ (kind)]);
  });
  return found;
}

/** How far each row slides along its axis over the motion. @param {Motion} motion @param {number} first @param {number} last */
function travels(motion, first, last) {
  const stride = motion.rows.length / motion.frames / POSE;
  return Array.from({ length: last - first + 1 }, (_, i) => {
    let low = Infinity;
    let high = -Infinity;
    for (let frame = 0; frame < motion.frames; frame++) {
      const travel = travelOf(motion, frame * stride, first + i);
      low = Math.min(low, travel);
      high = Math.max(high, travel);
    }
    return { low, high };
  });
}

/** @param {import('./joint-shapes.js').Travel} travel */
const withZero = ({ low, high }) => ({ low: Math.min(low, 0), high: Math.max(high, 0) });

/** @param {Motion} motion @param {number} offset poses before the frame @param {number} row */
function travelOf({ rows }, offset, row) {
  const at = offset + PER_ROW * row;
  const axis = new Vector3(0, 0, 1).applyQuaternion(turnOf(rows, at));
  return originOf(rows, at + 1).sub(originOf(rows, at)).dot(axis);
}

/**
 * Lays the plate of an E joint in its plane, under the middle of its travel, as part of the link before it.
 * @param {JointShape} shape at its place in frame 0
 * @param {Motion} motion
 * @param {number} first
 * @param {import('./joint-shapes.js').Travel[]} travel
 */
function layPlate({ fixed, plate }, motion, first, travel) {
  if (!plate) return;
  const turn = fixed.quaternion.clone().invert();
  const centre = new Vector3();
  travel.slice(0, 2).forEach(({ low, high }, i) => {
    const axis = new Vector3(0, 0, 1).applyQuaternion(turnOf(motion.rows, PER_ROW * (first + i)));
    centre.addScaledVector(axis, (low + high) / 2);
  });
  plate.position.copy(centre.applyQuaternion(turn));
  plate.quaternion.copy(turn).multiply(turnOf(motion.rows, PER_ROW * (first + 1)));
  fixed.add(plate);
}

/**
 * Turns a socket's closed side to the link that carries it.
 * @param {Group} fixed at its seat
 * @param {Vector3} before a point of that link, in the fixed frame
 */
function faceSocket(fixed, before) {
  const towards = before.clone().sub(fixed.position).applyQuaternion(fixed.quaternion.clone().invert());
  if (towards.lengthSq() < 1e-18) return;
  fixed.userData.turn = new Quaternion().setFromUnitVectors(new Vector3(0, 0, -1), towards.normalize());
}

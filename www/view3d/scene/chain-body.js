/**
 * One chain as solid bodies: base, joints by type, links along the common normals. Built from the planner's `rows` of
 * frame 0 and moved by those of any frame; nothing is solved here. What a body is, as a place in the document, is in
 * its `userData.place`; a link's place is the table row that holds its dimensions.
 *
 * @typedef {import('../../core/types.js').Motion} Motion
 * @typedef {import('../../core/types.js').JointType} JointType
 * @typedef {import('./joint-shapes.js').JointShape} JointShape
 * @typedef {import('three').Material} Material
 * @typedef {{shape: JointShape, first: number, last: number, centre: number, stops: ReturnType<typeof createStops> | null}} PlacedJoint
 *   `centre`: the pose of its first row at which it stands, 0 the seat, 1 the moved frame
 */
import { Group, Quaternion, Vector3 } from 'three';
import { createBase } from './base.js';
import { POSE, originOf, moveTo, turnOf } from '../../core/poses.js';
import { PLATE, jointShape } from './joint-shapes.js';
import { rod } from './solids.js';
import { createStops, travelLimits } from './stops.js';
import { travels } from './travel.js';

/** Poses of one row: its seat, then the moved frame. */
export const PER_ROW = 2;

/** Widths in link radii. */
const LINK = 0.95;
const SHAFT = 0.75;

export class ChainBody {
  group = new Group();
  #r;
  /** @type {PlacedJoint[]} */
  #joints = [];
  /** @type {ReturnType<typeof createBase>} */
  base;

  /**
   * @param {Motion} motion
   * @param {{index: number, firstRow: number, base: import('../../core/types.js').Frame | undefined}} chain its number, and its first row of all chains' rows
   * @param {{link: Material, metal: Material, dark: Material, contact: Material, limit: Material, axes: Material[]}} materials
   * @param {number} r radius of a link
   */
  constructor(motion, { index, firstRow, base }, materials, r) {
    this.#r = r;
    const { rows } = motion;
    const place = `chains[${index}]`;
    this.base = createBase(base, materials, r);
    this.base.group.userData.place = `${place}.base`;
    this.group.add(this.base.group);
    /** The body that the next link belongs to, where the link begins, and the point before it. */
    let body = this.base.seat;
    let from = body.position.clone();
    let before = from.clone().add(new Vector3(0, 0, -1));
    this.group.add(body);

    jointsOf(motion.report.chains[index].rows, firstRow).forEach(([first, last, type], joint) => {
      const shape = jointShape(type, r, materials);
      // S and T stand where their axes meet: an offset along the first axis is part of the link before.
      const centre = type === 'S' || type === 'T' ? 1 : 0;
      const seat = originOf(rows, PER_ROW * first + centre);
      const end = originOf(rows, PER_ROW * last + 1);
      const link = addRod(body, from, seat, LINK * r, materials.link);
      if (link) link.userData.place = `${place}.joints[${joint}].rows[0]`;
      if (seat.distanceTo(from) > r) before = from;
      moveTo(shape.fixed, rows, PER_ROW * first);
      shape.fixed.position.copy(seat);
      moveTo(shape.moved, rows, PER_ROW * last + 1);
      // One along the last axis is part of the link after.
      if (centre) shape.moved.children[0].position.copy(within(shape.moved, seat));
      if (type === 'S') faceSocket(shape.fixed, before);
      // A constant offset along a revolute axis: the shaft lies on the axis, so it may turn with either side.
      if (type === 'R') addRod(shape.moved, end, seat, SHAFT * r, materials.dark);
      if (type === 'E') {
        addRod(shape.moved, end, originOf(rows, PER_ROW * last), SHAFT * r, materials.dark);
        seatPlate(shape, motion, first, r);
      }
      for (const object of [shape.fixed, shape.moved, shape.cross, shape.puck, shape.slide?.mesh]) {
        if (!object) continue;
        object.userData.place = `${place}.joints[${joint}]`;
        this.group.add(object);
      }
      const stops = type === 'P' || type === 'C' ? createStops(type, materials, r) : null;
      if (stops) shape.fixed.add(stops.group);
      this.#joints.push({ shape, first, last, centre, stops });
      if (end.distanceTo(seat) > r) before = seat;
      body = shape.moved;
      from = centre ? seat : end;
    });
    // To where the workpiece has it.
    addRod(body, from, body.position, LINK * r, materials.link);
  }

  /** Sizes what slides to another motion of the same chain, and to other limits. @param {Motion} motion @param {import('../../core/types.js').Joint[]} joints */
  fit(motion, joints) {
    this.#joints.forEach(({ shape, first, last, stops }, joint) => {
      if (!shape.fit && !stops) return;
      const travel = travels(motion, first, last);
      shape.fit?.(travel);
      stops?.fit(travelLimits(joints[joint]), travel[0]);
    });
  }

  /** @param {Float64Array} rows of the shown frame */
  show(rows) {
    const at = (/** @type {number} */ row) => PER_ROW * row;
    for (const { shape, first, last, centre, stops } of this.#joints) {
      const seatTurn = shape.fixed.userData.turn;
      moveTo(shape.fixed, rows, at(first));
      shape.fixed.position.fromArray(rows, POSE * (at(first) + centre));
      if (seatTurn) shape.fixed.quaternion.multiply(seatTurn);
      moveTo(shape.moved, rows, at(last) + 1);
      if (shape.cross) moveTo(shape.cross, rows, at(first + 1));
      if (shape.puck) moveTo(shape.puck, rows, at(last));
      if (shape.slide) stops?.mark(this.#laySlide(shape.slide, rows, at(first)));
    }
  }

  /** @param {NonNullable<JointShape['slide']>} slide @param {Float64Array} rows @param {number} at the seat @returns {number} how far it is out */
  #laySlide({ mesh, before, after }, rows, at) {
    const seat = originOf(rows, at);
    const axis = new Vector3(0, 0, 1).applyQuaternion(turnOf(rows, at));
    const travel = originOf(rows, at + 1).sub(seat).dot(axis);
    const from = Math.min(0, travel) - (travel < 0 ? after : before);
    const to = Math.max(0, travel) + (travel < 0 ? before : after);
    // The rod turns with the link after the joint.
    moveTo(mesh, rows, at + 1);
    mesh.position.copy(seat).addScaledVector(axis, (from + to) / 2);
    mesh.scale.z = Math.max(to - from, 1e-6 * this.#r);
    return travel;
  }
}

/** A point of the fixed frame in a body, as it lies in frame 0. @param {Group} body @param {Vector3} point */
const within = (body, point) => point.clone().sub(body.position).applyQuaternion(body.quaternion.clone().invert());

/**
 * A rod in a moving body between two points given in the fixed frame, as they lie in frame 0.
 * @param {Group} body @param {Vector3} from @param {Vector3} to @param {number} radius @param {Material} material
 */
function addRod(body, from, to, radius, material) {
  if (from.distanceTo(to) < radius * 0.2) return null;
  const made = rod(within(body, from), within(body, to), radius, material);
  body.add(made);
  return made;
}

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

/**
 * Turns an E joint's plate into its plane and puts it on the side of the puck that the next link does not leave to.
 * @param {JointShape} shape at its place in frame 0
 * @param {Motion} motion @param {number} first row @param {number} r
 */
function seatPlate({ fixed, plate, puck }, { rows }, first, r) {
  if (!plate || !puck) return;
  const last = PER_ROW * (first + 2);
  const turn = fixed.quaternion.clone().invert();
  const seat = originOf(rows, last);
  const normal = new Vector3(0, 0, 1).applyQuaternion(turnOf(rows, last));
  const below = originOf(rows, last + 1).sub(seat).dot(normal) < 0;
  puck.children[0].rotation.x = below ? Math.PI : 0;
  const height = seat.sub(fixed.position).dot(normal) + (below ? PLATE : -PLATE) * 0.5 * r;
  plate.quaternion.copy(turn).multiply(turnOf(rows, PER_ROW * (first + 1)));
  plate.userData.offset = normal.multiplyScalar(height).applyQuaternion(turn);
  fixed.add(plate);
}

/**
 * Turns a socket's closed side to the link that carries it.
 * @param {Group} fixed at its seat
 * @param {Vector3} before a point of that link, in the fixed frame
 */
function faceSocket(fixed, before) {
  const towards = within(fixed, before);
  if (towards.lengthSq() < 1e-18) return;
  fixed.userData.turn = new Quaternion().setFromUnitVectors(new Vector3(0, 0, -1), towards.normalize());
}

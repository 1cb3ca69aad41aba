/**
 * The goal motion (dark), where there is a goal, and the closest motion (light), key frames, the goal's ghost, gaps, and ghosts of the workpiece.
 * Laid anew in place: a goal that is dragged costs no new bodies.
 *
 * @typedef {import('../../core/types.js').Motion} Motion
 * @typedef {import('three').Material} Material
 * @typedef {import('./stroke.js').StrokeMaterial} Line
 * @typedef {{goal: Line, closest: Line, gap: Line, gaps: Line[], ghost: Material, ghosts: Material, key: Material,
 *   axes: Material[], keyAxes: Material[], faintAxes: Material[]}} PathMaterials
 */
import { keyFramesOf } from '../../core/key-frames.js';
import { BufferGeometry, Group, Mesh, SphereGeometry, Vector3 } from 'three';
import { drivesJoints } from '../../core/driven.js';
import { frameMatrix, moveTo } from '../../core/poses.js';
import { spreadOver } from '../../core/spread.js';
import { curveThrough } from './curve.js';
import { GapLines } from './gap-lines.js';
import { Ghosts } from './ghosts.js';
import { shared, triad } from './solids.js';
import { Stroke } from './stroke.js';

/** Sizes in link radii. */
const APART = 0.04;
const KEY = 7;
const KEY_BALL = 0.85;
const AXES = 6;

/** At most so many key frames are marked, and so many of them named where some are left out: each is five bodies. */
const MARKS = 61;
const NAMES = 11;

/** From the goal to what is reached of it. */
const way = new Vector3();
const ends = new Float64Array(6);

export class MotionPaths {
  group = new Group();
  /** Key frames' places and names. @type {{at: Vector3, text: string, place: string}[]} */
  labels = [];
  #materials;
  #goal;
  #closest;
  /** @type {Group[]} */
  #keys = [];
  #ghost = new Group();
  #ghostBody;
  #ghostAxes;
  #reached;
  #gap;
  #gaps;
  #ghosts;
  #link = 1;
  /** The key frame that is marked in any case. */
  #own = -1;

  /** @param {PathMaterials} materials */
  constructor(materials) {
    this.#materials = materials;
    this.#goal = new Stroke(materials.goal);
    this.#goal.userData.place = 'goal';
    this.#closest = new Stroke(materials.closest);
    this.#closest.userData.place = 'closest';
    this.#ghostBody = new Mesh(new BufferGeometry(), materials.ghost);
    this.#ghostBody.userData.faint = true;
    this.#ghostAxes = triad(1, materials.faintAxes);
    this.#ghost.userData.place = 'goal';
    this.#ghost.add(this.#ghostBody, this.#ghostAxes);
    this.#reached = triad(1, materials.axes);
    this.#reached.userData.place = 'workpiece';
    this.#goal.userData.anchor = this.#ghost;
    this.#closest.userData.anchor = this.#reached;
    this.#gap = new Stroke(materials.gap);
    this.#gap.userData.place = 'gap';
    this.#gaps = new GapLines(materials.gaps);
    this.#ghosts = new Ghosts(materials.ghosts);
    this.group.add(this.#gaps.group, this.#ghosts.mesh);
    this.group.add(this.#goal, this.#closest, this.#ghost, this.#reached, this.#gap);
  }

  /**
   * @param {Motion} motion
   * @param {import('../../core/types.js').MechanismDocument} doc
   * @param {{link: number, radius: number}} size radii of a link and of the scene
   * @param {BufferGeometry | null} body the workpiece's shape
   * @param {number[]} ghosts frames
   * @returns {boolean} whether bodies are new or stand for other things
   */
  update(motion, doc, { link: r, radius }, body, ghosts) {
    this.#gaps.lay(motion, r, radius);
    if (body) this.#ghosts.lay(motion, ghosts, body);
    if (drivesJoints(motion)) this.#goal.visible = false;
    else layCurve(this.#goal, motion.goal, motion.frames, APART * r);
    layCurve(this.#closest, motion.pose, motion.frames, APART * r);
    if (body) this.#ghostBody.geometry = body;
    this.#ghostAxes.scale.setScalar(AXES * r);
    this.#reached.scale.setScalar(AXES * r);
    this.#link = r;
    return this.#markKeys(keyFramesOf(doc));
  }

  /** Marks a key frame that was left out among many. @param {string} place @param {import('../../core/types.js').MechanismDocument} doc @returns {boolean} whether it was */
  keep(place, doc) {
    const keys = keyFramesOf(doc);
    const own = Number(/^motion\.key_frames\[(\d+)]/.exec(place)?.[1] ?? -1);
    if (own === this.#own || keys.length <= MARKS) return false;
    this.#own = own;
    this.#markKeys(keys);
    return true;
  }

  /** All key frames, or some of many, evenly spread. @param {import('../../core/types.js').KeyFrame[]} keys @returns {boolean} whether marks are new or stand for other ones */
  #markKeys(keys) {
    const some = spreadOver(keys.length, MARKS, this.#own);
    const named = some.length < keys.length ? new Set(spreadOver(keys.length, NAMES, this.#own)) : null;
    let anew = this.#keys.length !== some.length;
    while (this.#keys.length > some.length) this.#keys.pop()?.removeFromParent();
    this.labels = some.flatMap((index, slot) => {
      const mark = (this.#keys[slot] ??= this.#addKey());
      const place = `motion.key_frames[${index}]`;
      anew ||= mark.userData.place !== place;
      mark.userData.place = place;
      frameMatrix(keys[index]).decompose(mark.position, mark.quaternion, mark.scale);
      mark.scale.setScalar(KEY * this.#link);
      const text = keys[index].name || `key ${index + 1}`;
      return named && !named.has(index) ? [] : [{ at: mark.position, text, place }];
    });
    return anew;
  }

  #addKey() {
    const mark = triad(1, this.#materials.keyAxes);
    // Wider than the motion that passes through, so that it can be pointed at.
    const ball = new Mesh(shared('key ball', () => new SphereGeometry(KEY_BALL / KEY, 20, 14)), this.#materials.key);
    mark.add(ball);
    mark.userData.anchor = mark;
    this.group.add(mark);
    return mark;
  }

  /** Other ghosts of the same motion. @param {Motion} motion @param {number[]} frames @param {BufferGeometry | null} body */
  showGhosts(motion, frames, body) {
    if (body) this.#ghosts.lay(motion, frames, body);
  }

  /** @param {Pick<import('../../core/poses.js').Shown, 'goal' | 'pose' | 'index'>} what */
  show({ goal, pose, index }) {
    moveTo(this.#ghost, goal, index);
    moveTo(this.#reached, pose, index);
    this.#gap.position.copy(this.#ghost.position);
    way.subVectors(this.#reached.position, this.#ghost.position).toArray(ends, 3);
    this.#gap.lay(ends, way.lengthSq() > 0 ? 2 : 0);
  }
}

/** From its first pose on. @param {Stroke} stroke @param {Float64Array} column poses @param {number} frames @param {number} apart */
function layCurve(stroke, column, frames, apart) {
  stroke.position.fromArray(column);
  const { points, count } = curveThrough(column, frames, apart);
  stroke.lay(points, count);
}

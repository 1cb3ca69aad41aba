/**
 * How large the scene is and where: measured from the motion, and the proportions of its bodies kept while they still fit,
 * so that typing and dragging do not make the bodies and the ground jump.
 *
 * @typedef {object} Home what is in view when all is
 * @property {Vector3} centre @property {number} radius of the ball that holds all of it, at every motion
 * @property {(visit: (point: Vector3) => void) => void} each a walk through its points; what is visited is only good until the visit is over
 * @property {number} margin how far bodies reach beyond the points
 */
import { keyFramesOf } from '../../core/key-frames.js';
import { Box3, Vector3 } from 'three';
import { drivesJoints } from '../../core/driven.js';
import { POSE } from '../../core/poses.js';
import { spreadOver } from '../../core/spread.js';
import { drawnRows } from './spherical.js';

/** How much the scene may grow, shrink or move by, in its own sizes, before its bodies are drawn in new proportions. */
const KEEP_SIZE = 1.5;
const KEEP_PLACE = 0.5;

/** A link's radius as a share of the linkage's; in a goal that is many times larger, of at least this share of the scene. */
const LINK_RADIUS = 0.024;
const LEAST_SHARE = 1 / 8;

/** From the lowest place of a link or a base to the ground, in link radii. */
const CLEAR = 3.5;

/** How far bodies reach beyond the points that they stand at, in link radii: the axes of a key frame, which are the longest. */
const BODY = 7;

/**
 * A frame of the answer that lies so many sizes away is left out: size and middle are those of what the document itself
 * asks for, the start, the goal and the key frames. A linkage of fixed links that follows its goal never comes so far.
 */
const RUNAWAY = 10;

/** At most so many frames, and key frames, are measured, evenly spread: neighbours lie close in longer motions. */
const FRAMES = 5_000;

/** Below this share of its distance from the origin a size is rounding. */
const ROUNDING = 1e-9;

export function createMeasure() {
  /** @type {{radius: number, centre: Vector3, link: number, ground: number, home: Home}} */
  const size = { radius: 0, centre: new Vector3(), link: 0, ground: 0, home: { centre: new Vector3(), radius: 1, each() {}, margin: 0 } };
  return {
    size,
    /**
     * @param {import('../../core/types.js').Motion} motion
     * @param {import('../../core/types.js').MechanismDocument} doc
     * @param {boolean} afresh
     * @returns {boolean} whether the proportions are new
     */
    take(motion, doc, afresh) {
      const { linkage, all, each } = boxesOf(motion, doc);
      const radius = radiusOf(all);
      const ratio = radius / size.radius;
      const centre = all.getCenter(new Vector3());
      const anew = afresh || !(ratio < KEEP_SIZE && ratio > 1 / KEEP_SIZE) || centre.distanceTo(size.centre) > KEEP_PLACE * size.radius;
      if (anew) {
        size.radius = radius;
        size.centre.copy(centre);
        size.link = LINK_RADIUS * Math.max(radiusOf(linkage), LEAST_SHARE * radius);
      }
      const lowest = Math.min(all.min.z, ...doc.chains.map((chain) => Number(chain.base?.z) || 0));
      const ground = lowest - CLEAR * size.link;
      // The ground gives way at once, and comes back only with new proportions.
      if (anew || ground < size.ground) size.ground = ground;
      let far = 0;
      each((point) => {
        far = Math.max(far, point.distanceToSquared(centre));
      });
      const margin = BODY * size.link;
      const feet = doc.chains.map(({ base }) => [Number(base?.x) || 0, Number(base?.y) || 0, size.ground]);
      size.home = {
        centre,
        radius: Math.sqrt(far) + margin,
        margin,
        each(visit) {
          each(visit);
          for (const foot of feet) visit(new Vector3(...foot));
        },
      };
      return anew;
    },
  };
}

/** Half the diagonal; 1 for a single point. @param {Box3} box */
function radiusOf(box) {
  const radius = box.getSize(new Vector3()).length() / 2;
  return radius > ROUNDING * box.getCenter(new Vector3()).length() ? radius : 1;
}

/**
 * The box of the linkage over all frames, that of everything, and a walk through the points in it.
 * @param {import('../../core/types.js').Motion} motion
 * @param {import('../../core/types.js').MechanismDocument} doc
 */
function boxesOf(motion, doc) {
  let { rows, pose, frames } = motion;
  let goal = drivesJoints(motion) ? pose : motion.goal;
  const number = (/** @type {unknown} */ value) => (typeof value === 'number' ? value : 0);
  const all = keyFramesOf(doc);
  const keys = Float64Array.from(spreadOver(all.length, FRAMES).flatMap((key) => [number(all[key].x), number(all[key].y), number(all[key].z), 0, 0, 0, 1]));
  const some = (/** @type {Float64Array} */ column) => thinned(column, frames);
  [rows, pose, goal] = [rows, pose, goal].map(some);
  frames = Math.min(frames, FRAMES);
  rows = drawnRows(rows, motion.report);
  const start = [rows.subarray(0, rows.length / frames), pose.subarray(0, POSE)];
  const asked = new Box3();
  walk([...start, goal, keys], (point) => asked.expandByPoint(point));
  const centre = asked.getCenter(new Vector3());
  const farthest = (RUNAWAY * radiusOf(asked)) ** 2;
  /** @param {(point: Vector3) => void} visit */
  const eachOfLinkage = (visit) => walk([rows, pose], (point) => point.distanceToSquared(centre) <= farthest && visit(point));
  const linkage = new Box3();
  eachOfLinkage((point) => linkage.expandByPoint(point));
  return {
    linkage,
    all: linkage.clone().union(asked),
    /** @param {(point: Vector3) => void} visit its argument is only good until it returns */
    each(visit) {
      eachOfLinkage(visit);
      walk([goal, keys], visit);
    },
  };
}

/** Of a column with many frames those that are measured. @param {Float64Array} column @param {number} frames */
function thinned(column, frames) {
  if (frames <= FRAMES) return column;
  const width = column.length / frames;
  const some = new Float64Array(FRAMES * width);
  spreadOver(frames, FRAMES).forEach((frame, i) => some.set(column.subarray(frame * width, (frame + 1) * width), i * width));
  return some;
}

/** Visits the origins of all poses that are numbers. @param {Float64Array[]} columns @param {(point: Vector3) => void} visit */
function walk(columns, visit) {
  const point = new Vector3();
  for (const column of columns) {
    for (let at = 0; at < column.length; at += POSE) {
      point.fromArray(column, at);
      if (Number.isFinite(point.x + point.y + point.z)) visit(point);
    }
  }
}

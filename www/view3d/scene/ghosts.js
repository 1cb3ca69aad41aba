/**
 * Ghosts: the workpiece as it stands at chosen frames of the closest motion.
 *
 * @typedef {import('../../core/types.js').Motion} Motion
 */
import { keyFramesOf } from '../../core/key-frames.js';
import { BufferGeometry, InstancedMesh, Matrix4, Vector3 } from 'three';
import { frameMatrix, originOf, turnOf } from '../../core/poses.js';
import { spreadOver } from '../../core/spread.js';

/** Ghosts spread over a motion, about so many. */
const SPREAD = 8;

/** At most so many ghosts at once. */
const MOST = 64;

/** Frames from one ghost to the next where they are spread. @param {number} frames */
export const ghostStep = (frames) => Math.max(1, Math.round((frames - 1) / SPREAD));

/**
 * The frames that have a ghost.
 * @param {import('../../core/types.js').View['ghosts']} ghosts
 * @param {Motion} motion
 * @param {import('../../core/types.js').MechanismDocument} doc
 * @returns {number[]}
 */
export function ghostFrames(ghosts, motion, doc) {
  const { frames } = motion;
  if (ghosts === 'none') return [];
  if (ghosts === 'keys') return ghostsOfKeys(motion, keyFramesOf(doc));
  if (ghosts === 'spread') return Array.from({ length: Math.floor((frames - 1) / ghostStep(frames)) + 1 }, (_, i) => i * ghostStep(frames));
  return ghosts.filter((frame) => frame < frames).slice(0, MOST);
}

/** Of many key frames some, evenly spread. @param {Motion} motion @param {import('../../core/types.js').KeyFrame[]} keys */
const ghostsOfKeys = (motion, keys) => [...new Set(spreadOver(keys.length, MOST).map((key) => nearestFrame(motion, keys[key])))];

/** The frame whose goal is nearest to a key frame: a shift by a length counts as a turn by 1 rad. @param {Motion} motion @param {import('../../core/types.js').KeyFrame} key */
function nearestFrame({ goal, frames }, key) {
  const place = new Vector3();
  const turn = turnOf(goal, 0);
  frameMatrix(key).decompose(place, turn, new Vector3());
  let nearest = 0;
  let least = Infinity;
  for (let frame = 0; frame < frames; frame++) {
    const far = originOf(goal, frame).distanceTo(place) + turnOf(goal, frame).angleTo(turn);
    if (far < least) [nearest, least] = [frame, far];
  }
  return nearest;
}

export class Ghosts {
  mesh;

  /** @param {import('three').Material} material */
  constructor(material) {
    this.mesh = new InstancedMesh(new BufferGeometry(), material, MOST);
    this.mesh.visible = false;
    this.mesh.frustumCulled = false;
    this.mesh.userData.faint = true;
    /** @type {string[]} */
    this.mesh.userData.places = [];
  }

  /** @param {Motion} motion @param {number[]} frames @param {BufferGeometry} body the workpiece's shape */
  lay({ pose }, frames, body) {
    const { mesh } = this;
    mesh.geometry = body;
    mesh.count = frames.length;
    mesh.visible = frames.length > 0;
    const one = new Vector3(1, 1, 1);
    // Counted from the first pose, as a tube's points are.
    const first = originOf(pose, 0);
    mesh.position.copy(first);
    frames.forEach((frame, index) => mesh.setMatrixAt(index, new Matrix4().compose(originOf(pose, frame).sub(first), turnOf(pose, frame), one)));
    mesh.userData.places = frames.map((frame) => `ghost[${frame}]`);
    mesh.instanceMatrix.needsUpdate = true;
    mesh.boundingSphere = null;
  }
}

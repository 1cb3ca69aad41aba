/**
 * Lines between goal and reached pose at regular frames: dotted, dashed or solid, thin or thick, and coloured, by size.
 */
import { CylinderGeometry, DynamicDrawUsage, Group, InstancedMesh, Matrix4, Quaternion, Vector3 } from 'three';
import { originOf } from '../../core/poses.js';
import { roundSize } from './ground.js';
import { shared } from './solids.js';

/** At most so many lines over a motion. */
const LINES = 24;

/** At most so many dashes in one line. */
const DASHES = 40;

/**
 * Classes of size: from which share of the scene's radius on (made round), and the pattern: dash, gap and radius in
 * link radii; a dash of 0 is unbroken.
 */
const CLASSES = [
  { from: 0, dash: 0.35, gap: 0.75, radius: 0.13 },
  { from: 0.03, dash: 1.2, gap: 0.7, radius: 0.15 },
  { from: 0.12, dash: 0, gap: 0, radius: 0.17 },
];

/** A gap shorter than this, in link radii, is hidden in the motions' own width. */
const LEAST = 0.3;

const Y = new Vector3(0, 1, 0);

/** The sizes at which the classes begin, in lengths: 0 and two round numbers. @param {number} radius of the scene */
export const gapSteps = (radius) => CLASSES.map(({ from }) => (from ? roundSize(from * radius) : 0));

/** The class of a gap, from 0. @param {number} gap @param {number[]} steps */
export const gapClass = (gap, steps) => (gap >= steps[2] ? 2 : gap >= steps[1] ? 1 : 0);

/**
 * Frames at which lines are drawn.
 * @param {Pick<import('../../core/types.js').Motion, 'frames' | 'translation_gap'>} motion @param {number} r radius of a link
 */
export function gapFrames({ frames, translation_gap }, r) {
  const step = Math.max(1, Math.ceil(frames / LINES));
  return Array.from({ length: Math.ceil(frames / step) }, (_, i) => i * step).filter((frame) => translation_gap[frame] > LEAST * r);
}

export class GapLines {
  group = new Group();
  #meshes;

  /** @param {import('three').Material[]} materials one a class */
  constructor(materials) {
    const line = shared('dash', () => new CylinderGeometry(1, 1, 1, 8));
    this.#meshes = materials.map((material) => {
      const mesh = new InstancedMesh(line, material, LINES * DASHES);
      mesh.instanceMatrix.setUsage(DynamicDrawUsage);
      mesh.frustumCulled = false;
      mesh.count = 0;
      /** @type {string[]} */
      mesh.userData.places = [];
      return mesh;
    });
    this.group.add(...this.#meshes);
  }

  /**
   * @param {import('../../core/types.js').Motion} motion
   * @param {number} r radius of a link
   * @param {number} radius of the scene
   */
  lay(motion, r, radius) {
    const steps = gapSteps(radius);
    for (const mesh of this.#meshes) mesh.count = 0;
    // Counted from the goal's first pose, as a tube's points are.
    const first = originOf(motion.goal, 0);
    const frames = gapFrames(motion, r);
    // Where there is no goal there is no line.
    if (frames.length) this.group.position.copy(first);
    for (const frame of frames) {
      const from = originOf(motion.goal, frame).sub(first);
      const to = originOf(motion.pose, frame).sub(first);
      const length = from.distanceTo(to);
      this.#line(gapClass(length, steps), from, to, length, r, `gap[${frame}]`);
    }
    for (const mesh of this.#meshes) {
      mesh.instanceMatrix.needsUpdate = true;
      // Found by a ray only within its bounds, which are those of the last motion.
      mesh.boundingSphere = null;
    }
  }

  /** @param {number} size class @param {Vector3} from @param {Vector3} to @param {number} length @param {number} r @param {string} place */
  #line(size, from, to, length, r, place) {
    const mesh = this.#meshes[size];
    const { dash, gap, radius } = CLASSES[size];
    const pieces = dash ? Math.min(DASHES, Math.max(1, Math.round(length / ((dash + gap) * r)))) : 1;
    const share = dash ? dash / (dash + gap) : 1;
    const turn = new Quaternion().setFromUnitVectors(Y, to.clone().sub(from).divideScalar(length));
    const scale = new Vector3(radius * r, (share * length) / pieces, radius * r);
    const matrix = new Matrix4();
    const middle = new Vector3();
    for (let i = 0; i < pieces; i++) {
      matrix.compose(middle.lerpVectors(from, to, (i + 0.5) / pieces), turn, scale);
      mesh.setMatrixAt(mesh.count, matrix);
      mesh.userData.places[mesh.count++] = place;
    }
  }
}

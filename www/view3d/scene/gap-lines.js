/**
 * Lines between goal and reached pose at regular frames: dotted, dashed or solid, thin or thick, and coloured, by size.
 */
import { Group } from 'three';
import { originOf } from '../../core/poses.js';
import { roundSize } from './ground.js';
import { Stroke } from './stroke.js';

/** At most so many lines over a motion. */
const LINES = 24;

/** Classes of size: from which share of the scene's radius on (made round). */
const CLASSES = [0, 0.03, 0.12];

/** A gap shorter than this, in link radii, is hidden in the motions' own width. */
const LEAST = 0.3;

/** The sizes at which the classes begin, in lengths: 0 and two round numbers. @param {number} radius of the scene */
export const gapSteps = (radius) => CLASSES.map((from) => (from ? roundSize(from * radius) : 0));

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
  #strokes;

  /** @param {import('./stroke.js').StrokeMaterial[]} materials one a class */
  constructor(materials) {
    this.#strokes = materials.map((material) => new Stroke(material));
    this.group.add(...this.#strokes);
  }

  /**
   * @param {import('../../core/types.js').Motion} motion
   * @param {number} r radius of a link
   * @param {number} radius of the scene
   */
  lay(motion, r, radius) {
    const steps = gapSteps(radius);
    // Counted from the goal's first pose, as the points of the motions are.
    const first = originOf(motion.goal, 0);
    const frames = gapFrames(motion, r);
    // Where there is no goal there is no line.
    if (frames.length) this.group.position.copy(first);
    this.#strokes.forEach((stroke, size) => {
      const own = frames.filter((frame) => gapClass(motion.translation_gap[frame], steps) === size);
      const points = new Float64Array(6 * own.length);
      own.forEach((frame, at) => {
        for (const [end, column] of [motion.goal, motion.pose].entries()) originOf(column, frame).sub(first).toArray(points, 6 * at + 3 * end);
      });
      stroke.lay(points, 2 * own.length, 2);
      stroke.userData.places = own.map((frame) => `gap[${frame}]`);
    });
  }
}

/**
 * How large the scene is and where: measured from the motion, and kept while it still fits, so that typing and dragging
 * do not make the bodies and the ground jump.
 */
import { Vector3 } from 'three';
import { POSE } from '../../core/poses.js';

/** How much the scene may grow or shrink before its bodies are drawn in new proportions. */
const KEEP_SIZE = 1.5;

/** A link's radius as a share of the scene's. */
const LINK_RADIUS = 0.024;

/** From the lowest place of a link or a base to the ground, in link radii. */
const CLEAR = 3.5;

export function createMeasure() {
  const size = { radius: 0, centre: new Vector3(), link: 0, ground: 0 };
  return {
    size,
    /**
     * @param {import('../../core/types.js').Motion} motion
     * @param {import('../../core/types.js').MechanismDocument} doc
     * @param {boolean} afresh
     * @returns {boolean} whether the proportions are new
     */
    take(motion, doc, afresh) {
      const low = new Vector3(Infinity, Infinity, Infinity);
      const high = low.clone().negate();
      for (const column of [motion.rows, motion.pose, motion.goal]) {
        for (let at = 0; at < column.length; at += POSE) {
          const [x, y, z] = [column[at], column[at + 1], column[at + 2]];
          if (x < low.x) low.x = x;
          if (x > high.x) high.x = x;
          if (y < low.y) low.y = y;
          if (y > high.y) high.y = y;
          if (z < low.z) low.z = z;
          if (z > high.z) high.z = z;
        }
      }
      const lowest = Math.min(low.z, ...doc.chains.map((chain) => Number(chain.base?.z) || 0));
      const radius = Math.max(high.distanceTo(low) / 2, 1e-6);
      const ratio = radius / size.radius;
      const anew = afresh || !(ratio < KEEP_SIZE && ratio > 1 / KEEP_SIZE);
      if (anew) {
        size.radius = radius;
        size.centre.addVectors(low, high).multiplyScalar(0.5);
        size.link = LINK_RADIUS * radius;
      }
      const ground = lowest - CLEAR * size.link;
      // The ground gives way at once, and comes back only with new proportions.
      if (anew || ground < size.ground) size.ground = ground;
      return anew;
    },
  };
}

/**
 * The standard views: from where the scene is seen, as angles about z (from the front towards the right) and down from
 * straight above. x points to the right in the front view, z up; from above, y points up.
 */

const QUARTER = Math.PI / 2;

export const STANDARD_VIEWS = {
  front: { around: 0, down: QUARTER },
  back: { around: 2 * QUARTER, down: QUARTER },
  left: { around: -QUARTER, down: QUARTER },
  right: { around: QUARTER, down: QUARTER },
  top: { around: 0, down: 0 },
  bottom: { around: 0, down: 2 * QUARTER },
  /** All three axes foreshortened alike. */
  isometric: { around: QUARTER / 2, down: Math.acos(1 / Math.sqrt(3)) },
  /** In front, to the right, from above: how a linkage is first seen. */
  first: { around: Math.atan2(0.78, 1), down: Math.atan2(Math.hypot(0.78, 1), 0.62) },
};

/** @typedef {keyof typeof STANDARD_VIEWS} StandardView */

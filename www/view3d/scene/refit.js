/**
 * When the view is fitted to the scene by itself: where an edit, such as another unit of length, put a scene of another size
 * or at another place before the camera; not for a small edit, and not while a pointer is down.
 *
 * @typedef {{centre: import('three').Vector3, radius: number}} Ball
 */

/** How much larger, smaller or farther away a scene must be than the one that the view was fitted to. */
const FACTOR = 2;

/** The least share of the view that a scene has while it is still looked at, and the most: the ball around it is loose. */
const LEAST = 1 / 4;
const MOST = 1.2;

/** Whether a scene is another one by a factor. @param {Ball} fitted @param {Ball} now */
export function hasLeft(fitted, now) {
  const ratio = now.radius / fitted.radius;
  return !(ratio < FACTOR && ratio > 1 / FACTOR) || fitted.centre.distanceTo(now.centre) > fitted.radius;
}

/** Whether a scene is in a view, and at a good size. @param {{target: import('three').Vector3, reach: number}} view `reach` is half of its lesser side @param {Ball} now */
export function showsWell({ target, reach }, { centre, radius }) {
  const share = radius / reach;
  return share > LEAST && share < MOST && target.distanceTo(centre) < reach;
}

/**
 * Calls `settle` when the last pointer is let go of.
 * @param {() => void} settle
 * @param {AbortSignal} [signal]
 * @returns {() => boolean} whether a pointer is down, wherever in the page
 */
export function watchPointers(settle, signal) {
  /** @type {Set<number>} */
  const down = new Set();
  const listen = (/** @type {string} */ type, /** @type {(event: PointerEvent) => void} */ act) =>
    // Before any part of the page, which may keep the event to itself.
    addEventListener(type, /** @type {EventListener} */ (act), { capture: true, signal });
  const release = (/** @type {PointerEvent} */ { pointerId }) => {
    if (down.delete(pointerId) && !down.size) settle();
  };
  listen('pointerdown', ({ pointerId }) => down.add(pointerId));
  listen('pointerup', release);
  listen('pointercancel', release);
  return () => down.size > 0;
}

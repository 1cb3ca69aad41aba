/**
 * A double click or a double tap on a thing looks at it, and beside all things at all of them.
 */

/** Two presses are in one place: within so many pixels and, by touch, milliseconds. */
const TWICE = { time: 400, far: 24 };

/** @param {NonNullable<import('../../element/workbench.js').App['scene']>} scene */
export function createLookAt(scene) {
  const { canvas } = scene;
  /** The first press of two, unless it is meant for something else. @type {PointerEvent | null} */
  let first = null;
  let isSecondTap = false;
  const isNearFirst = (/** @type {MouseEvent} */ event) => first !== null && Math.hypot(event.clientX - first.clientX, event.clientY - first.clientY) < TWICE.far;

  function look(/** @type {MouseEvent} */ event) {
    first = null;
    const place = scene.pick(/** @type {PointerEvent} */ (event));
    if (!place || !scene.fitTo(place)) scene.fit();
  }

  // Before what takes hold of something: the first press may have put a handle there.
  const listen = (/** @type {string} */ type, /** @type {(event: any) => void} */ act) => /** @type {HTMLElement} */ (canvas.parentElement).addEventListener(type, act, { capture: true });
  listen('pointerdown', (/** @type {PointerEvent} */ event) => {
    const near = isNearFirst(event);
    const touch = event.pointerType === 'touch';
    isSecondTap = touch && near && event.timeStamp - (first?.timeStamp ?? 0) < TWICE.time;
    if (isSecondTap || (near && !touch)) return;
    first = event.target === canvas && event.isPrimary && event.button === 0 && !scene.claims(event) ? event : null;
  });
  listen('pointercancel', () => {
    first = null;
  });
  listen('pointerup', (/** @type {PointerEvent} */ event) => {
    if (isSecondTap && isNearFirst(event)) look(event);
  });
  // How fast a mouse must be is set in the system.
  listen('dblclick', (/** @type {MouseEvent} */ event) => {
    if (first?.pointerType !== 'touch' && isNearFirst(event)) look(event);
  });
}

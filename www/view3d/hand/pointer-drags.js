/**
 * Pointers on the canvas that take hold of something. They come before the camera and the picking, which then see
 * nothing of the drag; one pointer at a time, by mouse, pen or finger.
 *
 * @typedef {{x: number, y: number}} Pointer from −1 to 1 across the canvas, y up
 * @typedef {{move: (at: Pointer, snap: boolean) => void, end: () => void, cancel: () => void}} Drag
 */
import { isHeld } from '../../ui/keys.js';

/** How far a pointer may tremble and still be a click, in pixels: a finger is less steady. */
const TREMBLE = { mouse: 3, touch: 10 };

/**
 * @param {HTMLCanvasElement} canvas
 * @param {object} hand
 * @param {(at: Pointer) => boolean} hand.hover whether something is there to take hold of
 * @param {(at: Pointer, event: PointerEvent) => Drag | null} hand.grab
 * @param {(event: PointerEvent) => void} hand.click it was taken and let go in place
 * @param {() => void} hand.stir called before every move
 * @param {() => void} hand.calm called after what was held has been let go
 */
export function createPointerDrags(canvas, { hover, grab, click, stir, calm }) {
  /** @type {{drag: Drag, id: number, from: [number, number], moved: boolean} | null} */
  let held = null;

  /** @param {PointerEvent} event @returns {Pointer} */
  function place(event) {
    const box = canvas.getBoundingClientRect();
    return { x: ((event.clientX - box.left) / box.width) * 2 - 1, y: 1 - ((event.clientY - box.top) / box.height) * 2 };
  }

  /** @param {Event} event */
  const keep = (event) => {
    event.stopImmediatePropagation();
    event.preventDefault();
  };

  function letGo() {
    if (held && canvas.hasPointerCapture(held.id)) canvas.releasePointerCapture(held.id);
    held = null;
    canvas.classList.remove('dragging');
  }

  /** @param {string} type @param {(event: any) => void} act */
  const first = (type, act) => canvas.addEventListener(type, act, { capture: true });

  first('pointerdown', (/** @type {PointerEvent} */ event) => {
    if (held) return keep(event);
    // A second finger belongs to what the first one does.
    if (event.button !== 0 || !event.isPrimary) return;
    const at = place(event);
    const drag = grab(at, event);
    if (!drag) return;
    keep(event);
    held = { drag, id: event.pointerId, from: [event.clientX, event.clientY], moved: false };
    canvas.setPointerCapture(event.pointerId);
    canvas.focus({ preventScroll: true });
    canvas.classList.add('dragging');
  });
  first('pointermove', (/** @type {PointerEvent} */ event) => {
    if (!held) {
      if (event.pointerType !== 'touch' && event.buttons === 0) canvas.classList.toggle('grabbable', hover(place(event)));
      return;
    }
    keep(event);
    if (event.pointerId !== held.id) return;
    const far = Math.hypot(event.clientX - held.from[0], event.clientY - held.from[1]);
    held.moved ||= far > (event.pointerType === 'touch' ? TREMBLE.touch : TREMBLE.mouse);
    if (!held.moved) return;
    stir();
    held.drag.move(place(event), isHeld(event, 'round'));
  });
  first('pointerup', (/** @type {PointerEvent} */ event) => {
    if (!held) return;
    keep(event);
    if (event.pointerId !== held.id) return;
    const { drag, moved } = held;
    letGo();
    if (moved) {
      drag.end();
      return calm();
    }
    drag.cancel();
    click(event);
  });
  // Capture ends without either of the others where another takes it.
  for (const end of ['pointercancel', 'lostpointercapture']) {
    first(end, (/** @type {PointerEvent} */ event) => {
      if (event.pointerId === held?.id) cancel();
    });
  }

  /** Lets go as if nothing had been moved. @returns {boolean} whether something was held */
  function cancel() {
    if (!held) return false;
    const { drag } = held;
    letGo();
    drag.cancel();
    calm();
    return true;
  }

  return {
    cancel,
    place,
    get busy() {
      return held !== null;
    },
  };
}

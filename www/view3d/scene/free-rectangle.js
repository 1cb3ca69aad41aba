/**
 * The part of the view that nothing lies over: where a linkage is fitted into.
 *
 * @typedef {import('./label-layout.js').Box} Box
 */

/** What may lie over a view, in the element and in a playing page. */
const OVER = '.view-bar, .cube, .legend, .by-hand, .banner, .fold, #fit, #view-only';

/** Of those, what a fitted view makes way for at once; a message that comes and goes does not make it jump. */
const STAYING = '.view-bar, .cube, .legend, .fold, #view-only';

/** A view's canvas is in a frame, whose buttons may lie over it too; in a playing page it is in its parent. @param {HTMLElement} canvas @param {string} what */
const around = (canvas, what) => [...((canvas.closest('.frame') ?? canvas.parentElement)?.querySelectorAll(what) ?? [])];

/** @param {HTMLElement} canvas */
export const stayingOver = (canvas) => around(canvas, STAYING);

/** Kept free around them, in pixels. */
const CLEAR = 6;

/** Width to height of what is shown, roughly. */
const SHAPE = 4 / 3;

/** What a part is worth for having room to spare, against its size. */
const SPARE = 0.1;

/** The largest part of a room, for something of a usual shape, that no box lies over; of two that are nearly as large, the roomier one. @param {Box} room @param {Box[]} boxes @returns {Box} */
export function freeRectangle({ x, y, width, height }, boxes) {
  const [right, bottom] = [x + width, y + height];
  const at = boxes.findIndex((box) => box.x < right && box.x + box.width > x && box.y < bottom && box.y + box.height > y);
  if (at < 0) return { x, y, width, height };
  const box = boxes[at];
  const cut = [
    { x, y, width: box.x - x, height },
    { x, y, width, height: box.y - y },
    { x: box.x + box.width, y, width: right - box.x - box.width, height },
    { x, y: box.y + box.height, width, height: bottom - box.y - box.height },
  ];
  const size = (/** @type {Box} */ part) => Math.min(part.width, part.height * SHAPE) + SPARE * Math.max(part.width, part.height * SHAPE);
  return cut.map((part) => freeRectangle(part, boxes.slice(at + 1))).reduce((best, part) => (size(part) > size(best) ? part : best));
}

/** All of a view, in shares of it. */
export const WHOLE = { x: 0, y: 0, width: 1, height: 1 };

/** In shares of a view's canvas, the free part and what lies over it. @param {HTMLElement} canvas @returns {{free: Box, over: Box[]}} */
export function freeShare(canvas) {
  const room = canvas.getBoundingClientRect();
  const boxes = around(canvas, OVER)
    .map((one) => one.getBoundingClientRect())
    .filter(({ width }) => width)
    .map((box) => ({ x: box.x - CLEAR, y: box.y - CLEAR, width: box.width + 2 * CLEAR, height: box.height + 2 * CLEAR }));
  const free = freeRectangle(room, boxes);
  // A view without a size, or hidden under what lies over it, is as good as free.
  if (!(free.width > 1 && free.height > 1)) return { free: WHOLE, over: [] };
  const share = (/** @type {Box} */ { x, y, width, height }) => ({ x: (x - room.x) / room.width, y: (y - room.y) / room.height, width: width / room.width, height: height / room.height });
  return { free: share(free), over: boxes.map(share) };
}

/**
 * Turning, shifting and zooming the view by a mouse, a wheel and fingers: what they do on the canvas, in shares of its height.
 *
 * @typedef {object} Orbit
 * @property {boolean} zooms whether the wheel and fingers zoom
 * @property {boolean} leavesOneFinger to the page around it: two fingers turn then, in place of shifting
 *
 * @typedef {object} Moves
 * @property {() => void} start a hand begins
 * @property {(right: number, down: number) => void} turn by so many heights of the canvas
 * @property {(right: number, down: number) => void} shift
 * @property {(times: number) => void} zoom how many times as much is seen
 *
 * @typedef {'turn' | 'shift' | 'zoom' | 'pinch' | null} Doing
 */

/** How much is seen after a step of the wheel of 100 pixels, or after 100 pixels of the pointer. */
const STEP = 1 / 0.95;
/** Pixels of a line and of a page, by which some wheels count. */
const PIXELS = [1, 16, 100];
/** A pinch on a touchpad is a wheel with Ctrl, which the browser sends in small steps. */
const PINCH = 10;

/** @param {HTMLCanvasElement} canvas @param {Moves} moves @returns {Orbit & {dispose: () => void}} */
export function createOrbit(canvas, { start, turn, shift, zoom }) {
  const orbit = { zooms: true, leavesOneFinger: false, dispose: () => over.abort() };
  const over = new AbortController();
  const { signal } = over;
  const { ownerDocument } = canvas;
  /** Those that are down, by their numbers. @type {Map<number, {x: number, y: number}>} */
  const down = new Map();
  /** @type {Doing} */
  let doing = null;
  /** Where they were, in the middle, and how far they were apart. */
  let before = { x: 0, y: 0, apart: 0 };
  let ctrlIsDown = false;
  /** Ends listening to moves. */
  let moving = new AbortController();

  function middle() {
    const [one, other = one] = down.values();
    return { x: (one.x + other.x) / 2, y: (one.y + other.y) / 2, apart: Math.hypot(one.x - other.x, one.y - other.y) };
  }

  /** @param {Doing} next */
  function begin(next) {
    before = middle();
    doing = next;
    if (doing) start();
  }

  const withFingers = () => begin(down.size === 2 ? 'pinch' : down.size === 1 && !orbit.leavesOneFinger ? 'turn' : null);

  /** @param {PointerEvent} event @returns {Doing} */
  function withMouse({ button, ctrlKey, metaKey, shiftKey }) {
    const other = ctrlKey || metaKey || shiftKey;
    if (button === 1) return orbit.zooms ? 'zoom' : null;
    if (button === 0) return other ? 'shift' : 'turn';
    return button === 2 ? (other ? 'turn' : 'shift') : null;
  }

  /** @param {PointerEvent} event */
  function move({ pointerId, clientX: x, clientY: y }) {
    if (!down.has(pointerId)) return;
    down.set(pointerId, { x, y });
    const now = middle();
    const height = canvas.clientHeight;
    const [right, lower] = [(now.x - before.x) / height, (now.y - before.y) / height];
    if (doing === 'pinch') {
      if (orbit.zooms && before.apart * now.apart > 0) zoom(before.apart / now.apart);
      (orbit.leavesOneFinger ? turn : shift)(right, lower);
    } else if (doing === 'turn') turn(right, lower);
    else if (doing === 'shift') shift(right, lower);
    else if (doing === 'zoom') zoom(STEP ** ((now.y - before.y) / 100));
    before = now;
  }

  /** @param {PointerEvent} event */
  function up({ pointerId }) {
    if (!down.delete(pointerId)) return;
    if (down.size === 1) withFingers();
    if (down.size > 0) return;
    moving.abort();
    doing = null;
  }

  canvas.addEventListener('pointerdown', (event) => {
    const { pointerId, clientX: x, clientY: y, pointerType } = event;
    if (down.has(pointerId)) return;
    if (down.size === 0) {
      canvas.setPointerCapture(pointerId);
      moving = new AbortController();
      for (const [type, act] of /** @type {const} */ ([['pointermove', move], ['pointerup', up]])) ownerDocument.addEventListener(type, act, { signal: moving.signal });
    }
    down.set(pointerId, { x, y });
    if (pointerType === 'touch') withFingers();
    else begin(withMouse(event));
  }, { signal });
  // Capture ends without either of them where another takes it.
  for (const end of /** @type {const} */ (['pointercancel', 'lostpointercapture'])) canvas.addEventListener(end, up, { signal });
  canvas.addEventListener('contextmenu', (event) => event.preventDefault(), { signal });
  canvas.addEventListener('wheel', (event) => {
    if (!orbit.zooms || doing) return;
    event.preventDefault();
    start();
    zoom(STEP ** ((event.deltaY * PIXELS[event.deltaMode] * (event.ctrlKey && !ctrlIsDown ? PINCH : 1)) / 100));
  }, { passive: false, signal });
  for (const type of /** @type {const} */ (['keydown', 'keyup'])) {
    ownerDocument.addEventListener(type, ({ key }) => {
      if (key === 'Control') ctrlIsDown = type === 'keydown';
    }, { passive: true, capture: true, signal });
  }
  signal.addEventListener('abort', () => moving.abort());
  canvas.style.touchAction = 'none';
  return orbit;
}

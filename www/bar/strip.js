/**
 * The strip of the animation bar: the gap of every frame as a curve, where there is a goal, and its status as a band; of a motion that was stopped
 * the frames that are not planned are left open.
 *
 * @typedef {import('../core/types.js').Motion} Motion
 * @typedef {{tag: 'path' | 'rect'} & Record<string, string | number>} Shape with its attributes
 */
import { drivesJoints } from '../core/driven.js';

const SVG = 'http://www.w3.org/2000/svg';
const HEIGHT = 24;
const BAND = 4;
const LINE = 1.4;

/** More pieces along the strip than a screen has columns. */
const PIECES = 4_000;

/** Ends that need a look stand higher, so that they are told apart without colour. @type {Record<string, number>} */
const HIGHER = { at_limit: 7, stalled: 11, closure_lost: HEIGHT };

/** @param {SVGSVGElement} svg @param {Motion} motion @param {number} [highest] the gap that is drawn full */
export function drawStrip(svg, motion, highest = highestGap(motion)) {
  const last = Math.max(1, motion.goal_frames - 1);
  put(svg, 'viewBox', `0 0 ${last} ${HEIGHT}`);
  /** @type {Shape[]} */
  const shapes = [];
  if (!drivesJoints(motion)) shapes.push(gapsOf(motion, highest));
  if (motion.partial) shapes.push({ tag: 'path', d: `M${motion.frames - 0.5} ${HEIGHT - BAND / 2}H${last}`, class: 'unplanned' });

  const piece = pieceOf(motion);
  // One rectangle a run of equal status, half a frame to either side of its frames; of a long motion the worst of each piece.
  const statuses = /** @type {readonly string[]} */ (motion.report.statuses);
  // The last one, passing, is no worse than a closest pose.
  const rank = (/** @type {number} */ code) => (statuses[code] === 'passing' ? 1.5 : code);
  const worst = (/** @type {number} */ first) => motion.status.subarray(first, first + piece).reduce((most, code) => (rank(code) > rank(most) ? code : most), 0);
  for (let first = 0; first < motion.frames; ) {
    const code = worst(first);
    const name = statuses[code];
    let end = Math.min(motion.frames, first + piece) - 1;
    while (end + 1 < motion.frames && worst(end + 1) === code) end = Math.min(motion.frames, end + 1 + piece) - 1;
    const from = Math.max(0, first - 0.5);
    const to = Math.min(last, end + 0.5);
    const height = HIGHER[name] ?? BAND;
    const band = { tag: /** @type {const} */ ('rect'), x: from, width: to - from, class: `band ${name}` };
    if (name === 'passing') {
      // Dots: on the way.
      shapes.push({ tag: 'path', d: `M${from} ${HEIGHT - BAND / 2}H${to}`, class: 'passing' });
    } else if (name === 'closest') {
      // A double line: not reached.
      shapes.push({ ...band, y: HEIGHT - height, height: LINE }, { ...band, y: HEIGHT - LINE, height: LINE });
    } else shapes.push({ ...band, y: HEIGHT - height, height });
    first = end + 1;
  }
  lay(svg, shapes);
}

/** @param {Motion} motion @param {number} highest @returns {Shape} */
function gapsOf(motion, highest) {
  const gaps = stripGaps(motion);
  const top = HEIGHT - BAND - 2;
  let path = `M0 ${top}`;
  // Of a long motion the largest gap of each piece.
  const piece = pieceOf(motion);
  for (let first = 0; first < motion.frames; first += piece) {
    let at = first;
    for (let frame = first; frame < Math.min(motion.frames, first + piece); frame++) if (gaps[frame] > gaps[at]) at = frame;
    const share = highest > 0 ? gaps[at] / highest : 0;
    path += `L${at} ${(top - share * (top - 1)).toFixed(2)}`;
  }
  return { tag: 'path', d: `${path}L${motion.frames - 1} ${top}Z`, class: 'gap' };
}

/** Frames that are drawn as one. @param {Motion} motion */
const pieceOf = ({ frames }) => Math.ceil(frames / PIECES);

/**
 * The gap of every frame: the square root of ½|q − g|², which is quadratic in the gap, so that a small one is still seen; none
 * where the goal counts as reached, since what is left there is rounding.
 * @param {Pick<Motion, 'metric' | 'status' | 'report'>} motion
 */
export const stripGaps = (motion) =>
  motion.metric.map((value, frame) => (motion.report.statuses[motion.status[frame]] === 'reached' ? 0 : Math.sqrt(value)));

/** @param {Parameters<typeof stripGaps>[0]} motion */
export const highestGap = (motion) => stripGaps(motion).reduce((most, gap) => Math.max(most, gap), 0);

/**
 * Lays shapes into the strip. Those that stand there stay, and only what is different is written: most motions differ from the
 * one before by their curve.
 * @param {SVGSVGElement} svg @param {Shape[]} shapes
 */
function lay(svg, shapes) {
  while (svg.children.length > shapes.length) svg.lastElementChild?.remove();
  shapes.forEach(({ tag, ...attributes }, at) => {
    let shape = svg.children[at];
    if (shape?.localName !== tag) {
      const made = document.createElementNS(SVG, tag);
      if (shape) shape.replaceWith(made);
      else svg.append(made);
      shape = made;
    }
    for (const [name, value] of Object.entries(attributes)) put(shape, name, String(value));
  });
}

/** @param {Element} shape @param {string} name @param {string} value */
function put(shape, name, value) {
  if (shape.getAttribute(name) !== value) shape.setAttribute(name, value);
}

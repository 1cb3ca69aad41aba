/**
 * The strip of the animation bar: the gap of every frame as a curve, where there is a goal, and its status as a band; of a motion that was stopped
 * the frames that are not planned are left open.
 *
 * @typedef {import('../core/types.js').Motion} Motion
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

/** @param {SVGSVGElement} svg @param {Motion} motion */
export function drawStrip(svg, motion) {
  const last = Math.max(1, motion.goal_frames - 1);
  svg.setAttribute('viewBox', `0 0 ${last} ${HEIGHT}`);
  svg.replaceChildren();

  if (!drivesJoints(motion)) drawGaps(svg, motion);
  if (motion.partial) add(svg, 'path', { d: `M${motion.frames - 0.5} ${HEIGHT - BAND / 2}H${last}`, class: 'unplanned' });

  const piece = pieceOf(motion);
  // One rectangle a run of equal status, half a frame to either side of its frames; of a long motion the worst of each piece.
  const worst = (/** @type {number} */ first) => motion.status.subarray(first, first + piece).reduce((most, code) => Math.max(most, code), 0);
  for (let first = 0; first < motion.frames; ) {
    const code = worst(first);
    const name = motion.report.statuses[code];
    let end = Math.min(motion.frames, first + piece) - 1;
    while (end + 1 < motion.frames && worst(end + 1) === code) end = Math.min(motion.frames, end + 1 + piece) - 1;
    const from = Math.max(0, first - 0.5);
    const to = Math.min(last, end + 0.5);
    const height = HIGHER[name] ?? BAND;
    const band = { x: from, width: to - from, class: `band ${name}` };
    if (name === 'closest') {
      // A double line: not reached.
      add(svg, 'rect', { ...band, y: HEIGHT - height, height: LINE });
      add(svg, 'rect', { ...band, y: HEIGHT - LINE, height: LINE });
    } else add(svg, 'rect', { ...band, y: HEIGHT - height, height });
    first = end + 1;
  }
}

/** @param {SVGSVGElement} svg @param {Motion} motion */
function drawGaps(svg, motion) {
  const gaps = stripGaps(motion);
  const highest = gaps.reduce((most, gap) => Math.max(most, gap), 0);
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
  add(svg, 'path', { d: `${path}L${motion.frames - 1} ${top}Z`, class: 'gap' });
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

/** @param {SVGSVGElement} svg @param {string} tag @param {Record<string, string | number>} attributes */
function add(svg, tag, attributes) {
  const made = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, String(value));
  svg.append(made);
}

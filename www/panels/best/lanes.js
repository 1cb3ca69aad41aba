/**
 * The branches of a linkage as lanes over the frames: which are drawn, in which order, where the best motion goes among them.
 * Knows no DOM.
 *
 * @typedef {import('../../core/types.js').Best} Best
 *
 * A branch with its frames, all counted from 0; `used` where the best motion is on it; `mean` of its distance.
 * @typedef {{branch: number, first: number, last: number, mean: number, used: boolean, metric: Float64Array}} Lane
 * A run of the best motion on one branch.
 * @typedef {{branch: number, from: number, to: number}} Run
 */
import { isNothing } from './best-words.js';

/** At most so many lanes: more are no picture any more. The followed one and those of the best motion are among them in any case. */
const MOST = 8;

/** The runs of the best motion, in order; frames without a branch are in none. @param {ArrayLike<number>} lane @returns {Run[]} */
export function runsOf(lane) {
  /** @type {Run[]} */
  const runs = [];
  for (let frame = 0; frame < lane.length; frame++) {
    const branch = lane[frame];
    const last = runs.at(-1);
    if (branch < 0) continue;
    if (last?.branch === branch && last.to === frame - 1) last.to = frame;
    else runs.push({ branch, from: frame, to: frame });
  }
  return runs;
}

/**
 * The followed branch, then those of the best motion as it comes to them, then the others, the closest first.
 * @param {Pick<Best, 'branches' | 'lane'>} best
 * @returns {{lanes: Lane[], more: number, top: number}} how many are left out, and the largest distance of those drawn
 */
export function lanesOf({ branches, lane }) {
  const used = [...new Set([0, ...runsOf(lane).map(({ branch }) => branch)])];
  const all = branches.map(({ first, metric }, branch) => ({
    branch, first, metric, last: first + metric.length - 1, used: lane.length > 0 && used.includes(branch) && runsOf(lane).some((run) => run.branch === branch),
    mean: metric.reduce((sum, value) => sum + value, 0) / Math.max(1, metric.length),
  }));
  const others = all.filter(({ branch }) => !used.includes(branch)).sort((a, b) => a.mean - b.mean);
  const room = Math.max(0, MOST - used.length);
  const lanes = [...used.flatMap((branch) => all[branch] ?? []), ...others.slice(0, room)].filter(({ metric }) => metric.length > 0);
  const highest = lanes.reduce((most, { metric }) => metric.reduce((high, value) => (Number.isFinite(value) && value > high ? value : high), most), 0);
  return { lanes, more: Math.max(0, others.length - room), top: isNothing(highest) ? 0 : highest };
}

/**
 * The outline of a lane's distances, as heights from 0 to 1: the square root, as in the strip of the animation bar, so that a
 * small one is still seen. Of many frames the largest of each piece.
 * @param {Lane} lane @param {number} top the distance that is drawn full @param {number} pieces at most
 * @returns {{frame: number, height: number}[]}
 */
export function outlineOf({ first, metric }, top, pieces) {
  const step = Math.max(1, Math.ceil(metric.length / pieces));
  /** @type {{frame: number, height: number}[]} */
  const points = [];
  for (let from = 0; from < metric.length; from += step) {
    let most = from;
    for (let at = from; at < Math.min(metric.length, from + step); at++) if (!(metric[at] <= metric[most])) most = at;
    const share = metric[most] / top;
    // What runs away has no distance that could be drawn.
    points.push({ frame: first + most, height: top > 0 ? (Number.isFinite(share) ? Math.sqrt(Math.min(1, Math.max(0, share))) : 1) : 0 });
  }
  return points;
}

/** The width of a label in pixels: its edges, and a digit at most. */
const LABEL = { edges: 14, digit: 7 };

/**
 * What stands at switches from left to right: a label that would cover a neighbour, or the mark of one, is left out for a mark.
 * @param {{at: number, text: string}[]} switches in pixels @param {number} mark its width
 * @returns {{at: number, text: string}[]}
 */
export function labelsOf(switches, mark) {
  let free = -Infinity;
  return switches.map(({ at, text }, index) => {
    const half = Math.max(mark, LABEL.edges + LABEL.digit * text.length) / 2;
    const next = switches[index + 1]?.at ?? Infinity;
    const isLabelled = at - half >= free && at + half <= next - mark / 2;
    free = at + (isLabelled ? half : mark / 2);
    return { at, text: isLabelled ? text : '·' };
  });
}

/**
 * From closer to calmer: a slider over the points of a curve, the curve of mean distance against joint motion, and what the
 * chosen point costs. Leftmost is the best motion itself, whose joints move at its switches while the goal stands.
 *
 * @typedef {import('../../core/types.js').Best} Best
 * @typedef {import('../../core/types.js').MotionCost} MotionCost
 * @typedef {import('../../core/types.js').Motion} Motion
 */
import { html, live, nothing, svg } from '../../ui/render.js';
import { calmWords, distance, jointStep, jointUnit } from './best-words.js';

/** Of the picture, in pixels, with the room for its scales. */
const WIDTH = 260;
const HEIGHT = 112;
const ROOM = { left: 70, right: 12, top: 8, bottom: 28 };

/** What is printed of a point. @param {MotionCost} point @param {Motion | null} motion */
const printed = ({ mean, largest, largest_step }, motion) => [distance(mean), distance(largest), jointStep(largest_step, motion)].join();

/**
 * The points of the slider: the best motion itself, then those of the curve whose printed numbers differ from the one before.
 * @param {Pick<Best, 'best' | 'curve'>} best @param {Motion | null} motion
 * @returns {{point: MotionCost, choice: number}[]} each with its choice: 0, or its place in the curve from 1
 */
export function pointsOf({ best, curve }, motion) {
  const all = [best, ...curve];
  return all.flatMap((point, choice) => (choice > 0 && printed(point, motion) === printed(all[choice - 1], motion) ? [] : [{ point, choice }]));
}

/** Least steps of an end of the axis that the curve is high. */
const COARSE = 4;

/** An end of the axis of distances, which is a round number. @param {number} value */
const tick = (value) => (value >= 1e-4 && value < 1000 ? String(Number(value.toPrecision(6))) : distance(value));

/** Round numbers below and above two. @param {number} least @param {number} most @returns {[from: number, to: number]} */
function rounded(least, most) {
  if (!(most > least)) return [least, most];
  const step = 10 ** Math.floor(Math.log10((most - least) / COARSE));
  // Rounding must not add a step.
  return [Math.floor(least / step + 1e-9) * step, Math.ceil(most / step - 1e-9) * step];
}

/**
 * The axis of distances: from 0 where the curve then has half of the height or more, else from a round number below it, or
 * distances that are close together would be a flat line. The followed motion is on it unless the curve would be flat for it.
 * @param {number[]} means of the curve @param {number} followed
 * @returns {[from: number, to: number]}
 */
export function distanceAxis(means, followed) {
  let [least, most] = [Math.min(...means), Math.max(...means)];
  if (followed - most <= most - least && least - followed <= most - least) [least, most] = [Math.min(least, followed), Math.max(most, followed)];
  const span = most - least;
  const [from, to] = rounded(least, most);
  return span > 0 && least > span && tick(from) !== tick(to) ? [from, to] : [0, rounded(0, span > 0 ? most : Math.max(most, followed))[1] || 1];
}

/**
 * Where the points are in the picture: joint motion to the right, from 0, distance upwards. A followed motion that is not on the
 * axis of distances stands at its end, and `beyond` is true.
 * @param {Pick<MotionCost, 'mean' | 'largest_step'>[]} points @param {Pick<MotionCost, 'mean' | 'largest_step'>} followed
 */
export function placesOf(points, followed) {
  const wide = Math.max(...[...points, followed].map(({ largest_step }) => largest_step)) || 1;
  const [low, high] = distanceAxis(points.map(({ mean }) => mean), followed.mean);
  const place = (/** @type {Pick<MotionCost, 'mean' | 'largest_step'>} */ { mean, largest_step }) => ({
    x: ROOM.left + ((WIDTH - ROOM.left - ROOM.right) * largest_step) / wide,
    y: HEIGHT - ROOM.bottom - ((HEIGHT - ROOM.bottom - ROOM.top) * (Math.min(high, Math.max(low, mean)) - low)) / (high - low),
  });
  return { points: points.map(place), followed: place(followed), beyond: followed.mean < low || followed.mean > high, wide, low, high };
}

/** Share by which the largest joint step must fall for a motion to be calmer. */
const CALMER = 0.1;

/** Whether the curve leads to a calmer motion. @param {Best} best */
export const getsCalmer = ({ best, curve }) => curve.some(({ largest_step }) => largest_step < (1 - CALMER) * best.largest_step);

/** @param {MotionCost[]} points @param {MotionCost} followed @param {number} chosen @param {Motion | null} motion @param {(index: number) => void} choose */
function picture(points, followed, chosen, motion, choose) {
  const { points: at, followed: other, beyond, wide, low, high } = placesOf(points, followed);
  const [right, bottom] = [WIDTH - ROOM.right, HEIGHT - ROOM.bottom];
  const where = beyond ? `, ${followed.mean > high ? 'above' : 'below'} the picture at ${distance(followed.mean)}` : '';
  return html`<svg class="calm-curve" viewBox=${`0 0 ${WIDTH} ${HEIGHT}`} width=${WIDTH} height=${HEIGHT} role="img" aria-label=${`Mean distance against the largest joint step, from closer to calmer; the axis of distances goes from ${tick(low)} to ${tick(high)}; in numbers in the table`}>
    <path class="axis" d=${`M${ROOM.left} ${ROOM.top}V${bottom}H${right}`} />
    <path class="curve" d=${`M${at.map(({ x, y }) => `${x.toFixed(1)} ${y.toFixed(1)}`).join('L')}`} />
    ${at.map(({ x, y }, index) => svg`<circle class=${index === chosen ? 'chosen' : ''} cx=${x} cy=${y} r=${index === chosen ? 5.5 : 3} @click=${() => choose(index)} />`)}
    <path class="followed" d=${`M${other.x - 4} ${other.y - 4}l8 8m0 -8l-8 8`}><title>the followed motion${where}</title></path>
    <text x=${ROOM.left - 5} y=${ROOM.top + 8} text-anchor="end">${tick(high)}</text>
    <text x=${ROOM.left - 5} y=${bottom + 3} text-anchor="end">${tick(low)}</text>
    <text x=${ROOM.left} y=${bottom + 12}>0</text>
    <text x=${right} y=${bottom + 12} text-anchor="end">${jointStep(wide, motion)}</text>
    <text x=${(ROOM.left + right) / 2} y=${HEIGHT - 4} text-anchor="middle">largest joint step${jointUnit(motion) && `, ${jointUnit(motion)}`}</text>
    <text transform=${`translate(10 ${(ROOM.top + bottom) / 2}) rotate(-90)`} text-anchor="middle">mean distance</text>
  </svg>
  <p class="muted key">✕ the followed motion${where}${low > 0 ? `; the upward axis begins at ${tick(low)}` : ''}</p>`;
}

/**
 * @param {import('./search-state.js').State} state @param {(choice: number) => void} choose
 */
export function calmSlider({ best, motion, choice, waiting }, choose) {
  if (!best) return nothing;
  if (best.curve.length === 0) return best.progress < 1 ? html`<section class="calm"><h2>Closer – calmer</h2><p class="muted">When the search is complete.</p></section>` : nothing;
  if (!getsCalmer(best)) return html`<section class="calm"><h2>Closer – calmer</h2><p class="muted">There is no calmer motion to choose: giving up closeness makes the largest joint step smaller by less than 10 %.</p></section>`;
  const offered = pointsOf(best, motion);
  const points = offered.map(({ point }) => point);
  // One that is not offered stands where the one before it does.
  const at = offered.filter((one) => one.choice <= choice).length - 1;
  const words = calmWords(points[at], motion);
  const chooseAt = (/** @type {number} */ index) => choose(offered[index].choice);
  const slide = (/** @type {Event} */ { target }) => chooseAt(Number(/** @type {HTMLInputElement} */ (target).value));
  return html`<section class="calm" aria-label="Closer – calmer">
    <h2>Closer – calmer</h2>
    <label><span aria-hidden="true">closer</span><input type="range" min="0" max=${points.length - 1} step="1" .value=${live(String(at))} aria-label="From closer to calmer" aria-valuetext=${words} @input=${slide} /><span aria-hidden="true">calmer</span></label>
    <output aria-busy=${String(waiting)} class=${waiting ? 'waiting' : ''}>${choice === 0 ? `The best motion itself${best.switches.length ? ': it switches while the goal stands' : ''}; ` : ''}${words}.</output>
    ${picture(points, best.followed, at, motion, chooseAt)}
  </section>`;
}

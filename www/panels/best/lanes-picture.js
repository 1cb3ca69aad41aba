/**
 * The branches as lanes under the animation bar, frame above frame: the distance along each as a height, the followed one with a
 * dashed line, the best motion as a thick one that goes from lane to lane at its switches.
 *
 * @typedef {import('../../core/types.js').Best} Best
 * @typedef {import('./lanes.js').Lane} Lane
 */
import { plural } from '../../core/format.js';
import { element } from '../../ui/dom.js';
import { html, nothing, render, svg } from '../../ui/render.js';
import { branchName, distance, jointMotion, switchSentence } from './best-words.js';
import { labelsOf, lanesOf, outlineOf, runsOf } from './lanes.js';

/** In pixels: heights of a lane with its name and of the row of switches above, and the width of a switch without a label, where there is a mouse and on a phone; and the height of the distance drawn in a lane. */
const DESK = { lane: 24, above: 27, mark: 24 };
const PHONE = { lane: 32, above: 35, mark: 32 };
const HIGH = 15;

/** The width of the workbench up to which it is one of a phone, as in its style sheets. */
const NARROW = 759;

/** Least room for the names of lanes, in pixels: beside the animation bar's buttons there is more. */
const NAMES = 124;
/** What is left for their numbers. */
const NUMBERS = 92;

/**
 * @param {{find: import('../../ui/dom.js').Find, signal: AbortSignal, goTo: (frame: number) => void}} app
 */
export function createLanesPicture({ find, signal, goTo }) {
  const root = element('div', { class: 'lanes' });
  /** @type {{best: Best, motion: import('../../core/types.js').Motion, calmer: boolean} | null} */
  let shown = null;
  let [left, width] = [NAMES, 300];
  let { lane: laneHeight, above, mark } = DESK;
  let frame = 0;

  /** In line with the track of the animation bar, where it stands above. */
  function measure() {
    const own = root.getBoundingClientRect();
    if (!own.width) return;
    const track = find('lane').getBoundingClientRect();
    const isBelow = root.closest('.dock') && track.width > 200 && track.left - own.left >= NAMES && own.right - track.right >= 0;
    const next = isBelow ? [track.left - own.left, track.width] : [NAMES, own.width - NAMES - 8];
    const heights = find('bench').clientWidth <= NARROW ? PHONE : DESK;
    if (next[0] === left && next[1] === width && heights.lane === laneHeight) return;
    [left, width] = next;
    ({ lane: laneHeight, above, mark } = heights);
    draw();
  }
  const sizes = new ResizeObserver(measure);
  sizes.observe(root);
  sizes.observe(find('lane'));
  signal.addEventListener('abort', () => sizes.disconnect());

  const last = () => Math.max(1, (shown?.motion.goal_frames ?? 1) - 1);
  const xOf = (/** @type {number} */ at) => (width * at) / last();

  /** @param {PointerEvent} event */
  function point(event) {
    const box = /** @type {Element} */ (event.currentTarget).getBoundingClientRect();
    goTo(Math.round(Math.min(1, Math.max(0, (event.clientX - box.left) / box.width)) * last()));
  }
  /** @param {PointerEvent} event */
  function press(event) {
    if (event.button !== 0) return;
    /** @type {Element} */ (event.currentTarget).setPointerCapture(event.pointerId);
    point(event);
  }
  const drag = (/** @type {PointerEvent} */ event) => /** @type {Element} */ (event.currentTarget).hasPointerCapture(event.pointerId) && point(event);

  /** A lane's line and its distances. @param {Lane} lane @param {number} row @param {number} top */
  function laneShape(lane, row, top) {
    const base = above + laneHeight * (row + 1) - 3;
    const points = outlineOf(lane, top, 2 * width).map(({ frame: at, height }) => `${xOf(at).toFixed(1)} ${(base - HIGH * height).toFixed(1)}`);
    const [from, to] = [xOf(lane.first), xOf(lane.last)].map((x) => x.toFixed(1));
    return svg`<path class="distance" d=${`M${from} ${base}L${points.join('L')}L${to} ${base}Z`} />
      <path class=${lane.branch === 0 ? 'line followed' : 'line'} d=${`M${from} ${base}H${to}`} />`;
  }

  function draw() {
    if (!shown) return;
    const { best, motion, calmer } = shown;
    const { lanes, more, top } = lanesOf(best);
    const rowOf = new Map(lanes.map(({ branch }, row) => [branch, row]));
    const y = (/** @type {number} */ branch) => above + laneHeight * ((rowOf.get(branch) ?? 0) + 1) - 3;
    const runs = runsOf(best.lane);
    const height = above + laneHeight * lanes.length;
    const labels = labelsOf(best.switches.map((one) => ({ at: xOf(Math.max(0, one.frame - 0.5)), text: jointMotion(one.length, motion) })), mark);
    root.style.setProperty('--left', `${left}px`);
    root.style.setProperty('--width', `${width}px`);
    root.style.setProperty('--lane', `${laneHeight}px`);
    root.style.setProperty('--above', `${above}px`);
    const withNumbers = root.clientWidth - left - width > NUMBERS;
    render(
      html`<div class="lane-names">${lanes.map((lane) => {
          const words = `frames ${lane.first + 1} to ${lane.last + 1}, mean distance ${distance(lane.mean)}`;
          const start = runs.find(({ branch }) => branch === lane.branch)?.from ?? lane.first;
          return html`<button class="quiet" title=${words} @click=${() => goTo(start)}>${branchName(lane.branch)}${lane.used ? html` <b>best</b>` : nothing}<span class="sr">: ${words}</span></button>`;
        })}</div>
        <div class="lane-plot">
          <svg width=${width} height=${height} viewBox=${`0 0 ${width} ${height}`} role="img" aria-label=${`${plural(best.branches.length, 'branch', 'branches')} over the frames, ${plural(best.switches.length, 'switch', 'switches')} of the best motion; in numbers in the table below`}
            @pointerdown=${press} @pointermove=${drag}>
            ${lanes.map((lane, row) => laneShape(lane, row, top))}
            ${best.switches.map(({ frame: at, from, to }) => svg`<path class="switch-line" d=${`M${xOf(Math.max(0, at - 0.5))} ${y(from)}V${y(to)}M${xOf(Math.max(0, at - 0.5))} ${above - 3}V${Math.min(y(from), y(to)) - HIGH}`} />`)}
            ${runs.map(({ branch, from, to }) => svg`<path class="best-line" d=${`M${xOf(Math.max(0, from - 0.5))} ${y(branch)}H${xOf(Math.min(last(), to + 0.5))}`} />`)}
          </svg>
          ${best.switches.map((one, index) => {
            const { at, text } = labels[index];
            const words = switchSentence(one, motion);
            return html`<button class="switch" .style=${`left: ${at}px`} title=${words} aria-label=${words} @click=${() => goTo(one.frame)}>${text}</button>`;
          })}
          <div class="lane-playhead" aria-hidden="true"></div>
        </div>
        <div class="lane-numbers" aria-hidden="true">${withNumbers ? lanes.map(({ mean }) => html`<span>mean ${distance(mean)}</span>`) : nothing}</div>
        ${more > 0 ? html`<p class="muted more">and ${plural(more, 'branch', 'branches')} more, farther from the goal</p>` : nothing}
        ${calmer ? html`<p class="muted more">Marks and switches are those of the best motion, from which the calmer one departs.</p>` : nothing}`,
      root,
    );
    showAt(frame);
  }

  /** @param {number} at frame of the playhead */
  function showAt(at) {
    frame = at;
    const line = /** @type {HTMLElement | null} */ (root.querySelector('.lane-playhead'));
    if (line) line.style.left = `${xOf(at)}px`;
  }

  return {
    root,
    showAt,
    /** @param {Best | null} best @param {import('../../core/types.js').Motion | null} motion @param {boolean} calmer whether a calmer motion is chosen, which is on no branch */
    update(best, motion, calmer) {
      const isNew = !shown;
      shown = best && motion ? { best, motion, calmer } : null;
      root.hidden = !shown;
      if (!shown) return render(nothing, root);
      if (isNew) measure();
      draw();
    },
  };
}

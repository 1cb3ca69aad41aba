/**
 * In the strip of the animation bar: the distances of the motion that is not shown there, the followed or the best one, as a dashed
 * line, and the switches as verticals. Both motions are drawn in one scale, that of the higher one.
 */
import { nameOf } from '../../core/best-motions.js';
import { drawStrip, highestGap, stripGaps } from '../../bar/strip.js';

const SVG = 'http://www.w3.org/2000/svg';
/** As in bar/strip.js: its height, and the foot of its curve. */
const HEIGHT = 24;
const TOP = 18;
/** More pieces along the strip than a screen has columns. */
const PIECES = 4_000;

/**
 * A motion's gaps as a line.
 * @param {import('../../core/types.js').Motion} motion @param {number} highest the gap that is drawn full: none of the motion's is higher
 */
export function gapLine(motion, highest) {
  const gaps = stripGaps(motion);
  const step = Math.ceil(motion.frames / PIECES);
  let path = '';
  for (let frame = 0; frame < motion.frames; frame += step) path += `${path ? 'L' : 'M'}${frame} ${(TOP - (highest > 0 ? gaps[frame] / highest : 0) * (TOP - 1)).toFixed(2)}`;
  return path;
}

/** @param {Pick<import('../../element/workbench.js').App, 'find' | 'store'>} app @param {import('./search-state.js').SearchState} search */
export function createStripOverlay({ find, store }, search) {
  /** @type {SVGSVGElement} */
  const strip = find('strip');
  const root = document.createElementNS(SVG, 'svg');
  root.id = 'strip-best';
  root.setAttribute('preserveAspectRatio', 'none');
  root.setAttribute('aria-hidden', 'true');
  strip.after(root);
  /** @type {unknown[]} */
  let drawn = [];
  /** In which scale the shown motion stands in the strip, where that is not its own. @type {number | undefined} */
  let scale;

  /** The bar draws the shown motion in its own scale, at each result. */
  function rescale() {
    const { motion } = store.result;
    if (motion && scale) drawStrip(strip, motion, scale);
  }

  function draw() {
    const { motion: best, followed, doc, best: found } = search.now;
    // A calmer motion has none.
    const switches = nameOf(best) === 'best' ? found?.switches : undefined;
    const { motion } = store.result;
    const other = motion === best ? followed : best;
    const now = doc === store.result.doc && motion && other && other !== motion ? [motion, other, found, switches] : [];
    if (now.length === drawn.length && now.every((part, i) => part === drawn[i])) return rescale();
    drawn = now;
    root.replaceChildren();
    const isScaled = scale !== undefined;
    scale = undefined;
    if (!now.length || !motion || !other) {
      if (motion && isScaled) drawStrip(strip, motion);
      return;
    }
    root.setAttribute('viewBox', `0 0 ${Math.max(1, motion.goal_frames - 1)} ${HEIGHT}`);
    const [own, others] = [highestGap(motion), highestGap(other)];
    if (others > own) scale = others;
    if (isScaled && !scale) drawStrip(strip, motion);
    rescale();
    add('other', gapLine(other, Math.max(own, others)));
    for (const { frame } of switches ?? []) add('switch', `M${Math.max(0, frame - 0.5)} 0V${HEIGHT}`);
  }

  /** @param {string} name @param {string} d */
  function add(name, d) {
    const path = document.createElementNS(SVG, 'path');
    path.setAttribute('class', name);
    path.setAttribute('d', d);
    root.append(path);
  }
  search.subscribe(draw);
  store.subscribe('result', draw);
  draw();
}

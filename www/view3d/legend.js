/**
 * The legend of the 3D view: which line is which, and which gap is how large.
 */
import { length } from '../core/format.js';
import { element } from '../ui/dom.js';
import { gapClass, gapFrames } from './scene/gap-lines.js';

/** @param {HTMLElement} list @param {Pick<import('../element/workbench.js').App, 'store' | 'scene'>} app */
export function createLegend(list, { store, scene }) {
  let written = '';

  function show() {
    const { motion, doc } = store.result;
    if (!motion || !scene) return;
    const { goal, closest, gaps } = store.view.show;
    const steps = scene.gapSteps;
    const seen = new Set(gapFrames(motion, scene.linkRadius).map((frame) => gapClass(motion.translation_gap[frame], steps)));
    const size = (/** @type {number} */ step) => length(step, doc?.length_unit);
    /** @type {[string, string][]} */
    const items = [];
    if (goal) items.push(['goal', 'goal motion']);
    if (closest) items.push(['closest', 'closest motion']);
    if (gaps) items.push(['gap', 'gap at this frame']);
    if (gaps && seen.has(0)) items.push(['gap-0', `gap < ${size(steps[1])}`]);
    if (gaps && seen.has(1)) items.push(['gap-1', `gap ≥ ${size(steps[1])}`]);
    if (gaps && seen.has(2)) items.push(['gap-2', `gap ≥ ${size(steps[2])}`]);
    const next = JSON.stringify(items);
    if (next === written) return;
    written = next;
    list.replaceChildren(...items.map(([line, text]) => element('li', { class: line }, text)));
  }

  store.subscribe('result', show);
  store.subscribe('view', show);
  show();
}

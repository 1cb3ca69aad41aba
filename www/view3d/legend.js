/**
 * The legend of the 3D view: which line is which, and which gap is how large. It folds to its button, which is remembered; as
 * long as nobody has said, it does so where there is little room.
 */
import { atRest } from '../core/at-rest.js';
import { closestName } from '../core/best-motions.js';
import { length } from '../core/format.js';
import { drivesJoints } from '../core/driven.js';
import { hasNoGoal } from '../core/shown.js';
import { recall, remember } from '../ui/kept-layout.js';
import { html, render } from '../ui/render.js';
import { gapClass, gapFrames } from './scene/gap-lines.js';

/** The least view with an unfolded legend, in pixels: not on a phone. */
const ROOM = { width: 480, height: 300 };

/**
 * What the view shows now, as items of a list whose classes the style sheet knows.
 * @param {Pick<import('../element/workbench.js').App, 'store' | 'scene'>} app
 */
export function legendItems({ store, scene }) {
  const { motion, doc } = store.result;
  if (!motion || !scene) return [];
  // A joint that is driven goes to no goal; where the motion drives joints, a hand may still pull.
  const driven = drivesJoints(motion);
  const goal = store.view.show.goal && !driven && !hasNoGoal(store);
  const gaps = store.view.show.gaps && !hasNoGoal(store);
  const steps = scene.gapSteps;
  const seen = new Set(gaps ? gapFrames(motion, scene.linkRadius).map((frame) => gapClass(motion.translation_gap[frame], steps)) : []);
  const size = (/** @type {number} */ step) => length(step, doc?.length_unit);
  /** @type {[boolean, string, string][]} */
  const lines = [
    [goal, 'goal', 'goal motion'],
    [store.view.show.closest, 'closest', driven ? 'path of the workpiece' : closestName(motion)],
    [gaps, 'gap', store.view.posture ? 'gap here' : 'gap at this frame'],
    [seen.has(0), 'gap-0', `gap < ${size(steps[1])}`],
    [seen.has(1), 'gap-1', `gap ≥ ${size(steps[1])}`],
    [seen.has(2), 'gap-2', `gap ≥ ${size(steps[2])}`],
  ];
  for (const note of scene.added.notes) lines.push([true, 'note', note]);
  return lines.filter(([drawn]) => drawn).map(([, line, text]) => html`<li class=${line}>${text}</li>`);
}

/** @param {Pick<import('../element/workbench.js').App, 'find' | 'store' | 'scene'>} app */
export function createLegend(app) {
  const { find, store, scene } = app;
  const list = find('legend');
  const button = find('fold-legend');
  let { legend: said } = recall();

  /** @param {boolean} open */
  function unfold(open) {
    if (list.hidden !== open) return;
    list.hidden = !open;
    button.ariaExpanded = String(open);
  }
  button.addEventListener('click', () => {
    said = list.hidden !== false;
    unfold(said);
    remember({ legend: said });
  });
  scene?.drawn.add((width, height) => unfold(said ?? (width >= ROOM.width && height >= ROOM.height)));

  const show = () => render(legendItems(app), list);
  atRest(app.store, ['result', 'view'], show);
  scene?.added.noted.add(show);
  show();
}

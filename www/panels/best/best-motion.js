/**
 * All that shows the best motion, but for its panel: the search, the line in the info panel, the curve in the animation bar, and the
 * ghost in the view. Loaded when a better motion is looked for, by itself or by a person.
 */
import { wear } from '../../ui/style-sheets.js';
import { withPart } from '../../ui/lazy.js';
import look from '../../style/best.css?inline';
import { createBetterLine } from './better-line.js';
import { createSearchState } from './search-state.js';
import { createStripOverlay } from './strip-overlay.js';

/** @param {import('../../element/workbench.js').App} app */
export function createBestMotion(app) {
  wear(app.root, look);
  const search = createSearchState(app);
  createBetterLine(app, search);
  createStripOverlay(app, search);
  let hasGhost = false;
  search.subscribe(() => {
    const { scene } = app;
    if (hasGhost || !scene || !search.now.motion) return;
    hasGhost = true;
    withPart(app, 'The ghost of the best motion', () => import('../../view3d/best-ghost.js'), ({ createBestGhost }) => createBestGhost(app, scene, search));
  });
  return search;
}

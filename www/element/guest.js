/**
 * What an element needs only in somebody else's page: it takes no more of pointer, wheel, fingers and keys than is its own.
 */
import { windowOf } from '../ui/dom.js';
import { guardKeys } from '../ui/key-guard.js';
import { wear } from '../ui/style-sheets.js';
import { createInteraction } from '../view3d/interaction.js';
import look from '../style/guest.css?inline';

/** Below this height the animation bar is one row, in pixels. With two rows the least view makes a little more. */
const LOW = 180;
/** Below this height of the view its legend would hide what it explains, in pixels. */
const LOW_VIEW = 200;

/** @param {import('./workbench.js').App} app */
export function createGuest(app) {
  const { root, keys, signal, find } = app;
  wear(root, look);
  const bench = find('bench');
  const canvas = find('canvas');
  const heights = new (windowOf(bench).ResizeObserver)(() => {
    bench.classList.toggle('low', bench.clientHeight < LOW);
    bench.classList.toggle('low-view', canvas.clientHeight < LOW_VIEW);
  });
  for (const one of [bench, canvas]) heights.observe(one);
  signal.addEventListener('abort', () => heights.disconnect());
  createInteraction(app);
  if (keys === root) guardKeys(root, signal);
}

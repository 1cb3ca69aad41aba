/**
 * What moves things by hand in the 3D view is loaded when a hand may come: a pointer over the view, the focus in it,
 * or something chosen that can be moved. What holds the workpiece back is drawn once it is known, after a person did anything.
 */
import { withPart } from '../ui/lazy.js';

/** @param {import('../element/workbench.js').App} app */
export function createByHand(app) {
  if (!app.scene) return;
  const canvas = app.find('canvas');
  let loading = false;
  let made = false;
  async function load() {
    if (loading) return;
    loading = true;
    app.planner.prepare();
    // Once it has failed, the next pointer tries again too.
    loading = await withPart(app, 'Moving by hand', () => import('./hand/drag.js'), ({ createDrag }) => {
      if (!made) createDrag(app);
      made = true;
    });
  }
  canvas.addEventListener('pointerenter', load);
  canvas.addEventListener('focus', load);
  // A key frame is chosen by its name from the first click on, which may come before what moves it. That then sees to it
  // alone: the names change places when one is chosen, and the second to hear of a click would read another's.
  app.find('labels').addEventListener('click', ({ target }) => {
    const place = target instanceof HTMLElement ? target.dataset.place : '';
    if (!place?.startsWith('motion.key_frames')) return;
    if (!made) app.store.setView({ selected: place });
    // Keys move it from here on, as after a click on the key frame itself.
    canvas.focus({ preventScroll: true });
  });
  app.store.select(({ view }) => view.selected, (selected) => selected && load());

  let touched = false;
  let holds = false;
  async function draw() {
    const { why, view } = app.store;
    if (!touched || holds || !why || view.playing || !(view.show.holds || view.show.freedoms)) return;
    holds = true;
    await withPart(app, 'What holds the workpiece back', () => import('./hand/holds.js'), ({ createHolds }) => app.scene && createHolds(app, app.scene));
  }
  const touch = () => {
    touched = true;
    draw();
  };
  // In another page only what is done with the linkage itself.
  for (const type of ['pointerdown', 'keydown']) app.keys.addEventListener(type, touch, { once: true, capture: true, signal: app.signal });
  app.store.subscribe('why', draw);
  app.store.subscribe('view', draw);
}

/**
 * The panels around the 3D view: tables, joints, types, info, charts, algorithm, best motion. What is seen later is loaded later.
 *
 * @typedef {import('./workbench.js').App} App
 * @typedef {import('./workbench.js').AppWithPanels} AppWithPanels
 */
import markup from './panels.html?raw';
import { ask } from '../core/ask.js';
import { allTimes, keyFrameFrames } from '../core/playhead.js';
import { DEFAULTS } from '../core/defaults.js';
import { textOf } from '../core/document-text.js';
import { createDock } from '../panels/dock.js';
import { createFolds } from '../panels/folds.js';
import { whenSeen, withPart } from '../ui/lazy.js';
import { createSelection } from '../panels/tables/selection.js';
import { createStatus } from '../panels/info/status.js';
import { createTables } from '../panels/tables/tables.js';
import { createTabs } from '../ui/tabs.js';
import { createTree } from '../panels/tree.js';
import { createWhy } from '../panels/info/why.js';

/**
 * @param {App} bare
 * @param {import('../panels/info/banners.js').Banners} banners
 * @returns {Promise<AppWithPanels>}
 */
export async function createPanels(bare, banners) {
  const { find, store, player, planner, say, findStart } = bare;
  const template = document.createElement('template');
  template.innerHTML = markup;
  find('frame').append(template.content);
  find('stage').append(find('dock'));
  find('canvas').closest('.view')?.append(find('fold-tables'), find('fold-info'));
  find('track').parentElement?.append(find('view-only'));
  leaveOut(bare);

  const tabs = createTabs(find('tabs'));
  const app = { ...bare, tabs, ...createFolds(bare) };
  tabs.settle();
  createDock(app, createTabs(find('dock-tabs')));
  app.explain();
  const goToKey = (/** @type {number} */ key) => {
    const { motion, plain } = store.result;
    player.pause();
    if (motion && plain) player.frame = keyFrameFrames(plain, allTimes(motion))[key];
  };
  const places = { root: find('tables'), mechanism: find('mechanism'), motion: find('motion') };
  const compareMetrics = (/** @type {string} */ text, /** @type {AbortSignal} */ signal) => ask(() => planner.compareMetrics(text, signal), 'compare the metrics');
  const readPoses = (/** @type {string} */ table, /** @type {import('../core/types.js').PoseTableRequest} */ request) => ask(() => planner.readPoses(table, request), 'read the table');
  const check = async (/** @type {import('../core/types.js').MechanismDocument} */ doc) => {
    const read = await ask(() => planner.normalise(textOf(doc)), 'read the document');
    return read.is === 'fault' ? read.fault : null;
  };
  const openModes = (/** @type {number} */ key) => withPart(app, 'The ways to assemble', () => Promise.all([import('../panels/best/modes-dialog.js'), import('../export/picture.js')]), ([{ openModes }, pictures]) => openModes(app, key, pictures));
  const tables = createTables(places, store, DEFAULTS, { markFault: tabs.mark, findStart, goToKey, openModes, compareMetrics, readPoses, check, bringOut: (target) => bringOut(target, app), say, rewrite: (text, chain) => ask(() => planner.byAxes(text, chain), 'find the axes'), view: app });
  const selection = createSelection(places.root, [places.mechanism, places.motion], app, tables.ready);
  for (const kind of ['pointerover', 'focusin']) places.root.addEventListener(kind, () => planner.prepare(), { once: true });
  places.root.addEventListener('focusin', ({ target }) => bringOut(/** @type {Element} */ (target), app));
  createTree(/** @type {HTMLDetailsElement} */ (find('objects')), app, selection.enter);
  createStatus(app);
  createWhy(app);
  banners.goToFault(() => tables.focusFault((panel) => {
    app.unfold(panel);
    tabs.choosePanel(panel);
  }));
  const best = () => import('../panels/best/at-rest.js');
  // In the applet by itself, when the first picture is long there; on another page only where it is asked for.
  if (app.interaction === 'full' && app.keys !== app.root) setTimeout(() => best().then(({ searchAtRest }) => searchAtRest(app), () => {}), LATER);
  whenSeen(find('best'), 'The best motion', async () => {
    const [{ createBestPanel }, { searchOf }] = await Promise.all([import('../panels/best/panel.js'), best()]);
    createBestPanel(app, find('best'), searchOf(app), openModes);
  });
  whenSeen(find('algorithm'), 'The algorithm', async () => (await import('../panels/algorithm/algorithm.js')).createAlgorithm(app, find('algorithm')));
  whenSeen(find('charts'), 'The charts', async () => (await import('../panels/charts/charts.js')).createCharts(app, find('charts')));
  whenSeen(find('types'), 'The types', async () => (await import('../panels/types/types-panel.js')).createTypes(app, find('types')));
  whenSeen(find('teach'), 'The joints', async () => (await import('../panels/teach/teach.js')).createTeach(app, find('teach')));
  return app;
}

/** When that is loaded which the first view does not need, in milliseconds. */
const LATER = 2000;

/** Room for the row above, in pixels. */
const ABOVE = 32;

/**
 * What takes the focus comes out from under the view, which stays on top of the tables on a phone. Not by scroll-margin: the
 * frame in which a wide table scrolls takes that for itself.
 * @param {Element} target @param {Pick<App, 'find' | 'narrow'>} app
 */
function bringOut(target, { find, narrow }) {
  const stage = find('stage');
  const covered = () => stage.getBoundingClientRect().bottom + ABOVE - target.getBoundingClientRect().top;
  if (!narrow() || covered() <= ABOVE) return;
  // Either the element scrolls or the page around it.
  find('bench').scrollBy(0, -covered());
  if (covered() > ABOVE) window.scrollBy(0, -covered());
}

/** Beside the tables, one at a time. @type {import('./workbench.js').Panel[]} */
const TABLES = ['mechanism', 'motion', 'teach', 'types'];
/** @type {import('./workbench.js').Panel[]} */
const DOCK = ['charts', 'algorithm', 'best'];

/** Panels that are not asked for have no tab, and leave their room to the view. @param {Pick<App, 'find' | 'panels'>} app */
function leaveOut({ find, panels }) {
  for (const name of /** @type {import('./workbench.js').Panel[]} */ ([...TABLES, ...DOCK, 'info'])) find(`tab-${name}`).hidden = !panels.includes(name);
  const any = (/** @type {import('./workbench.js').Panel[]} */ names) => names.some((name) => panels.includes(name));
  const frame = find('frame');
  frame.classList.add('with-panels');
  frame.classList.toggle('with-tables', any(TABLES));
  frame.classList.toggle('with-info', panels.includes('info'));
  frame.classList.toggle('with-dock', any(DOCK));
  find('objects').hidden = !any(['mechanism', 'motion']);
}

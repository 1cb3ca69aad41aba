/**
 * Composition of the page: makes the parts and connects them.
 *
 * @typedef {object} App what every part of the page may use
 * @property {ReturnType<typeof createStore>} store
 * @property {Planner} planner
 * @property {Player} player
 * @property {ReturnType<typeof import('./scene/scene.js').createScene>} scene null where there is no WebGL
 * @property {import('./types.js').Defaults} defaults
 * @property {ReturnType<typeof createTabs>} tabs
 * @property {import('./view/notice.js').Say} say
 * @property {ReturnType<typeof createOpening>['open']} open shows another document, as a step that undo takes back
 */
import { createStage } from './stage.js';
import { byId } from './dom.js';
import { createExport } from './export/menu.js';
import { createAutosave } from './files/autosave.js';
import { createDocuments } from './files/documents.js';
import { createKeeper } from './files/keeper.js';
import { createHelp } from './help/help.js';
import { createInsight } from './insight.js';
import { workOffline } from './offline.js';
import { createOpening } from './opening.js';
import { Planner, PlannerFailure } from './planner.js';
import { Player } from './player.js';
import { keyFrameFrames } from './playhead.js';
import { createReplanning } from './replan.js';
import { samples } from './samples.js';
import { createStore } from './store.js';
import { createByHand } from './view/by-hand.js';
import { createDock } from './view/dock.js';
import { createDrop } from './view/drop.js';
import { createHeader } from './view/header.js';
import { createHistory } from './view/history.js';
import { whenSeen } from './view/lazy.js';
import { createLegend } from './view/legend.js';
import { createNotices } from './view/notice.js';
import { createPointing } from './view/pointing.js';
import { createSelection } from './view/selection.js';
import { createStatus } from './view/status.js';
import { createTables } from './view/tables.js';
import { createTabs } from './view/tabs.js';
import { createTree } from './view/tree.js';
import { createTransport } from './view/transport.js';
import { createWhy } from './view/why.js';
import { createViewBar } from './view/view-bar.js';

const planner = new Planner();
const store = createStore(JSON.parse(samples[0].text));
const player = new Player(store, () => stage.draw());
const stage = createStage(store, player);
const tabs = createTabs(byId('tabs'));
createDock(tabs, createTabs(byId('dock-tabs')));
const say = createNotices(byId('notices'));

const keeper = createKeeper(() => localStorage, Math.random().toString(36).slice(2));
const { open, start } = createOpening({ store, planner, player, say }, keeper);

/** @param {import('./types.js').Defaults} defaults */
function connect(defaults) {
  /** @type {App} */
  const app = { store, planner, player, scene: stage.scene, defaults, tabs, say, open };
  const { findStart } = createReplanning(app);
  createInsight(app);
  const goToKey = (/** @type {number} */ key) => {
    const { motion, document } = store.result;
    player.pause();
    if (motion && document) player.frame = keyFrameFrames(document, motion.time)[key];
  };
  const panels = { root: byId('tables'), mechanism: byId('mechanism'), motion: byId('motion') };
  const tables = createTables(panels, store, defaults, { markFault: tabs.mark, findStart, goToKey, say });
  const selection = createSelection(panels.root, [panels.mechanism, panels.motion], app);
  createTree(/** @type {HTMLDetailsElement} */ (byId('objects')), app, selection.enter);
  createStatus(store, player, () => tables.focusFault((panel) => tabs.choosePanel(panel)));
  createTransport(store, player);
  createHistory(store);
  const documents = createDocuments(app);
  createHeader(app, documents, keeper);
  createDrop(documents, open);
  createExport(app);
  createHelp(app);
  createPointing(app);
  whenSeen(byId('algorithm'), 'The algorithm', async () => (await import('./view/algorithm.js')).createAlgorithm(app, byId('algorithm')));
  whenSeen(byId('charts'), 'The charts', async () => (await import('./view/charts.js')).createCharts(app, byId('charts')));
  whenSeen(byId('types'), 'The types', async () => (await import('./view/types-panel.js')).createTypes(app, byId('types')));
  whenSeen(byId('teach'), 'The joints', async () => (await import('./view/teach.js')).createTeach(app, byId('teach')));
  createViewBar(app);
  createWhy(app);
  createLegend(byId('legend'), app);
  createByHand(app);
}

try {
  connect(await planner.defaults());
  await start();
  createAutosave({ store, say }, keeper);
  if (!matchMedia('(prefers-reduced-motion: reduce)').matches) player.play();
  workOffline();
} catch (error) {
  if (!(error instanceof PlannerFailure)) throw error;
  byId('trouble').hidden = false;
  byId('trouble').textContent = `The planner could not be started (${error.message}). Reload the page to try again.`;
}

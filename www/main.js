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
 * @property {(text: string) => Promise<void>} open shows another document, with a new history
 */
import { createStage } from './stage.js';
import { byId, element, setText } from './dom.js';
import { createExport } from './export/menu.js';
import { createHelp } from './help/help.js';
import { workOffline } from './offline.js';
import { Planner, PlannerFailure } from './planner.js';
import { Player } from './player.js';
import { createReplanning } from './replan.js';
import { samples } from './samples.js';
import { createStore } from './store.js';
import { createDock } from './view/dock.js';
import { createHistory } from './view/history.js';
import { whenSeen } from './view/lazy.js';
import { createLegend } from './view/legend.js';
import { createNotices } from './view/notice.js';
import { createPointing } from './view/pointing.js';
import { createStatus } from './view/status.js';
import { createTables } from './view/tables.js';
import { createTabs } from './view/tabs.js';
import { createTransport } from './view/transport.js';
import { createViewBar } from './view/view-bar.js';

const planner = new Planner();
const store = createStore(JSON.parse(samples[0].text));
const player = new Player(store, () => stage.draw());
const stage = createStage(store, player);
const tabs = createTabs(byId('tabs'));
createDock(tabs, createTabs(byId('dock-tabs')));
const say = createNotices(byId('notices'));

/** @param {string} text a document */
async function open(text) {
  const whole = await planner.normalise(text).catch(() => text);
  const document = JSON.parse(whole);
  stage.expect(document);
  player.currentTime = 0;
  store.open(document);
}

/** @param {import('./types.js').Defaults} defaults */
function connect(defaults) {
  /** @type {App} */
  const app = { store, planner, player, scene: stage.scene, defaults, tabs, say, open };
  const { findStart } = createReplanning(app);
  const panels = { root: byId('tables'), mechanism: byId('mechanism'), motion: byId('motion') };
  const tables = createTables(panels, store, defaults, { markFault: tabs.mark, findStart });
  createStatus(store, player, () => tables.focusFault((panel) => tabs.choosePanel(panel)));
  createTransport(store, player);
  createHistory(store);
  createExport(app);
  createHelp(app);
  createPointing(app);
  whenSeen(byId('charts'), 'The charts', async () => (await import('./view/charts.js')).createCharts(app, byId('charts')));
  createViewBar(app);
  createLegend(byId('legend'), app);
  // What moves by hand waits until there is something to move.
  const first = store.subscribe('result', () => {
    if (!store.result.motion) return;
    first();
    import('./drag/drag.js').then(({ createDrag }) => createDrag(app));
  });

  store.subscribe('document', () => {
    setText(byId('about'), store.document.about ?? '');
    byId('about').title = store.document.about ?? '';
    document.title = `${store.document.name || 'Linkage'} – Synthetica`;
  });
}

/** @type {HTMLSelectElement} */
const picker = byId('sample');
picker.append(...samples.map(({ file, title, line }) => element('option', { value: file, title: line }, title)));
picker.addEventListener('change', () => {
  const chosen = samples.find(({ file }) => file === picker.value);
  if (chosen) open(chosen.text);
});

try {
  connect(await planner.defaults());
  await open(samples[0].text);
  if (!matchMedia('(prefers-reduced-motion: reduce)').matches) player.play();
  workOffline();
} catch (error) {
  if (!(error instanceof PlannerFailure)) throw error;
  byId('trouble').hidden = false;
  byId('trouble').textContent = `The planner could not be started (${error.message}). Reload the page to try again.`;
}

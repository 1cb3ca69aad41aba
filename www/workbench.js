/**
 * What is seen of a linkage: the 3D view, the animation bar, and the panels that are asked for. It is made in a shadow
 * tree, and lives until its signal is aborted; the linkage lives on.
 *
 * @typedef {import('./linkage.js').Linkage} Linkage
 * @typedef {'mechanism' | 'motion' | 'teach' | 'types' | 'info' | 'charts' | 'algorithm'} Panel
 *
 * @typedef {object} Place
 * @property {ShadowRoot} root
 * @property {EventTarget} keys where the keys of the animation are listened to
 * @property {AbortSignal} signal
 * @property {Panel[]} panels
 *
 * @typedef {Linkage & Place & {
 *   find: import('./dom.js').Find,
 *   narrow: () => boolean,
 *   scene: ReturnType<typeof import('./scene/scene.js').createScene>,
 *   explain: () => void,
 * }} App what every part may use: `find` an element of the shadow tree; `narrow` if it has the width of a phone; `scene`
 *   null where there is no WebGL; `explain` keeps the store's insight up to date from then on
 * @typedef {App & {tabs: ReturnType<typeof import('./view/tabs.js').createTabs>}} AppWithPanels
 */
import { finder } from './dom.js';
import { createInsight } from './insight.js';
import { createStage } from './stage.js';
import { createBanners } from './view/banners.js';
import { createByHand } from './view/by-hand.js';
import { createHistoryKeys } from './view/history.js';
import { createLegend } from './view/legend.js';
import { createNotices } from './view/notice.js';
import { createPlanning } from './view/planning.js';
import { createPointing } from './view/pointing.js';
import { createTransport } from './view/transport.js';
import { createViewBar } from './view/view-bar.js';

/** Widths below this have the phone's layout, in pixels; style/narrow.css has it too. */
const PHONE = 760;

/**
 * @param {Linkage} linkage
 * @param {Place} place
 * @returns {Promise<AppWithPanels>} without `tabs` where no panels are asked for
 */
export async function createWorkbench(linkage, place) {
  const { root, signal, panels } = place;
  const find = finder(root);
  const store = heldBy(linkage.store, signal);
  linkage.tell = createNotices(find('notices'));
  const bench = find('bench');
  const narrow = () => bench.clientWidth < PHONE;
  let explained = false;
  const explain = () => {
    if (!explained) createInsight(app);
    explained = true;
  };
  const { scene } = createStage({ find, store, player: linkage.player, signal });
  /** @type {App} */
  const app = { ...linkage, ...place, store, find, narrow, scene, explain };
  const banners = createBanners(app);
  createPlanning(app);
  createTransport(app);
  createPointing(app);
  createViewBar(app);
  createLegend(find('legend'), app);
  createByHand(app);
  createHistoryKeys(app);
  if (!panels.length) return /** @type {AppWithPanels} */ (app);
  const { createPanels } = await import('./panels.js');
  if (signal.aborted) return /** @type {AppWithPanels} */ (app);
  return createPanels(app, banners);
}

/** The same store, whose listeners leave with the signal. @param {import('./store.js').Store} store @param {AbortSignal} signal @returns {import('./store.js').Store} */
function heldBy(store, signal) {
  /** @type {import('./store.js').Store['subscribe']} */
  const subscribe = (part, listener) => {
    const leave = store.subscribe(part, listener);
    signal.addEventListener('abort', leave, { once: true });
    return leave;
  };
  return Object.create(store, { subscribe: { value: subscribe } });
}

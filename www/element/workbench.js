/**
 * What is seen of a linkage: the 3D view, the animation bar, and the panels that are asked for. It is made in a shadow
 * tree, and lives until its signal is aborted; the linkage lives on.
 *
 * @typedef {import('../core/linkage.js').Linkage} Linkage
 * @typedef {'mechanism' | 'motion' | 'teach' | 'types' | 'info' | 'charts' | 'algorithm' | 'best'} Panel
 *
 * @typedef {'none' | 'ctrl' | 'full'} Interaction
 *
 * @typedef {object} Place
 * @property {ShadowRoot} root
 * @property {Document | ShadowRoot} keys where the keys of the animation are listened to
 * @property {AbortSignal} signal
 * @property {Panel[]} panels
 * @property {Interaction} interaction how much of pointer, wheel and keys is taken from the page around it
 *
 * @typedef {Linkage & Place & {
 *   find: import('../ui/dom.js').Find,
 *   narrow: () => boolean,
 *   scene: ReturnType<typeof import('../view3d/scene/scene.js').createScene>,
 *   explain: () => void,
 * }} App what every part may use: `find` an element of the shadow tree; `narrow` if it has the width of a phone; `scene`
 *   null where there is no WebGL; `explain` keeps the store's `why` up to date from then on
 * @typedef {App & {tabs: ReturnType<typeof import('../ui/tabs.js').createTabs>} & ReturnType<typeof import('../panels/folds.js').createFolds>} AppWithPanels
 */
import { finder } from '../ui/dom.js';
import { createExplainer } from '../core/explain.js';
import { pieces } from './pieces.js';
import { createStage } from './canvas-area.js';
import { loaded } from '../ui/lazy.js';
import { createBanners } from '../panels/info/banners.js';
import { createByHand } from '../view3d/by-hand.js';
import { createHistoryKeys } from './history-keys.js';
import { createLegend } from '../view3d/legend.js';
import { createPlanning } from '../view3d/planning.js';
import { createPointing } from '../view3d/pointing.js';
import { createPrinting } from '../view3d/printing.js';
import { createTransport } from '../bar/transport.js';
import { createViewBar } from '../view3d/view-bar.js';

/** Widths below this have the phone's layout, in pixels; style/narrow.css has it too. */
const PHONE = 760;

/**
 * @param {Linkage} linkage
 * @param {Place} place
 * @returns {Promise<AppWithPanels>} without `tabs` where no panels are asked for
 */
export async function createWorkbench(linkage, place) {
  const { root, signal, panels, interaction } = place;
  // The applet is nobody's guest.
  const guest = interaction === 'full' && place.keys !== root ? null : await loaded({ say: linkage.say, signal }, 'The view', () => pieces.guest());
  const find = finder(root);
  const store = heldBy(linkage.store, signal);
  const bench = find('bench');
  bench.dataset.interaction = interaction;
  const narrow = () => bench.clientWidth < PHONE;
  let explained = false;
  const explain = () => {
    if (!explained) createExplainer(app);
    explained = true;
  };
  const { scene } = createStage({ find, store, player: linkage.player, signal });
  /** @type {App} */
  const app = { ...linkage, ...place, store, find, narrow, scene, explain };
  const banners = createBanners(app);
  createPlanning(app);
  createTransport(app);
  guest?.createGuest(app);
  createPointing(app);
  createViewBar(app);
  createLegend(app);
  createByHand(app);
  createHistoryKeys(app);
  createPrinting(app);
  if (!panels.length) return /** @type {AppWithPanels} */ (app);
  const { createPanels } = await loaded(app, 'The panels', () => pieces.panels());
  if (signal.aborted) return /** @type {AppWithPanels} */ (app);
  return createPanels(app, banners);
}

/** The same store, whose listeners leave with the signal. @param {import('../core/store.js').Store} store @param {AbortSignal} signal @returns {import('../core/store.js').Store} */
function heldBy(store, signal) {
  /** @type {import('../core/store.js').Store['subscribe']} */
  const subscribe = (part, listener) => {
    const leave = store.subscribe(part, listener);
    signal.addEventListener('abort', leave, { once: true });
    return leave;
  };
  return Object.create(store, { subscribe: { value: subscribe } });
}

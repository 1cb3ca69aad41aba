/**
 * The dock below the view: its height, folded or not, and where its panels are on a phone: among the other tabs.
 *
 * @typedef {ReturnType<typeof import('../ui/tabs.js').createTabs>} Tabs
 */
import { windowOf } from '../ui/dom.js';
import { recall, remember } from '../ui/kept-layout.js';

/** Below this height of the whole, in pixels, the view needs the room itself. */
const LOW = 650;
/** Pixels. */
const LEAST = 90;
const STEP = 24;
/** What stays of the view's height, in pixels. */
const VIEW = 160;

/** @param {Pick<import('../element/workbench.js').AppWithPanels, 'find' | 'root' | 'keys' | 'interaction' | 'narrow' | 'tabs' | 'signal'>} app @param {Tabs} dockTabs */
export function createDock({ find, root, keys, interaction, narrow, tabs, signal }, dockTabs) {
  const dock = find('dock');
  const handle = find('dock-handle');
  const toggle = find('dock-toggle');
  const view = /** @type {HTMLElement} */ (dock.parentElement?.querySelector('.view'));
  // On a phone the whole is as high as its content.
  const room = narrow() ? innerHeight : find('bench').clientHeight;
  const { height = Math.round(Math.min(340, Math.max(190, 0.29 * room))), open } = recall();
  // In the applet the view has the room until charts are wanted; another page that asks for charts wants them.
  const isGuest = interaction !== 'full' || keys === root;
  const state = { height: Math.max(LEAST, height), open: open ?? (isGuest && room >= LOW) };

  const panelHeight = () => /** @type {HTMLElement | null} */ (dock.querySelector('.panel.shown'))?.offsetHeight ?? 0;
  const most = () => Math.max(LEAST, panelHeight() + view.offsetHeight - VIEW);

  function show() {
    dock.classList.toggle('closed', !state.open);
    dock.style.setProperty('--dock-height', `${state.height}px`);
    toggle.setAttribute('aria-expanded', String(state.open));
    toggle.title = state.open ? 'Fold the charts away' : 'Show the charts';
    handle.setAttribute('aria-valuenow', String(state.open ? panelHeight() : 0));
  }

  /** @param {{height?: number, open?: boolean}} change */
  function set(change) {
    Object.assign(state, change);
    show();
    remember(state);
  }

  /** Below the least height the dock folds. @param {number} height */
  function resize(height) {
    if (height < LEAST / 2) return set({ open: false });
    set({ open: true });
    set({ height: Math.round(Math.min(most(), Math.max(LEAST, height))) });
  }

  toggle.addEventListener('click', () => set({ open: !state.open }));
  find('dock-tabs').addEventListener('click', (event) => {
    if (/** @type {Element} */ (event.target).closest('[role=tab]')) set({ open: true });
  });
  handle.addEventListener('keydown', (event) => {
    const now = state.open ? panelHeight() : 0;
    const next = { ArrowUp: now ? now + STEP : LEAST, ArrowDown: now > LEAST ? Math.max(LEAST, now - STEP) : 0, Home: 0, End: Infinity }[event.key];
    if (next === undefined) return;
    event.preventDefault();
    resize(next);
  });
  let grip = 0;
  handle.addEventListener('pointerdown', (event) => {
    handle.setPointerCapture(event.pointerId);
    grip = event.clientY + (state.open ? panelHeight() : 0);
  });
  handle.addEventListener('pointermove', (event) => {
    if (handle.hasPointerCapture(event.pointerId)) resize(grip - event.clientY);
  });

  /** @type {boolean | undefined} */
  let phone;
  /** Moves the tabs with their panels. */
  function arrange() {
    if (signal.aborted || phone === narrow()) return;
    phone = narrow();
    const [row, panels] = phone ? [find('tabs'), find('tables')] : [find('dock-tabs'), dock];
    for (const name of ['charts', 'algorithm', 'best']) {
      row.append(find(`tab-${name}`));
      panels.append(find(name));
    }
    tabs.settle();
    dockTabs.settle();
  }
  // It is told once more when the element has been taken out, where nothing is found any more.
  const [frame, stage] = [find('frame'), find('stage')];
  const { ResizeObserver } = windowOf(stage);
  new ResizeObserver(() => frame.style.setProperty('--stage-height', `${stage.offsetHeight}px`)).observe(stage);
  new ResizeObserver(arrange).observe(find('bench'));
  arrange();
  show();
}

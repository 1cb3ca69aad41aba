/**
 * Composition of the page: makes the parts and connects them.
 */
import { takeStarts } from './edits.js';
import { DocumentFault, Planner, PlannerFailure } from './planner.js';
import { Player } from './player.js';
import { samples } from './samples.js';
import { createStore } from './store.js';
import { byId, element, setText } from './view/dom.js';
import { createHistory } from './view/history.js';
import { createScene } from './view/scene.js';
import { createStatus } from './view/status.js';
import { createTables } from './view/tables.js';
import { createTabs } from './view/tabs.js';
import { createTransport } from './view/transport.js';
import { describeScene } from './view/words.js';

const planner = new Planner();
const store = createStore(JSON.parse(samples[0].text));
const player = new Player(store, () => scene?.draw(store.view.frame));
const scene = openScene();
const tabs = createTabs(byId('tabs'));

/** The document whose motion should be seen from the front again. @type {unknown} */
let opened = null;
/** The motion in the view. @type {unknown} */
let drawn = null;

/** @returns {ReturnType<typeof createScene> | null} null where there is no WebGL */
function openScene() {
  const note = byId('view-note');
  const say = (/** @type {string} */ text) => {
    note.hidden = text === '';
    setText(note, text);
  };
  /** @type {HTMLCanvasElement} */
  const canvas = byId('canvas');
  canvas.addEventListener('webglcontextlost', () => say('The 3D view was interrupted by the browser. Tables and numbers go on.'));
  canvas.addEventListener('webglcontextrestored', () => {
    say('');
    player.invalidate();
  });
  const made = createScene({ canvas, labels: byId('labels') }, () => player.invalidate());
  if (!made) say('This browser shows no 3D graphics (WebGL 2). Tables and numbers work without them.');
  return made;
}

/** What the page says when the planner fails or the document is at fault. @param {unknown} error @param {unknown} document */
function report(error, document) {
  if (error instanceof DocumentFault && document === store.document) store.setResult({ fault: error.fault, trouble: '' });
  if (error instanceof PlannerFailure) {
    store.setResult({ trouble: `The planner failed on this document and was started afresh (${error.message}). Your document is safe: undo the last edit or change it.` });
  }
}

/** Plans the present document; while it is at fault, the last good motion stays. */
async function replan() {
  const { document } = store;
  try {
    const motion = await planner.plan(JSON.stringify(document));
    store.setResult({ motion, document, fault: null, trouble: '' });
  } catch (error) {
    report(error, document);
  }
}

/** Writes start values that close the loops into the document. */
async function findStart() {
  const { document } = store;
  try {
    const { chains } = JSON.parse(await planner.findStart(JSON.stringify(document)));
    store.edit((present) => takeStarts(present, chains));
  } catch (error) {
    report(error, document);
  }
}

/** @param {string} text a document */
async function open(text) {
  const whole = await planner.normalise(text).catch(() => text);
  opened = JSON.parse(whole);
  player.currentTime = 0;
  store.open(/** @type {any} */ (opened));
}

/** @param {import('./types.js').Defaults} defaults */
function connect(defaults) {
  const panels = { root: byId('tables'), mechanism: byId('mechanism'), motion: byId('motion') };
  const tables = createTables(panels, store, defaults, { markFault: tabs.mark, findStart });
  createStatus(store, player, () => {
    tables.focusFault((panel) => tabs.choosePanel(panel));
  });
  createTransport(store, player);
  createHistory(store);
  byId('fit').addEventListener('click', () => scene?.fit());

  store.subscribe('document', replan);
  store.subscribe('document', () => {
    setText(byId('about'), store.document.about ?? '');
    byId('about').title = store.document.about ?? '';
    document.title = `${store.document.name || 'Linkage'} – Synthetica`;
  });
  store.subscribe('result', () => {
    const { motion, document } = store.result;
    if (!motion || !document || motion === drawn) return;
    drawn = motion;
    scene?.show(store.result, document === opened);
    if (document === opened) opened = null;
  });
  const describe = () => {
    if (!store.view.playing) setText(byId('canvas-text'), describeScene(store));
  };
  store.subscribe('result', describe);
  store.subscribe('view', describe);
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
} catch (error) {
  if (!(error instanceof PlannerFailure)) throw error;
  byId('trouble').hidden = false;
  byId('trouble').textContent = `The planner could not be started (${error.message}). Reload the page to try again.`;
}

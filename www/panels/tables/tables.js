/**
 * The editable panels: keeps both panels of tables in step with the document and shows its fault.
 *
 * @typedef {import('../../core/store.js').Store} Store
 * @typedef {import('../../core/types.js').Fault} Fault
 */
import { atRest } from '../../core/at-rest.js';
import { valueAt } from '../../core/path.js';
import { parametersOf } from '../../core/parameter-names.js';
import { whenSeen, withPart } from '../../ui/lazy.js';
import { createArrange } from './reorder.js';
import { createCells } from './cells.js';
import { createChainTables } from './chain-tables.js';
import { cellTools } from './cell-tools.js';
import { gridKeys } from './grid-keys.js';
import { createTypedParts } from './typed-parts.js';

/** Places that the tables of the motion show. */
const OF_MOTION = /^(motion|planner)\b/;

/**
 * @param {{root: HTMLElement, mechanism: HTMLElement, motion: HTMLElement}} place
 * @param {Store} store
 * @param {import('../../core/types.js').Defaults} defaults
 * @param {{markFault: (panel: HTMLElement | null) => void, findStart: () => void, goToKey: (key: number) => void, openModes: (key: number) => void,
 *   compareMetrics: Parameters<typeof import('./metric-comparison.js').createMetricComparison>[1],
 *   readPoses: import('./pose-table-form.js').ReadPoses,
 *   check: (doc: import('../../core/types.js').MechanismDocument) => Promise<Fault | null>,
 *   bringOut: (target: Element) => void, say: import('../../ui/notice.js').Say, rewrite: import('./forms.js').Rewrite,
 *   view: import('./typed-parts.js').View}} outside
 *   `markFault` is told which panel holds the fault; `findStart` asks the planner for start values; `goToKey` takes
 *   the playhead to a key frame, `openModes` shows the ways to assemble there; `compareMetrics` asks the planner for both metrics' gaps, `readPoses` for a table's
 *   key frames, `check` for a document's fault;
 *   `bringOut` brings what has the focus out from under the view; `rewrite` asks the planner for a chain by its axes;
 *   `view` is where points are picked and axes drawn
 */
export function createTables({ root, mechanism, motion }, store, defaults, { markFault, findStart, goToKey, openModes, compareMetrics, readPoses, check, bringOut, say, rewrite, view }) {
  const arrange = createArrange(root, store, bringOut);
  const cells = createCells(store);
  // Each of the forms as a function that first loads them.
  const forms = /** @type {import('./forms.js').Forms} */ (
    new Proxy({}, {
      get: (_, name) => (/** @type {any[]} */ ...asked) =>
        withPart({ say }, 'What the tables open', () => import('./forms.js'), ({ createForms }) => {
          const all = createForms(root, store, say, readPoses, check, cells.label, rewrite);
          return /** @type {any} */ (all)[name](...asked);
        }),
    })
  );
  const typed = createTypedParts(root, () => showAnew(), say);
  const chains = createChainTables(mechanism, store, cells, defaults, arrange, findStart, forms, say, check, { typed, view });
  /** The tables of the motion, loaded when they are first seen or something in them is meant. @type {ReturnType<typeof import('./motion-tables.js').createMotionTables> | null} */
  let keys = null;
  /** @type {Promise<unknown> | null} */
  let coming = null;
  const loadMotion = () =>
    (coming ??= import('./motion-tables.js').then(
      ({ createMotionTables }) => {
        motion.replaceChildren();
        keys = createMotionTables(motion, store, cells, defaults, arrange, { goTo: goToKey, openModes, compareMetrics }, forms, typed);
        keys.reveal(store.view.selected);
        showAnew();
      },
      (error) => {
        coming = null;
        throw error;
      },
    ));
  /** Resolves when the tables that show a place are there; null where they are. @param {string} path */
  const ready = (path) => (keys || !OF_MOTION.test(path) ? null : withPart({ say }, 'The tables of the motion', loadMotion, () => {}));
  whenSeen(motion, 'The tables of the motion', loadMotion);
  /** Loaded with the first fault. @type {typeof import('./faults.js') | null} */
  let faults = null;
  /** @type {ReturnType<typeof import('./fault-note.js').createFaultNote> | null} */
  let note = null;
  /** @type {HTMLElement | null} */
  let culprit = null;
  /** What brings a panel to the front, while the cell at fault is wanted and not there. @type {((panel: HTMLElement) => void) | null} */
  let wanted = null;

  /** Shown now, and the document that they are of. @type {{faults: Fault[], doc: import('../../core/types.js').MechanismDocument}} */
  let told = { faults: [], doc: store.doc };

  /** The fault that the planner told, at once, then the others that the document has. */
  async function showFault() {
    const { doc, result: { fault } } = store;
    if (!faults) {
      if (!fault) return;
      return void withPart({ say }, 'What tells faults beside their cells', () => import('./faults.js'), (part) => {
        faults = part;
        note ??= part.createFaultNote(root);
        showFault();
      });
    }
    // With them it is shown once more.
    if (fault) ready(fault.where);
    // What was wrong and was not touched is wrong still: its mark does not go and come back.
    const same = (/** @type {Fault} */ { where }) => where !== fault?.where && valueAt(doc, where) === valueAt(told.doc, where);
    mark(fault ? [fault, ...told.faults.filter(same)] : [], doc);
    if (!fault) return;
    const newest = () => store.doc === doc && store.result.fault === fault;
    const all = await faults.allFaults(doc, fault, async (filled) => (newest() ? check(filled) : null));
    if (newest()) mark(all, doc);
  }

  /** @param {Fault[]} all @param {import('../../core/types.js').MechanismDocument} doc */
  function mark(all, doc) {
    told = { faults: all, doc };
    if (all.length) keys?.reveal(all[0].where);
    culprit = note?.show(all, doc) ?? null;
    const fold = culprit?.closest('details');
    if (fold) fold.open = true;
    markFault(culprit && (mechanism.contains(culprit) ? mechanism : motion));
    if (!all.length) wanted = null;
    if (wanted) focusFault(wanted);
  }

  /** Goes to the cell at fault, when it is there: its table may be on its way. @param {(panel: HTMLElement) => void} bring its panel to the front */
  function focusFault(bring) {
    wanted = culprit?.isConnected ? null : bring;
    if (!culprit || wanted) return;
    bring(mechanism.contains(culprit) ? mechanism : motion);
    const cell = culprit.matches('input, select') ? culprit : culprit.querySelector('input');
    if (cell instanceof HTMLElement) cell.focus();
  }

  function show() {
    cells.clear();
    chains.draw();
    keys?.draw();
    chains.drawParameters();
    // They name all cells in which they are.
    if (Object.keys(parametersOf(store.doc)).length) ready('motion');
  }

  /** Also what is at fault in tables that were not there. */
  function showAnew() {
    show();
    if (store.result.fault) showFault();
  }

  gridKeys(root);
  cellTools(root, store, cells, say, forms.parameter);
  // While a hand moves a thing, its own cells follow.
  atRest(store, ['document'], show, () => cells.follow(store.view.moving));
  atRest(store, ['result'], () => {
    show();
    showFault();
  });
  store.subscribe('view', chains.follow);
  show();

  return {
    ready,
    focusFault,
  };
}

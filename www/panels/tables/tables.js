/**
 * The editable panels: keeps both panels of tables in step with the document and shows its fault.
 *
 * @typedef {import('../../core/store.js').Store} Store
 * @typedef {import('../../core/types.js').Fault} Fault
 */
import { valueAt } from '../../core/path.js';
import { allFaults } from './all-faults.js';
import { createArrange } from './reorder.js';
import { createCells } from './cells.js';
import { createChainTables } from './chain-tables.js';
import { createFaultNote } from './fault-note.js';
import { cellTools } from './cell-tools.js';
import { createForms } from './forms.js';
import { gridBlock } from './cell-block.js';
import { gridKeys } from './grid-keys.js';
import { createMotionTables } from './motion-tables.js';
import { createTypedParts } from './typed-parts.js';

/**
 * @param {{root: HTMLElement, mechanism: HTMLElement, motion: HTMLElement}} place
 * @param {Store} store
 * @param {import('../../core/types.js').Defaults} defaults
 * @param {{markFault: (panel: HTMLElement | null) => void, findStart: () => void, goToKey: (key: number) => void,
 *   compareMetrics: Parameters<typeof import('./metric-comparison.js').createMetricComparison>[1],
 *   readPoses: import('./pose-table-form.js').ReadPoses,
 *   check: (doc: import('../../core/types.js').MechanismDocument) => Promise<Fault | null>,
 *   bringOut: (target: Element) => void, say: import('../../ui/notice.js').Say, rewrite: import('./forms.js').Rewrite,
 *   view: import('./typed-parts.js').View}} outside
 *   `markFault` is told which panel holds the fault; `findStart` asks the planner for start values; `goToKey` takes
 *   the playhead to a key frame; `compareMetrics` asks the planner for both metrics' gaps, `readPoses` for a table's
 *   key frames, `check` for a document's fault;
 *   `bringOut` brings what has the focus out from under the view; `rewrite` asks the planner for a chain by its axes;
 *   `view` is where points are picked and axes drawn
 */
export function createTables({ root, mechanism, motion }, store, defaults, { markFault, findStart, goToKey, compareMetrics, readPoses, check, bringOut, say, rewrite, view }) {
  const arrange = createArrange(root, store, bringOut);
  const cells = createCells(store);
  const forms = createForms(root, store, say, readPoses, check, cells.label, rewrite);
  const typed = createTypedParts(() => show(), say);
  const chains = createChainTables(mechanism, store, cells, defaults, arrange, findStart, forms, say, check, { typed, view });
  const keys = createMotionTables(motion, store, cells, defaults, arrange, { goTo: goToKey, compareMetrics }, forms, typed);
  const note = createFaultNote(root);
  /** @type {HTMLElement | null} */
  let culprit = null;

  /** Shown now, and the document that they are of. @type {{faults: Fault[], doc: import('../../core/types.js').MechanismDocument}} */
  let told = { faults: [], doc: store.doc };

  /** The fault that the planner told, at once, then the others that the document has. */
  async function showFault() {
    const { doc, result: { fault } } = store;
    // What was wrong and was not touched is wrong still: its mark does not go and come back.
    const same = (/** @type {Fault} */ { where }) => where !== fault?.where && valueAt(doc, where) === valueAt(told.doc, where);
    mark(fault ? [fault, ...told.faults.filter(same)] : [], doc);
    if (!fault) return;
    const newest = () => store.doc === doc && store.result.fault === fault;
    const all = await allFaults(doc, fault, async (filled) => (newest() ? check(filled) : null));
    if (newest()) mark(all, doc);
  }

  /** @param {Fault[]} faults @param {import('../../core/types.js').MechanismDocument} doc */
  function mark(faults, doc) {
    told = { faults, doc };
    if (faults.length) keys.reveal(faults[0].where);
    culprit = note.show(faults, doc);
    const fold = culprit?.closest('details');
    if (fold) fold.open = true;
    markFault(culprit && (mechanism.contains(culprit) ? mechanism : motion));
  }

  function show() {
    cells.clear();
    chains.draw();
    keys.draw();
    chains.drawParameters();
  }

  gridBlock(root, store, cells, say);
  gridKeys(root);
  cellTools(root, store, cells, say, forms.parameter);
  store.subscribe('document', show);
  store.subscribe('result', () => {
    show();
    showFault();
  });
  store.subscribe('view', chains.follow);
  show();

  return {
    /** Goes to the cell at fault. @param {(panel: HTMLElement) => void} show brings its panel to the front */
    focusFault(show) {
      if (!culprit?.isConnected) return;
      show(mechanism.contains(culprit) ? mechanism : motion);
      const cell = culprit.matches('input, select') ? culprit : culprit.querySelector('input');
      if (cell instanceof HTMLElement) cell.focus();
    },
  };
}

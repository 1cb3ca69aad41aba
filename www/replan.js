/**
 * Keeps the result in step with the document: plans after every edit, and says what the planner says.
 */
import { textOf } from './document-text.js';
import { takeStarts } from './edits.js';
import { DocumentFault, PlannerFailure } from './planner.js';

/** @param {Pick<import('./linkage.js').Parts, 'store' | 'planner'>} app */
export function createReplanning({ store, planner }) {
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
      const motion = await planner.plan(textOf(document));
      store.setResult({ motion, document, fault: null, trouble: '' });
    } catch (error) {
      report(error, document);
    }
  }

  /** Writes start values that close the loops into the document. */
  async function findStart() {
    const { document } = store;
    try {
      const { chains } = JSON.parse(await planner.findStart(textOf(document)));
      store.edit((present) => takeStarts(present, chains));
    } catch (error) {
      report(error, document);
    }
  }

  store.subscribe('document', () => {
    // A posture belongs to the document that it was moved in.
    store.setView({ posture: null });
    replan();
  });
  return { findStart };
}

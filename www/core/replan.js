/**
 * Keeps the result in step with the document: plans after every edit, and says what the planner says. A plan that takes
 * long says how far it is, and can be stopped.
 */
import { textOf } from './document-text.js';
import { takeStarts } from './edits.js';
import { DocumentFault, PlannerFailure } from '../planner/planner.js';

/** After how many milliseconds a plan takes long. */
const LONG = 500;

/** @param {Pick<import('./linkage.js').Parts, 'store' | 'planner'>} app */
export function createReplanning({ store, planner }) {
  /** What the page says when the planner fails or the document is at fault. @param {unknown} error @param {unknown} doc */
  function report(error, doc) {
    if (error instanceof DocumentFault && doc === store.doc) store.setResult({ fault: error.fault, trouble: '' });
    if (error instanceof PlannerFailure) {
      store.setResult({ trouble: `The planner failed on this document and was started afresh (${error.message}). Your document is safe: undo the last edit or change it.` });
    }
  }

  /** Of the newest plan. @type {AbortController} */
  let stop;

  /** Plans the present document, on from where its plan was stopped; while it is at fault, the last good motion stays. */
  async function replan() {
    const { doc } = store;
    const began = performance.now();
    const mine = new AbortController();
    stop = mine;
    store.setPlanning(null);
    try {
      const motion = await planner.plan(textOf(doc), {
        stop: mine.signal,
        onProgress: (progress) => {
          if (stop !== mine) return;
          // What is planned is not at fault: what was wrong with an earlier text is mended.
          if (store.result.fault) store.setResult({ fault: null });
          if (performance.now() - began > LONG) store.setPlanning({ ...progress, stop: () => mine.abort() });
        },
      });
      store.setResult({ motion, doc, fault: null, trouble: '' });
    } catch (error) {
      report(error, doc);
    } finally {
      if (stop === mine) store.setPlanning(null);
    }
  }

  /** Writes start values that close the loops into the document. */
  async function findStart() {
    const { doc } = store;
    try {
      const { chains } = JSON.parse(await planner.findStart(textOf(doc)));
      store.edit((present) => takeStarts(present, chains));
    } catch (error) {
      report(error, doc);
    }
  }

  store.subscribe('document', () => {
    // A posture belongs to the document that it was moved in.
    store.setView({ posture: null });
    replan();
  });
  return { findStart, replan };
}

/**
 * Keeps the result in step with the document: plans after every edit, and says what the planner says. A plan that takes
 * long says how far it is, and can be stopped.
 */
import { ask, troubleIsOver } from './ask.js';
import { drivesJoints, loadWords } from './driven.js';
import { textOf } from './document-text.js';
import { takeStarts } from './edits.js';
import { isEmpty } from './nothing.js';

/** After how many milliseconds a plan takes long. */
const LONG = 500;

/** @param {Pick<import('./linkage.js').Parts, 'store' | 'planner' | 'say'>} app */
export function createReplanning({ store, planner, say }) {
  /** Of the newest plan. @type {AbortController | undefined} */
  let stop;

  /** Plans the present document, on from where its plan was stopped; while it is at fault, the last good motion stays. */
  async function replan() {
    const { doc } = store;
    const began = performance.now();
    const mine = new AbortController();
    const former = stop;
    stop = mine;
    store.setPlanning(null);
    // Nobody waits for what is being planned of the former document.
    if (isEmpty(store)) return former?.abort();
    const onProgress = (/** @type {import('./types.js').Progress} */ progress) => {
      if (stop !== mine) return;
      // What is planned is not at fault: what was wrong with an earlier text is mended.
      if (store.result.fault) store.setResult({ fault: null });
      if (performance.now() - began > LONG) store.setPlanning({ ...progress, stop: () => mine.abort() });
    };
    const plan = await ask(() => planner.plan(textOf(doc), { stop: mine.signal, onProgress }), 'plan the motion');
    // A newer plan says how it is.
    if (stop !== mine) return;
    // First the result: what stands over the view goes over from one to the other, and keeps the focus.
    if (plan.is === 'answer' && drivesJoints(plan.value)) {
      await loadWords(plan.value);
      if (stop !== mine) return;
    }
    if (plan.is === 'answer') store.setResult({ motion: plan.value, doc, plain: plan.value.plain ?? doc, fault: null, trouble: '' });
    if (plan.is === 'fault') store.setResult({ fault: plan.fault, trouble: '' });
    store.setPlanning(null);
    if (plan.is !== 'trouble') return;
    await troubleIsOver(store, plan.notLoaded ? plan.message : `${plan.message} Your document is safe: undo the last edit or change it.`);
    if (stop === mine) replan();
  }

  /** Writes start values that close the loops into the document. */
  async function findStart() {
    const { doc } = store;
    const found = await ask(() => planner.findStart(textOf(doc)), 'find a start');
    // A start belongs to the document that it was found for.
    if (found.is !== 'late' && doc !== store.doc) return findStart();
    if (found.is === 'answer') store.edit((present) => takeStarts(present, JSON.parse(found.value).chains));
    if (found.is === 'fault') store.setResult({ fault: found.fault, trouble: '' });
    if (found.is === 'trouble') say(`No start was looked for. ${found.message}`, { label: 'Try again', act: findStart, stays: true });
  }

  store.subscribe('document', () => {
    // A posture belongs to the document that it was moved in.
    store.setView({ posture: null });
    replan();
  });
  return { findStart, replan };
}

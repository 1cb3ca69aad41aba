/**
 * Keeps the store's `why` in step with what is shown: asks the planner why the workpiece rests there, at once when
 * the view rests, a few times a second while it plays, and not while a hand moves something.
 */
import { ask } from './ask.js';
import { atRest } from './at-rest.js';
import { textOf } from './document-text.js';
import { groupAt, shown } from './shown.js';

/** Least pause between two questions, in milliseconds: as often as a person can read. */
const PAUSE = 120;

/** @param {Pick<import('./linkage.js').Parts, 'store' | 'planner'>} app */
export function createExplainer({ store, planner }) {
  /** The columns and the index of the last question, to tell whether anything else is shown now. @type {unknown[]} */
  let asked = [];
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let waiting;
  let last = -Infinity;

  async function askWhy() {
    waiting = undefined;
    const what = shown(store);
    if (!what) return;
    const question = [what.joints, what.goal, what.index];
    if (question.every((part, i) => part === asked[i])) return;
    asked = question;
    last = performance.now();
    const { doc, joints, goal, index } = what;
    const why = await ask(() => planner.explain(textOf(doc), groupAt(joints, what).slice(), groupAt(goal, what).slice()), 'say why the workpiece rests there');
    if (asked !== question || why.is === 'late') return;
    // Open loops hold nothing, and a planner that failed says so where the motion is planned.
    store.setWhy(why.is === 'answer' ? { ...why.value, of: { doc, joints, goal, index } } : null);
  }

  function follow() {
    waiting ??= setTimeout(askWhy, Math.max(0, last + PAUSE - performance.now()));
  }
  atRest(store, ['result', 'view'], follow);
  follow();
}

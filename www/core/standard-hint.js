/**
 * Asks whether a document's tables look like standard ones that were copied in as modified. The smaller package does not know;
 * the whole one is asked only where the motion does not begin at the start that the document gives.
 *
 * @typedef {import('./types.js').MechanismDocument} MechanismDocument
 * @typedef {import('./types.js').Motion} Motion
 */
import { drivesJoints } from './driven.js';
import { ask } from './ask.js';
import { textOf } from './document-text.js';

/** Of a joint value, rad or a share of its own: a start with six digits is met. */
const MET = 1e-4;

/** Whether the motion begins somewhere else than the document says. @param {MechanismDocument} doc @param {Pick<Motion, 'joints' | 'report'>} motion */
export function beginsElsewhere({ chains, angles }, { joints, report }) {
  if (!chains.every(({ start }) => start)) return false;
  let at = 0;
  return report.chains.some(({ variables }, c) =>
    variables.some(({ unit }, i) => {
      const value = joints[at++];
      const given = chains[c].start?.[i];
      const start = typeof given === 'number' && unit === 'rad' && angles !== 'radians' ? (given * Math.PI) / 180 : given;
      return typeof start === 'number' && Math.abs(value - start) > MET * Math.max(1, Math.abs(start));
    }),
  );
}

/**
 * @param {Pick<import('./linkage.js').Parts, 'store' | 'planner'>} app
 * @param {() => void} tell is called when the answer is yes
 * @returns {() => boolean} whether the shown motion's tables look so
 */
export function createStandardHint({ store, planner }, tell) {
  /** @type {unknown} */
  let asked = null;
  /** @type {unknown} */
  let found = null;
  store.select(({ result }) => result.motion, async (motion) => {
    const { doc } = store.result;
    if (!motion || !doc || motion.partial || drivesJoints(motion) || store.readonly || asked === doc) return;
    const named = doc.chains.some(({ convention, joints }) => convention || !joints.every(({ rows }) => rows));
    if (named || motion.report.warnings.some(({ code }) => code === 'standard-table') || !beginsElsewhere(doc, motion)) return;
    asked = doc;
    const answer = await ask(() => planner.looksStandard(textOf(doc)), 'look at the tables');
    if (answer.is !== 'answer' || !answer.value || store.result.doc !== doc) return;
    found = doc;
    tell();
  });
  return () => found !== null && store.result.doc === found;
}

/**
 * A chain by its rows becomes one by its axes, and back; the position and the motion stay, and what is counted otherwise is
 * said.
 */
import { intoRows } from '../../core/axes-edits.js';
import { isByAxes } from '../../core/by-axes.js';
import { textOf } from '../../core/document-text.js';
import { setValue } from '../../core/edits.js';
import { length } from '../../core/format.js';
import { sayUndo } from '../../core/undo.js';

/**
 * The mechanism's size follows from its rows, and the metric's length from the size: it is written down, so that the motion
 * stays.
 * @param {import('../../core/store.js').Store} store
 */
export function keptMetric({ doc, result }) {
  const metric = result.doc === doc ? result.motion?.report.metric : undefined;
  if (doc.planner?.metric_length != null || metric?.length_source !== 'mechanism') return { keep: (/** @type {import('../../core/types.js').MechanismDocument} */ now) => now, said: '' };
  return {
    keep: (/** @type {import('../../core/types.js').MechanismDocument} */ now) => setValue(now, 'planner.metric_length', metric.length),
    said: ` The metric length is kept at ${length(metric.length, doc.length_unit)}.`,
  };
}

/** @param {{store: import('../../core/store.js').Store, say: import('../../ui/notice.js').Say, rewrite: import('./forms.js').Rewrite}} app @param {number} chain */
export async function giveByAxes({ store, say, rewrite }, chain) {
  const { doc } = store;
  const { keep, said } = keptMetric(store);
  const answer = await rewrite(textOf(doc), chain);
  if (answer.is === 'late' || store.doc !== doc) return;
  if (answer.is !== 'answer') return say(`The chain was not given by its axes. ${answer.message}`);
  const { chain: fresh, home } = JSON.parse(answer.value);
  const others = doc.chains.some((other, i) => i !== chain && isByAxes(other));
  store.edit((present) => {
    const chains = present.chains.map((old, i) => (i === chain ? fresh : old));
    // A home that others have stays as it is typed.
    return keep(others ? { ...present, chains } : { ...present, home, chains });
  });
  sayUndo({ store, say }, doc, `The chain is given by its axes at ${others ? 'the home of the others' : 'its start, which is home now'}: its joints are 0 there, and its limits count from there.${said}`);
}

/** @param {{store: import('../../core/store.js').Store, say: import('../../ui/notice.js').Say}} app @param {number} chain */
export function turnIntoRows({ store, say }, chain) {
  const { doc, result } = store;
  if (result.doc !== doc || !result.plain) return say('The chain was not turned into rows: the document is at fault or still being planned.');
  const plain = result.plain.chains[chain];
  store.edit((present) => intoRows(present, chain, plain));
  sayUndo({ store, say }, doc, 'The chain is a table of rows now. Its joints still count from home.');
}

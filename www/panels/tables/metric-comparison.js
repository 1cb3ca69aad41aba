/**
 * The largest gaps of the motion planned with either metric, side by side. Asked for only while it can be seen, and only
 * after the motion itself is planned.
 *
 * @typedef {import('../../core/types.js').MetricGaps} MetricGaps
 */
import { textOf } from '../../core/document-text.js';
import { drivesJoints } from '../../core/driven.js';
import { element, setText } from '../../ui/dom.js';
import { angle, length } from '../../core/format.js';
import { METRICS } from '../../core/status-words.js';

/** How long the document rests before the question is asked, in milliseconds: not while something is typed or dragged. */
const REST = 500;

/** @param {MetricGaps} gaps @param {string | undefined} unit */
const gapsInWords = ({ translation_gap, rotation_gap }, unit) => `${length(translation_gap, unit)}, ${angle(rotation_gap, 1)}`;

/**
 * @param {import('../../core/store.js').Store} store
 * @param {(text: string, signal: AbortSignal) => Promise<import('../../core/ask.js').Outcome<MetricGaps[]>>} ask
 */
export function createMetricComparison(store, ask) {
  const parts = Object.entries(METRICS).map(([name, words]) => {
    const [mark, gaps] = [element('small'), element('output', {}, '–')];
    return { name, mark, gaps, root: element('div', {}, element('dt', {}, words, ' ', mark), element('dd', {}, gaps)) };
  });
  const note = element('p', { class: 'muted' });
  const intro = element('p', {}, 'This motion in either metric, largest shift and largest turn:');
  const lines = element('dl', {}, ...parts.map((part) => part.root));
  const root = element(
    'div',
    { class: 'comparison waiting', role: 'group', 'aria-label': 'Largest gaps of this motion in either metric' },
    intro,
    lines,
    note,
  );
  /** The document that the numbers are of. @type {unknown} */
  let shown = null;
  let seen = false;
  let asking = new AbortController();
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let resting;

  /** Ends what is under way: its answer would be of another document. */
  function leave() {
    clearTimeout(resting);
    asking.abort();
  }

  function follow() {
    const { motion, doc, fault, trouble } = store.result;
    for (const { name, mark } of parts) setText(mark, name === motion?.report.metric.kind ? 'in use' : '');
    const driven = drivesJoints(motion);
    lines.hidden = intro.hidden = driven;
    if (driven) {
      leave();
      shown = null;
      return setText(note, 'Joints are driven: there is no goal, and no gap in either metric.');
    }
    if (!seen) return;
    if (doc === shown) {
      root.classList.remove('waiting');
      setText(note, '');
      return;
    }
    const planned = motion && doc === store.doc && !fault && !trouble;
    leave();
    root.classList.add('waiting');
    setText(note, planned && motion.partial ? 'Planned only in part; the metrics are not compared.' : shown ? 'The numbers are of the document before.' : '');
    if (planned && !motion.partial) resting = setTimeout(() => compare(doc), REST);
  }

  /** @param {import('../../core/types.js').MechanismDocument} doc */
  async function compare(doc) {
    asking = new AbortController();
    const { signal } = asking;
    root.setAttribute('aria-busy', 'true');
    const both = await ask(textOf(doc), signal);
    if (asking.signal === signal) root.removeAttribute('aria-busy');
    if (signal.aborted || both.is === 'late') return;
    if (both.is !== 'answer') return setText(note, both.message);
    shown = doc;
    root.classList.remove('waiting');
    setText(note, '');
    for (const { name, gaps } of parts) {
      const own = both.value.find(({ metric }) => metric === name);
      setText(gaps, own ? gapsInWords(own, doc.length_unit) : '–');
    }
  }

  new IntersectionObserver((entries) => {
    seen = entries[entries.length - 1].isIntersecting;
    if (seen) follow();
    else leave();
  }).observe(root);
  store.subscribe('document', leave);
  store.subscribe('result', follow);
  return root;
}

/**
 * Asks how a chain is to be copied around an axis, and copies it.
 */
import { isByAxes } from '../../core/by-axes.js';
import { entry } from '../../core/edits.js';
import { lengthUnit } from '../../core/format.js';
import { turnedCopies, whyNotCopied } from '../../core/turned-copies.js';
import { element, setText } from '../../ui/dom.js';
import { formField, openFormDialog } from './form-dialog.js';

/** Chains that a document may have; the planner refuses more. */
const MOST = 24;

/**
 * @param {HTMLElement} root holds the tables
 * @param {import('../../core/store.js').Store} store
 * @param {number} chain
 */
export function openCopiesForm(root, store, chain) {
  const { doc } = store;
  const from = doc.chains[chain];
  const numeric = (/** @type {string} */ value) => element('input', { type: 'text', inputmode: 'decimal', class: 'cell text', autocomplete: 'off', value });
  const most = MOST - doc.chains.length + 1;
  const count = formField('Chains in all', numeric('3'), { note: 'This chain and its copies, at equal angles around the axis.' });
  const axis = element(
    'fieldset',
    { class: 'form-field' },
    element('legend', {}, 'Axis of the fixed frame'),
    ...['x', 'y', 'z'].map((name) => element('label', {}, element('input', { type: 'radio', name: 'axis', value: name, checked: name === 'z' }), ` ${name} `)),
  );
  const point = formField('A point of the axis: x y z', numeric('0 0 0'), { note: `In ${lengthUnit(doc.length_unit)}, in the fixed frame.` });
  const trouble = element('p', { class: 'fault', role: 'alert', hidden: true });

  /** Axes of numbers are turned as they are; else the chain as rows and numbers: of the planned document, if that is this one. */
  const plain = () => (isByAxes(from) && !whyNotCopied(from, undefined) ? from : rows());
  const rows = () => (store.result.doc === doc && store.result.plain?.chains[chain]) || from;

  /** The start values in the document, else those that the planner uses. */
  const start = () => {
    const { motion, doc: planned } = store.result;
    return plain().start ?? (planned === doc ? motion?.report.start[chain] : undefined);
  };

  openFormDialog(root, {
    title: `Duplicate ${from.name || `chain ${chain + 1}`} around an axis`,
    body: [count.root, axis, point.root, trouble],
    apply: 'Duplicate',
    readonly: store.readonly,
    act() {
      const many = entry(count.control.value);
      const place = point.control.value.split(/[\s,;]+/).filter(Boolean).map(entry);
      const chosen = /** @type {HTMLInputElement} */ (axis.querySelector(':checked')).value;
      const goodCount = typeof many === 'number' && Number.isInteger(many) && many >= 2 && many <= most;
      const goodPoint = place.length === 3 && place.every((value) => typeof value === 'number');
      const values = start();
      const why = doc.angles === 'radians' && !isByAxes(plain()) ? 'The angles of this document are in radians, and copies are written in degrees: give its angles in degrees first.' : whyNotCopied(plain(), values);
      count.setFault(goodCount ? '' : `Accepted: a whole number from 2 to ${most}.`);
      point.setFault(goodPoint ? '' : 'Accepted: three numbers, such as 0 0 0.');
      setText(trouble, why);
      trouble.hidden = !why;
      if (!goodCount) count.control.focus();
      else if (!goodPoint) point.control.focus();
      if (!goodCount || !goodPoint || why) return false;
      const around = { count: many, axis: /** @type {'x' | 'y' | 'z'} */ (chosen), point: /** @type {number[]} */ (place) };
      store.edit((present) => turnedCopies(present, chain, around, /** @type {number[]} */ (Array.from(values ?? [])), plain()));
      return true;
    },
  });
  count.control.select();
}

/**
 * Asks how the number of a cell is to be called, and makes a parameter of it; other cells with exactly the same number can
 * take it too.
 */
import { faultText } from '../../core/fault-text.js';
import { plural } from '../../core/format.js';
import { parameterPath } from '../../core/parameter-names.js';
import { freshParameterName, nameFault, nameNumber, sameNumbers } from '../../core/parameters.js';
import { valueAt } from '../../core/path.js';
import { sayUndo } from '../../core/undo.js';
import { element } from '../../ui/dom.js';
import { formField, openFormDialog } from './form-dialog.js';

/**
 * @param {HTMLElement} root holds the tables
 * @param {{store: import('../../core/store.js').Store, say: import('../../ui/notice.js').Say}} app
 * @param {(doc: import('../../core/types.js').MechanismDocument) => Promise<import('../../core/types.js').Fault | null>} check
 * @param {string} path of a cell
 * @param {(path: string) => string} label of a cell, in words
 */
export function openParameterForm(root, { store, say }, check, path, label) {
  const { doc } = store;
  const value = valueAt(doc, path);
  if (typeof value !== 'number') {
    say(`There is no number in this cell (${label(path)}) to make a parameter of.`);
    return;
  }
  const same = sameNumbers(doc, path);
  const name = formField('Name', element('input', { type: 'text', class: 'cell text', autocomplete: 'off', autocapitalize: 'none', spellcheck: 'false', value: freshParameterName(doc) }), {
    note: 'Letters, digits and _, such as base_2. Expressions name the number by it.',
  });
  const also = element('input', { type: 'checkbox' });
  const others = element(
    'div',
    { class: 'form-field', hidden: same.length === 0 },
    element('label', {}, also, ` Also in the ${plural(same.length, 'other cell')} with exactly this number`),
    element('details', {}, element('summary', {}, 'Which'), element('ul', {}, ...same.map((at) => element('li', {}, label(at))))),
  );

  /** @param {string} chosen */
  async function make(chosen) {
    const change = (/** @type {typeof doc} */ present) => nameNumber(present, path, chosen, also.checked ? same : []);
    // The names of functions and units are known to the planner.
    const found = await check(change(store.doc));
    if (found?.where === parameterPath(chosen)) {
      name.setFault(faultText(found));
      name.control.focus();
      return;
    }
    const { doc: former } = store;
    store.edit(change);
    dialog.close();
    sayUndo({ store, say }, former, `The parameter ${chosen} is ${value}, in ${plural(also.checked ? same.length + 1 : 1, 'cell')}.`);
  }

  const { dialog } = openFormDialog(root, {
    title: `A parameter of ${label(path)}: ${value}`,
    body: [name.root, others],
    apply: 'Make the parameter',
    readonly: store.readonly,
    act() {
      const chosen = name.control.value.trim();
      const fault = nameFault(store.doc, chosen);
      name.setFault(fault);
      if (fault) name.control.focus();
      else make(chosen);
      return false;
    },
  });
  name.control.select();
}

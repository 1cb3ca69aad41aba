/**
 * Asks what another unit of length is to mean: the numbers are converted, or only the name changes.
 *
 * @typedef {import('../../core/types.js').MechanismDocument} MechanismDocument
 */
import { entry, setValue } from '../../core/edits.js';
import { length } from '../../core/format.js';
import { convertLengths, factorBetween } from '../../core/units.js';
import { element, setText } from '../../ui/dom.js';
import { onKeys } from '../../ui/keys.js';

/**
 * @param {import('../../core/store.js').Store} store
 * @param {import('../../ui/notice.js').Say} say
 * @param {HTMLInputElement} field in which the unit is typed; something has been typed by now
 * @param {HTMLElement} choice is filled here
 */
export function createUnitChoice(store, say, field, choice) {
  const unit = () => store.doc.length_unit ?? '';
  const wanted = () => field.value.trim();
  const sentence = element('p', { role: 'status' });
  const factor = element('input', { type: 'text', inputmode: 'decimal', class: 'cell', size: 8, autocomplete: 'off' });
  const fault = element('p', { class: 'fault', role: 'alert', hidden: true });
  const [before, behind] = [element('span'), element('span')];
  const convert = element('button', { click: converted }, 'Convert the numbers');
  choice.replaceChildren(
    sentence,
    element('label', {}, before, ' ', factor, ' ', behind),
    fault,
    element('p', { class: 'unit-buttons' }, convert, element('button', { click: renamed }, 'Only rename'), element('button', { click: kept }, 'Leave it')),
  );

  function ask() {
    choice.hidden = wanted() === unit();
    fault.hidden = true;
    if (choice.hidden) return;
    const known = factorBetween(unit(), wanted());
    setText(before, `1 ${unit() || 'of the old unit'} =`);
    setText(behind, wanted() || 'of the new unit');
    factor.value = known === null ? '' : String(known);
    const unknown = known === null ? ' How the two units compare is not known here: give the factor.' : '';
    setText(sentence, `Convert the numbers, or only rename the unit?${unknown}`);
  }

  /** @param {(doc: MechanismDocument) => MechanismDocument} edit */
  function change(edit) {
    choice.hidden = true;
    store.edit(edit);
    field.focus();
  }

  function converted() {
    const times = entry(factor.value);
    if (typeof times !== 'number' || times <= 0) {
      setText(fault, 'Accepted: a number above 0, how many of the new unit are one of the old.');
      fault.hidden = false;
      factor.focus();
      return;
    }
    const name = wanted();
    change((doc) => convertLengths(doc, times, name));
    const metric = store.doc.planner?.metric_length;
    const followed = typeof metric === 'number' ? `the metric length too, which is ${length(metric, name)} now` : 'the metric length is none of them: it follows from the mechanism';
    const parameters = Object.keys(store.doc.parameters ?? {}).length ? ' Parameters stay as they are: expressions of lengths are multiplied instead.' : '';
    say(`The lengths are converted to ${name || 'the new unit'}; ${followed}.${parameters}`);
  }

  function renamed() {
    const name = wanted();
    change((doc) => setValue(doc, 'length_unit', name));
  }

  function kept() {
    field.value = unit();
    choice.hidden = true;
    field.focus();
  }

  field.addEventListener('input', ask);
  for (const part of [field, choice]) {
    onKeys(part, {
      oldValue() {
        if (!choice.hidden) kept();
        return false;
      },
      keepValue({ target }) {
        if (choice.hidden || target instanceof HTMLButtonElement) return false;
        // Enter in the field goes to the question, Enter at the factor answers it.
        if (target === factor) converted();
        else (factor.value ? convert : factor).focus();
      },
    });
  }
  ask();
}

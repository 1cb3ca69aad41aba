/**
 * Asks what another unit of angles is to mean: the numbers are converted, or only read anew.
 */
import { convertAngles, reread } from '../../core/angle-unit.js';
import { element } from '../../ui/dom.js';
import { openFormDialog } from './form-dialog.js';

/**
 * @param {HTMLElement} root holds the tables
 * @param {import('../../core/store.js').Store} store
 * @param {import('../../core/angle-unit.js').AngleUnit} unit
 */
export function openAnglesForm(root, store, unit) {
  const answer = convertAngles(store.doc, unit);
  const why = 'fault' in answer ? answer.fault : '';
  const choice = (/** @type {string} */ value, /** @type {string} */ label, /** @type {string} */ note, /** @type {boolean} */ checked, disabled = false) =>
    element('p', {}, element('label', {}, element('input', { type: 'radio', name: 'how', value, checked, disabled }), ` ${label}`), element('br'), element('small', {}, note));
  const choices = element(
    'fieldset',
    { class: 'form-field' },
    element('legend', {}, 'The numbers'),
    choice('convert', 'Convert the numbers', why || 'The angles stay.', !why, !!why),
    choice('reread', `The numbers are ${unit} already`, 'They stay, and are other angles.', !!why),
  );
  openFormDialog(root, {
    title: `Angles in ${unit}`,
    body: [choices],
    apply: `Use ${unit}`,
    readonly: store.readonly,
    act() {
      const how = /** @type {HTMLInputElement} */ (choices.querySelector(':checked')).value;
      store.edit((doc) => {
        const converted = how === 'convert' ? convertAngles(doc, unit) : { doc: reread(doc, unit) };
        return 'doc' in converted ? converted.doc : doc;
      });
      return true;
    },
  });
}

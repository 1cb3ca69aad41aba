/**
 * The unit of length as a text that can be typed; what another name for it is to mean is asked below the field.
 */
import { element } from '../../ui/dom.js';

/**
 * @param {HTMLElement} panel holds the tables
 * @param {import('../../core/store.js').Store} store
 * @param {import('../../ui/notice.js').Say} say
 * @returns {{field: HTMLElement, choice: HTMLElement}} `choice` is what is asked
 */
export function unitField(panel, store, say) {
  const field = element('input', {
    type: 'text',
    class: 'cell text',
    'data-path': 'length_unit',
    'aria-label': 'unit of length',
    autocomplete: 'off',
    autocapitalize: 'none',
    spellcheck: 'false',
    readonly: store.readonly,
  });
  field.value = store.doc.length_unit ?? '';
  const choice = element('div', { class: 'unit-choice', role: 'group', 'aria-label': 'Another unit of length', hidden: true });
  field.addEventListener('focus', () => field.select());
  const first = async () => {
    field.removeEventListener('input', first);
    try {
      (await import('./unit-choice.js')).createUnitChoice(panel, store, say, field, choice);
    } catch (error) {
      field.value = store.doc.length_unit ?? '';
      field.addEventListener('input', first);
      say(`The unit cannot be changed now: a part of the page could not be loaded (${error instanceof Error ? error.message : error}). Try again.`);
    }
  };
  field.addEventListener('input', first);
  return { field, choice };
}

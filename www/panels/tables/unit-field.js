/**
 * The unit of length as a text that can be typed; what another name for it is to mean is asked below the field.
 */
import { element } from '../../ui/dom.js';

/**
 * @param {import('../../core/store.js').Store} store
 * @param {import('../../ui/notice.js').Say} say
 * @returns {() => {field: HTMLElement, choice: HTMLElement}} follows the document; `choice` is what is asked
 */
export function createUnitField(store, say) {
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
  const choice = element('div', { class: 'unit-choice', role: 'group', 'aria-label': 'Another unit of length', hidden: true });
  field.addEventListener('focus', () => field.select());
  const first = async () => {
    field.removeEventListener('input', first);
    try {
      (await import('./unit-choice.js')).createUnitChoice(store, say, field, choice);
    } catch (error) {
      field.value = store.doc.length_unit ?? '';
      field.addEventListener('input', first);
      say(`The unit cannot be changed now: a part of the page could not be loaded (${error instanceof Error ? error.message : error}). Try again.`);
    }
  };
  field.addEventListener('input', first);
  /** The document's unit that was shown last. @type {string | undefined} */
  let unit;
  return () => {
    const now = store.doc.length_unit ?? '';
    // What is being typed stays, unless the unit is another one now.
    if (now !== unit) {
      unit = field.value = now;
      choice.hidden = true;
    }
    return { field, choice };
  };
}

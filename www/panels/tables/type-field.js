/**
 * The type of a chain as a text that can be typed: Enter applies it, Escape takes it back.
 */
import { setChainType } from '../../core/edits.js';
import { chainType } from '../../core/joint-types.js';
import { readType } from '../../core/type-letters.js';
import { element, setText } from '../../ui/dom.js';

/**
 * @param {HTMLElement} panel holds the tables
 * @param {import('../../core/store.js').Store} store
 * @param {import('../../core/types.js').Defaults} defaults
 * @param {number} chain
 * @returns {{field: HTMLElement, note: HTMLElement}} `note` says what is wrong, or what Enter does; it stands below the field
 */
export function typeField(panel, store, defaults, chain) {
  const type = () => chainType(store.doc.chains[chain] ?? { joints: [] });
  const id = `type-note-${chain}`;
  const note = element('p', { id, class: 'type-note', role: 'status', hidden: true });
  const field = element('input', {
    type: 'text',
    class: 'cell text type',
    size: 6,
    'data-path': `chains[${chain}].type`,
    'aria-label': `type of chain ${chain + 1}, its joints from base to workpiece`,
    'aria-describedby': id,
    autocomplete: 'off',
    autocapitalize: 'characters',
    spellcheck: 'false',
    enterkeyhint: 'done',
    title: 'Joints from base to workpiece, such as RPS; Enter applies',
    readonly: store.readonly,
  });
  field.value = type();

  /** @param {string} text '' for nothing @param {boolean} [fault] */
  function tell(text, fault = false) {
    setText(note, text);
    note.hidden = !text;
    note.classList.toggle('fault', fault);
    if (fault) field.setAttribute('aria-invalid', 'true');
    else field.removeAttribute('aria-invalid');
  }

  function apply() {
    const answer = readType(field.value);
    if ('fault' in answer) return tell(answer.fault, true);
    tell('');
    field.value = answer.letters.join('');
    store.edit((doc) => setChainType(doc, chain, answer.letters, defaults.joints));
    // Another type makes the tables anew, and the focus stays with the field.
    const now = /** @type {HTMLInputElement | null} */ (panel.querySelector(`[data-path="chains[${chain}].type"]`));
    now?.focus();
    now?.select();
  }

  field.addEventListener('focus', () => field.select());
  field.addEventListener('input', () => {
    const changed = field.value.trim().toUpperCase() !== type();
    tell(changed ? `Enter makes this chain ${field.value.trim().toUpperCase() || '…'}; Escape keeps ${type()}.` : '');
  });
  field.addEventListener('keydown', (event) => {
    if (event.key === 'Enter') {
      event.preventDefault();
      apply();
    } else if (event.key === 'Escape') {
      field.value = type();
      tell('');
      field.select();
    }
  });
  return { field, note };
}

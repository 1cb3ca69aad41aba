/**
 * A dialog with fields and a button that applies them, in the tree of the tables; it stays open while something is wrong.
 */
import dialogLook from '../../style/dialog.css?inline';
import formLook from '../../style/forms.css?inline';
import { openDialogIn } from '../../ui/dialog.js';
import { element, setText } from '../../ui/dom.js';
import { wear } from '../../ui/style-sheets.js';

/** What is filled in first; of radio buttons the chosen one. */
const FIRST_FIELD = ':is(input:not([type=radio]), input:checked, select, textarea):enabled';

/**
 * @param {HTMLElement} root holds the tables
 * @param {{title: string, body: (Node | string)[], apply: string, act: () => boolean, readonly?: boolean}} spec `act` applies
 *   what is in the fields and tells whether it could; nothing is applied where edits are refused
 */
export function openFormDialog(root, { title, body, apply, act, readonly }) {
  const tree = /** @type {Document | ShadowRoot} */ (root.getRootNode());
  wear(tree, dialogLook);
  wear(tree, formLook);
  const button = element('button', { type: 'submit', class: 'apply', disabled: readonly }, apply);
  const cancel = element('button', { type: 'button', click: () => dialog.close() }, readonly ? 'Close' : 'Cancel');
  const form = element('form', { class: 'table-form', novalidate: true }, ...body, element('p', { class: 'form-buttons' }, ...(readonly ? [] : [button]), cancel));
  form.addEventListener('submit', (event) => {
    event.preventDefault();
    if (!readonly && act()) dialog.close();
  });
  const dialog = openDialogIn(/** @type {HTMLElement} */ (root.parentElement), title, form);
  // Enter applies what is proposed: the focus is not at the button that closes the dialog.
  /** @type {HTMLElement | null} */ (form.querySelector(FIRST_FIELD))?.focus();
  return { dialog, button };
}

let made = 0;

/**
 * A field with its name, a note, and the fault of what is typed in it.
 * @template {HTMLInputElement | HTMLTextAreaElement} T
 * @param {string} label @param {T} control @param {{note?: string, beside?: Node}} [more]
 */
export function formField(label, control, { note = '', beside } = {}) {
  const id = `form-field-${++made}`;
  const fault = element('p', { class: 'fault', id: `${id}-fault`, role: 'alert', hidden: true });
  control.id = id;
  /** @type {HTMLElement[]} */
  const parts = [element('label', { for: id }, label), element('div', { class: 'form-control' }, control, ...(beside ? [beside] : []))];
  if (note) {
    control.setAttribute('aria-describedby', `${id}-note`);
    parts.push(element('small', { id: `${id}-note` }, note));
  }
  return {
    root: element('div', { class: 'form-field' }, ...parts, fault),
    control,
    /** @param {string} text '' where nothing is wrong */
    setFault(text) {
      setText(fault, text);
      fault.hidden = !text;
      if (text) control.setAttribute('aria-invalid', 'true');
      else control.removeAttribute('aria-invalid');
      const described = [...(note ? [`${id}-note`] : []), ...(text ? [fault.id] : [])].join(' ');
      if (described) control.setAttribute('aria-describedby', described);
      else control.removeAttribute('aria-describedby');
    },
  };
}

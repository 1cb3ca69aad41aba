/**
 * The turn of a frame as quaternion, rotation matrix or roll-pitch-yaw: to be copied from there, or typed and pasted there.
 * What is typed in one form shows in the others at once.
 *
 * @typedef {import('../../core/orientation.js').Form} Form
 */
import { frameAsWritten } from '../../core/document-angles.js';
import { frameNumbers, withoutForms } from '../../core/frame-numbers.js';
import { setValue } from '../../core/edits.js';
import { anglesOf, readTurn, turnOf, writeTurn } from '../../core/orientation.js';
import { valueAt } from '../../core/path.js';
import { element, setText } from '../../ui/dom.js';
import { formField, openFormDialog } from './form-dialog.js';

/** @type {{form: Form, label: string, note: string}[]} */
const FIELDS = [
  { form: 'quaternion', label: 'Quaternion x y z w', note: 'The real part w comes last; some programs write it first.' },
  { form: 'matrix', label: 'Rotation matrix, row by row', note: 'Its columns are the frame’s own axes in the fixed frame.' },
  { form: 'rpy', label: 'Roll, pitch, yaw in degrees', note: 'About the fixed x, then y, then z: Z(yaw) · Y(pitch) · X(roll), as in URDF. This roll is not that of the tables.' },
];

/**
 * @param {HTMLElement} root holds the tables
 * @param {import('../../core/store.js').Store} store
 * @param {string} path of the frame
 * @param {string} name of the frame
 */
export function openTurnForm(root, store, path, name) {
  const before = frameNumbers(store, path) ?? valueAt(store.doc, path);
  let turn = turnOf(before);
  /** The field whose text is no turn. @type {ReturnType<typeof formField> | null} */
  let faulty = null;
  const angles = element('output', { class: 'turn-angles' });
  const told = element('p', { class: 'muted', role: 'status' });

  const fields = FIELDS.map(({ form, label, note }) => {
    const control = form === 'matrix' ? element('textarea', { rows: 3, wrap: 'off' }) : element('input', { type: 'text' });
    for (const [key, value] of Object.entries({ class: 'cell text', autocomplete: 'off', spellcheck: 'false', 'data-form': form })) control.setAttribute(key, value);
    control.readOnly = store.readonly;
    const copy = element('button', { type: 'button', 'aria-label': `Copy ${label}`, click: () => copyText(control, label) }, 'Copy');
    const field = formField(label, control, { note, beside: copy });
    control.addEventListener('input', () => {
      const answer = readTurn(form, control.value);
      faulty = 'fault' in answer ? field : null;
      for (const { setFault } of fields) setFault('');
      if ('fault' in answer) field.setFault(answer.fault);
      else {
        turn = answer.turn;
        show(form);
      }
      button.disabled = faulty !== null;
    });
    return { ...field, form };
  });

  /** @param {Form} [typed] the form that stays as it is typed */
  function show(typed) {
    for (const { form, control } of fields) if (form !== typed) control.value = writeTurn(form, turn);
    const { longitude, latitude, roll } = typed ? anglesOf(turn, before) : { longitude: 0, latitude: 0, roll: 0, ...before };
    setText(angles, `longitude ${longitude}°, latitude ${latitude}°, roll ${roll}°`.replaceAll('-', '−'));
  }

  /** @param {HTMLInputElement | HTMLTextAreaElement} control @param {string} label */
  async function copyText(control, label) {
    const copied = await navigator.clipboard?.writeText(control.value).then(() => true, () => false);
    if (!copied) control.select();
    setText(told, copied ? `${label}: copied.` : `${label} is selected: copy it with Ctrl+C.`);
  }

  const { button } = openFormDialog(root, {
    title: `Turn of ${name}`,
    body: [
      element('p', {}, 'In the tables: ', angles, ', which is Y(longitude) · X(−latitude) · Z(roll).'),
      ...fields.map((field) => field.root),
      told,
    ],
    apply: 'Use this turn',
    readonly: store.readonly,
    act() {
      if (faulty) {
        faulty.control.focus();
        return false;
      }
      store.edit((doc) => setValue(doc, path, { ...withoutForms(valueAt(doc, path) ?? {}), ...frameAsWritten(doc, anglesOf(turn, before)) }));
      return true;
    },
  });
  // Until something is typed there is nothing to use.
  button.disabled = true;
  show();
  fields[0].control.focus();
}

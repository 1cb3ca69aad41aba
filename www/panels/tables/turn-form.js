/**
 * The turn of a frame as quaternion, rotation matrix or roll-pitch-yaw: to be copied from there, or typed and pasted there.
 * What is typed in one form shows in the others at once.
 *
 * @typedef {import('../../core/orientation.js').Form} Form
 */
import { setValue } from '../../core/edits.js';
import { anglesOf, readTurn, writeTurn } from '../../core/orientation.js';
import { valueAt } from '../../core/path.js';
import { ORDERS, ROTATION_FORMS, frameWith, rotationForm, turnOfFrame } from '../../core/rotation-forms.js';
import { withNumbers } from '../../core/typed-number.js';
import { copyText } from '../../ui/copy.js';
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
  const before = withNumbers(store, path) ?? {};
  let turn = turnOfFrame(before, store.doc) ?? [1, 0, 0, 0, 1, 0, 0, 0, 1];
  const kept = element('select', { class: 'cell', 'aria-label': 'form in the document' }, ...Object.entries(ROTATION_FORMS).map(([value, label]) => element('option', { value, selected: value === rotationForm(before) }, label)));
  const order = element('select', { class: 'cell', 'aria-label': 'order of roll, pitch, yaw; capitals: about moving axes' }, ...ORDERS.map((value) => element('option', { value, selected: value === (before.order ?? 'xyz') }, value)));
  const orderNote = element('small', {}, 'Small letters: about the fixed axes, one after the other; capitals: about the moving ones. xyz is URDF’s.');
  const showOrder = () => {
    order.hidden = orderNote.hidden = kept.value !== 'roll_pitch_yaw';
    button.disabled = faulty !== null;
  };
  for (const select of [kept, order]) {
    select.disabled = store.readonly;
    select.addEventListener('change', showOrder);
  }
  /** The field whose text is no turn. @type {ReturnType<typeof formField> | null} */
  let faulty = null;
  const angles = element('output', { class: 'turn-angles' });
  const told = element('p', { class: 'muted', role: 'status' });

  const fields = FIELDS.map(({ form, label, note }) => {
    const control = form === 'matrix' ? element('textarea', { rows: 3, wrap: 'off' }) : element('input', { type: 'text' });
    for (const [key, value] of Object.entries({ class: 'cell text', autocomplete: 'off', spellcheck: 'false', 'data-form': form })) control.setAttribute(key, value);
    control.readOnly = store.readonly;
    const copy = element('button', { type: 'button', 'aria-label': `Copy ${label}`, click: () => copyValue(control, label) }, 'Copy');
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
    const own = rotationForm(before) === 'angles' && store.doc.angles !== 'radians';
    const { longitude, latitude, roll } = typed || !own ? anglesOf(turn, own ? before : undefined) : { longitude: 0, latitude: 0, roll: 0, ...before };
    setText(angles, `longitude ${longitude}°, latitude ${latitude}°, roll ${roll}°`.replaceAll('-', '−'));
  }

  /** @param {HTMLInputElement | HTMLTextAreaElement} control @param {string} label */
  async function copyValue(control, label) {
    const copied = await copyText(control.value);
    if (!copied) control.select();
    setText(told, copied ? `${label}: copied.` : `${label} is selected: copy it with Ctrl+C.`);
  }

  const { button } = openFormDialog(root, {
    title: `Turn of ${name}`,
    body: [
      element('p', {}, 'As angles: ', angles, ', which is Y(longitude) · X(−latitude) · Z(roll).'),
      element('div', { class: 'form-field' }, element('label', {}, 'The document gives it as ', kept, ' ', order), orderNote),
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
      const form = /** @type {import('../../core/rotation-forms.js').RotationForm} */ (kept.value);
      store.edit((doc) => setValue(doc, path, frameWith(valueAt(doc, path), turn, doc, { form, order: order.value })));
      return true;
    },
  });
  // Until something is typed there is nothing to use.
  button.disabled = true;
  order.hidden = orderNote.hidden = kept.value !== 'roll_pitch_yaw';
  show();
  fields[0].control.focus();
}

/**
 * Key frames from a table: pasted, or a file. Shows what the table is taken for, which can be changed, its first poses and
 * the rows that cannot be taken over; then it takes the place of the key frames, or comes behind them.
 *
 * @typedef {import('../../core/types.js').PoseTable} PoseTable
 * @typedef {import('../../core/types.js').PoseTableRequest} PoseTableRequest
 * @typedef {(table: string, request: PoseTableRequest) => Promise<import('../../core/ask.js').Outcome<PoseTable>>} ReadPoses
 */
import { takeKeyFrames } from '../../core/key-frames-from-table.js';
import { lengthUnit, plural, short } from '../../core/format.js';
import { sayUndo } from '../../core/undo.js';
import { element, setText } from '../../ui/dom.js';
import { formField, openFormDialog } from './form-dialog.js';

/** Milliseconds after the last letter before a pasted table is read. */
const PAUSE = 200;
/** Poses that are shown. */
const PREVIEW = 4;
/** Bytes of the largest table that is read. */
const MAX_BYTES = 32_000_000;

const COLUMNS = /** @type {const} */ (['name', 'time', 'x', 'y', 'z', 'longitude', 'latitude', 'roll']);
/** What the form offers, with what is sent: '' leaves it to the table. @type {Record<string, [string, string][]>} */
const CHOICES = {
  convention: [
    ['', 'as the table says'], ['positions', 'none: positions only'], ['longitude_latitude_roll', 'longitude, latitude, roll'], ['quaternion_wxyz', 'quaternion w x y z'],
    ['quaternion_xyzw', 'quaternion x y z w'], ['matrix', 'matrix, row by row'], ['roll_pitch_yaw', 'three angles in an order'],
  ],
  angles: [['', 'as the table says'], ['degrees', 'degrees'], ['radians', 'radians']],
  time: [['', 'as the table says'], ['yes', 'in the table'], ['no', 'none']],
};

/**
 * @param {HTMLElement} root holds the tables
 * @param {{store: import('../../core/store.js').Store, say: import('../../ui/notice.js').Say}} app
 * @param {ReadPoses} readPoses
 */
export function openPoseTable(root, { store, say }, readPoses) {
  /** Of a file; a pasted one is in its field. */
  let fileText = '';
  /** @type {PoseTable | null} */
  let read = null;
  let asked = 0;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let waiting;

  const chooser = element('input', { type: 'file', class: 'cell text', accept: '.csv,.tsv,.txt,text/csv,text/plain', change: takeFile });
  const file = formField('A file', chooser, { note: 'CSV, or text with tabs, semicolons or blanks between the columns; a file can be dropped here too.' });
  const pasted = element('textarea', { rows: 5, wrap: 'off', class: 'cell text', spellcheck: 'false', placeholder: 'x y z qw qx qy qz\n0.1 0 0.4 1 0 0 0', input: later });
  const paste = formField('Or its cells, pasted', pasted);
  const choice = (/** @type {string} */ name) => element('select', { class: 'cell', change: ask }, ...CHOICES[name].map(([value, text]) => element('option', { value }, text)));
  const [convention, angles, time] = ['convention', 'angles', 'time'].map(choice);
  const order = element('input', { type: 'text', class: 'cell text', value: 'xyz', autocomplete: 'off', spellcheck: 'false', input: later });
  const scale = element('input', { type: 'text', inputmode: 'decimal', class: 'cell text', value: '1', autocomplete: 'off', input: later });
  const how = [
    /** @type {const} */ (['Rotations', convention, '']), ['Order of the angles', order, 'As xyz about fixed axes (URDF), ZYX about moving ones.'], ['Angles', angles, ''],
    ['Times', time, ''], ['Factor of lengths', scale, `From the table’s unit to ${lengthUnit(store.doc.length_unit)}: 0.001 from mm to m.`],
  ].map(([label, control, note]) => formField(/** @type {string} */ (label), /** @type {any} */ (control), { note: /** @type {string} */ (note) }));
  const orderField = how[1];
  const scaleField = how[4];
  const place = element('fieldset', { class: 'form-field' }, element('legend', {}, 'The poses'),
    ...[['replace', 'take the place of the key frames'], ['append', 'come behind them']].map(([value, text]) =>
      element('label', {}, element('input', { type: 'radio', name: 'place', value, checked: value === 'replace' }), ` ${text} `)));
  const told = element('p', { role: 'status' });
  const trouble = element('p', { class: 'fault', role: 'alert', hidden: true });
  const preview = element('div', { class: 'scroller', tabindex: 0, role: 'region', 'aria-label': 'The first poses' });
  const skipped = element('details', { hidden: true });

  /** @returns {PoseTableRequest} */
  const request = () => ({
    ...(convention.value && { convention: /** @type {any} */ (convention.value) }),
    ...(convention.value === 'roll_pitch_yaw' && { order: order.value.trim() }),
    ...(angles.value && { angles: /** @type {any} */ (angles.value) }),
    ...(time.value && { time: time.value === 'yes' }),
    scale: Number(scale.value.replace(',', '.')),
  });

  function later() {
    clearTimeout(waiting);
    waiting = setTimeout(ask, PAUSE);
  }

  /** @param {File | undefined} chosen */
  async function open(chosen) {
    if (!chosen) return;
    pasted.value = '';
    const large = chosen.size > MAX_BYTES;
    fileText = large ? '' : await chosen.text();
    file.setFault(large ? `It has ${(chosen.size / 1e6).toFixed(1)} MB. Accepted: a table of at most ${MAX_BYTES / 1e6} MB.` : '');
    if (!large) await ask();
  }

  function takeFile() {
    open(chooser.files?.[0]);
  }

  async function ask() {
    clearTimeout(waiting);
    const mine = ++asked;
    const text = pasted.value || fileText;
    orderField.root.hidden = convention.value !== 'roll_pitch_yaw';
    const factor = request().scale;
    scaleField.setFault(factor && factor > 0 && Number.isFinite(factor) ? '' : 'Accepted: a number above 0, such as 0.001.');
    if (!text.trim() || !(factor && factor > 0)) return show(null);
    setText(told, 'Reading …');
    const answer = await readPoses(text, request());
    if (mine !== asked || answer.is === 'late') return;
    show(answer.is === 'answer' ? answer.value : null, answer.is === 'answer' ? '' : answer.message);
  }

  /** @param {PoseTable | null} table @param {string} [why] there is none */
  function show(table, why = '') {
    read = table;
    button.disabled = !table || store.readonly;
    setText(trouble, why);
    trouble.hidden = !why;
    setText(told, table ? understood(table) : '');
    preview.replaceChildren(...(table ? [previewOf(table)] : []));
    skipped.hidden = !table?.skipped_count;
    const more = (table?.skipped_count ?? 0) - (table?.skipped.length ?? 0);
    skipped.replaceChildren(
      element('summary', {}, `${plural(table?.skipped_count ?? 0, 'row')} cannot be taken over`),
      element('ul', {}, ...(table?.skipped ?? []).map(({ row, what, accepted }) => element('li', {}, `Row ${row}: ${what}. Accepted: ${accepted}.`)), ...(more ? [element('li', {}, `${more} more.`)] : [])),
    );
  }

  const { button, dialog } = openFormDialog(root, {
    title: 'Key frames from a table',
    body: [file.root, paste.root, element('div', { class: 'form-pair' }, ...how.map((field) => field.root)), told, trouble, preview, skipped, place],
    apply: 'Take over',
    readonly: store.readonly,
    act() {
      // What was typed last is read first.
      if (!read) return false;
      const table = read;
      const append = /** @type {HTMLInputElement} */ (place.querySelector(':checked')).value === 'append';
      const { doc: former } = store;
      store.edit((doc) => takeKeyFrames(doc, table.key_frames, append));
      const { frames } = store.doc.motion;
      const raised = frames !== former.motion.frames ? ` The motion has ${frames} frames now, one for each of them.` : '';
      sayUndo({ store, say }, former, `${plural(table.key_frames.length, 'key frame')} ${append ? 'added' : 'taken over'}.${raised}`);
      return true;
    },
  });
  orderField.root.hidden = true;
  button.disabled = true;
  dialog.addEventListener('dragover', (event) => event.preventDefault());
  dialog.addEventListener('drop', (event) => {
    event.preventDefault();
    event.stopPropagation();
    open(event.dataTransfer?.files[0]);
  });
}

/** What a table was taken for, in words. @param {PoseTable} table */
function understood({ key_frames: keys, understood: { separator, header, columns, scale, assumed } }) {
  const parted = { tab: 'tabs', semicolon: 'semicolons', comma: 'commas', blanks: 'blanks' }[separator];
  const list = columns.map(({ heading, role }) => (role ? role : `${heading || 'a column'} (not read)`)).join(', ');
  const factor = scale === 1 ? '' : ` Lengths times ${short(scale, 9)}.`;
  return [`${plural(keys.length, 'pose')}. ${header ? 'With headings' : 'No headings'}, parted by ${parted}: ${list}.${factor}`, ...assumed].join(' ');
}

/** The first poses, as the document has them. @param {PoseTable} table */
function previewOf({ key_frames: keys }) {
  const shown = keys.slice(0, PREVIEW);
  const columns = COLUMNS.filter((column) => shown.some((key) => key[column] !== undefined && key[column] !== ''));
  const cell = (/** @type {string | number | undefined} */ value) => element('td', {}, typeof value === 'number' ? short(value) : (value ?? ''));
  return element('table', { class: 'plain' },
    element('caption', { class: 'sr' }, 'The first poses, in the document’s unit and degrees'),
    element('thead', {}, element('tr', {}, ...columns.map((column) => element('th', { scope: 'col' }, column)))),
    element('tbody', {}, ...shown.map((key) => element('tr', {}, ...columns.map((column) => cell(key[column]))))));
}

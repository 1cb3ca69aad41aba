/**
 * The form of one maker: its numbers beside a drawing of them, checked while they are typed. Rust makes the mechanism and says
 * what is at fault.
 *
 * @typedef {import('../../core/types.js').Maker} Maker
 */
import { ask } from '../../core/ask.js';
import { faultText } from '../../core/fault-text.js';
import { plural } from '../../core/format.js';
import { element, setText } from '../../ui/dom.js';
import { makerDrawing } from './maker-drawing.js';
import { UNITS, defaultTexts, givenInputs, labelsOf, meaningOf } from './maker-words.js';

let made = 0;

/**
 * @param {Pick<import('../../element/workbench.js').App, 'planner' | 'open'>} app
 * @param {Maker} maker
 * @param {() => void} done is called when the mechanism is shown
 * @returns {HTMLFormElement}
 */
export function makerForm({ planner, open }, maker, done) {
  const id = `maker-${++made}`;
  let unit = maker.unit;

  const rows = maker.inputs.map((input) => {
    const hint = element('small', { id: `${id}-${input.name}-hint` }, meaningOf(input, unit));
    const standard = defaultTexts(maker, input, unit);
    const labels = labelsOf(input);
    const cells = labels.map((label, index) =>
      element('input', { class: 'cell text', id: `${id}-${label}`, name: label, value: standard[index], inputmode: input.is === 'list' ? 'text' : 'decimal', autocomplete: 'off', spellcheck: 'false', 'aria-describedby': hint.id, input: check }),
    );
    const single = labels.length === 1 && labels[0] === input.name;
    const root = single
      ? element('div', { class: 'field' }, element('label', { for: cells[0].id }, input.name), cells[0], hint)
      : element('div', { class: 'field', role: 'group', 'aria-label': input.name }, element('span', { 'aria-hidden': 'true' }, input.name), element('div', { class: 'maker-cells' }, ...labels.map((label, index) => element('label', {}, label, cells[index]))), hint);
    return { input, cells, hint, root };
  });
  const units = element('select', { class: 'cell', id: `${id}-unit`, change: changeUnit }, ...UNITS.map((name) => element('option', { value: name, selected: name === unit }, name)));
  const note = element('div', { class: 'fault', id: `${id}-fault`, 'aria-live': 'polite', hidden: true });
  const said = element('p', { class: 'said', role: 'status' });
  const fields = element('div', { class: 'maker-fields' }, ...rows.map(({ root }) => root), element('div', { class: 'field' }, element('label', { for: units.id }, 'Unit'), units));
  const form = element(
    'form',
    { class: 'new-linkage maker-form', novalidate: true, 'aria-label': maker.title, submit },
    element('h3', {}, maker.title, ' ', element('small', {}, plural(maker.mobility, 'freedom'))),
    element('div', { class: 'maker-numbers' }, makerDrawing(maker), fields),
    element('p', {}, element('button', { type: 'submit' }, 'Make')),
    said,
    element('p', { class: 'maker-about' }, maker.about),
    element('p', { class: 'muted maker-source' }, `Source: ${maker.source}`),
  );

  /** Numbers that were not touched are the same lengths in the new unit; what was typed stays as it was typed. */
  function changeUnit() {
    for (const { input, cells, hint } of rows) {
      const [former, next] = [unit, units.value].map((name) => defaultTexts(maker, input, name));
      cells.forEach((cell, index) => {
        if (cell.value.trim() === former[index]) cell.value = next[index];
      });
      setText(hint, meaningOf(input, units.value));
    }
    unit = units.value;
    check();
  }

  /** @param {import('../../core/types.js').Fault | null} fault */
  function show(fault) {
    const at = fault && rows.find(({ input }) => input.name === fault.where);
    for (const row of rows) {
      for (const cell of row.cells) {
        if (row === at) cell.setAttribute('aria-invalid', 'true');
        else cell.removeAttribute('aria-invalid');
        cell.setAttribute('aria-describedby', row === at ? `${note.id} ${row.hint.id}` : row.hint.id);
      }
    }
    note.hidden = !fault;
    setText(note, fault ? faultText(fault) : '');
    (at ? at.root : fields).append(note);
  }

  /** The document, or null: what is at fault is shown then. @returns {Promise<string | null>} */
  async function make() {
    const typed = new Map(rows.map(({ input, cells }) => [input.name, cells.map(({ value }) => value)]));
    const wanted = await ask(() => planner.makeNamed(maker.name, givenInputs(maker, typed, unit), unit), 'make the mechanism');
    if (wanted.is === 'late') return null;
    if (wanted.is !== 'trouble') show(wanted.is === 'fault' ? wanted.fault : null);
    setText(said, wanted.is === 'trouble' ? `The mechanism was not made. ${wanted.message}` : '');
    return wanted.is === 'answer' ? wanted.value : null;
  }

  function check() {
    make();
  }

  /** @param {SubmitEvent} event */
  async function submit(event) {
    event.preventDefault();
    const text = await make();
    if (!text) return /** @type {HTMLElement | null} */ (form.querySelector('[aria-invalid]'))?.focus();
    if (await open(text)) done();
  }

  return form;
}

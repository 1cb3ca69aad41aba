/**
 * The form for a new linkage: its type and a few sizes, checked while they are typed. Rust makes the linkage and says what
 * is at fault.
 *
 * @typedef {import('../../pkg/synthetica.js').MakeRequest} MakeRequest
 */
import { ask } from '../../core/ask.js';
import { faultText } from '../../core/fault-text.js';
import { element } from '../../ui/dom.js';
import { sizeOf } from './size-of.js';

/** What the form has at first, and after that what was made last: a linkage is often made once more with another type. */
const given = { type: '3-PRS', base_radius: '350', platform_radius: '150', length: '600', by: 'leg_length', length_unit: 'mm' };

const BY = /** @type {const} */ ([
  ['leg_length', 'Leg length', 'From the joint at its base to the joint at its end, at the start; of a leg on a slider, from the joint on the slider.'],
  ['height', 'Height', 'Of the workpiece above the base, at the start.'],
]);

let made = 0;

/**
 * @param {Pick<import('../../element/workbench.js').App, 'planner' | 'open'>} app
 * @param {{chain?: {type: string, legs: number}, type?: string, done: () => void}} options `chain`: legs of this type, whose
 *   number is chosen; else the type is typed, and is `type` at first. `done` is called when the linkage is shown
 * @returns {HTMLFormElement}
 */
export function newLinkageForm({ planner, open }, { chain, type: first, done }) {
  const id = `new-linkage-${++made}`;

  /** @param {string} name @param {string} label @param {string} value @param {string} hint @param {Record<string, string | number>} [attributes] */
  function field(name, label, value, hint, attributes = {}) {
    const meaning = hint ? element('small', { id: `${id}-${name}-hint` }, hint) : null;
    const input = element('input', { class: 'cell text', id: `${id}-${name}`, name, value, autocomplete: 'off', spellcheck: 'false', input: check, ...attributes });
    if (hint) input.setAttribute('aria-describedby', `${id}-${name}-hint`);
    const caption = element('label', { for: input.id }, label);
    return { input, caption, row: element('div', { class: 'field' }, caption, input, ...(meaning ? [meaning] : [])), meaning };
  }

  const number = { inputmode: 'decimal' };
  const type = chain
    ? field('type', `Legs ${chain.type}`, String(chain.legs), '', { type: 'number', min: 1, max: 24, step: 1, inputmode: 'numeric' })
    : field('type', 'Type', first ?? given.type, 'Joints of a leg from base to workpiece, with the number of legs: 3-PRS, 3 RPS, RPS + 2TS.', { autocapitalize: 'characters' });
  const base = field('base_radius', 'Base radius', given.base_radius, 'Of the circle on which the legs stand.', number);
  const platform = field('platform_radius', 'Platform radius', given.platform_radius, 'Of the circle on which they hold the workpiece.', number);
  const length = field('length', '', given.length, ' ', number);
  const unit = field('length_unit', 'Unit', given.length_unit, '', { maxlength: 16, size: 6 });
  const by = element('select', { name: 'by', class: 'cell', 'aria-label': 'Leg length or height', change: chooseLength }, ...BY.map(([value, label]) => element('option', { value, selected: value === given.by }, label)));
  length.caption.replaceChildren(by);

  const note = element('div', { class: 'fault', id: `${id}-fault`, 'aria-live': 'polite', hidden: true });
  const said = element('p', { class: 'said', role: 'status' });
  const form = element(
    'form',
    { class: 'new-linkage', novalidate: true, submit },
    ...[type, base, platform, length, unit].map(({ row }) => row),
    element('p', {}, element('button', { type: 'submit' }, 'Make')),
    said,
  );
  /** The field of a fault's place. @param {string} where */
  const fieldAt = (where) => ({ type, base_radius: base, platform_radius: platform, leg_length: length, height: length, length_unit: unit })[where];

  function chooseLength() {
    const [, label, hint] = BY.find(([value]) => value === by.value) ?? BY[0];
    length.input.setAttribute('aria-label', label);
    if (length.meaning) length.meaning.textContent = hint;
    check();
  }

  /** @returns {Record<string, unknown>} a MakeRequest, if nothing is at fault */
  const request = () => ({
    type: chain ? `${type.input.value.trim()}-${chain.type}` : type.input.value,
    base_radius: sizeOf(base.input.value),
    platform_radius: sizeOf(platform.input.value),
    [by.value]: sizeOf(length.input.value),
    length_unit: unit.input.value.trim(),
  });

  /** @param {import('../../core/types.js').Fault | null} fault */
  function show(fault) {
    const at = fault && fieldAt(fault.where);
    for (const { input, meaning } of [type, base, platform, length, unit]) {
      const marked = at?.input === input;
      if (marked) input.setAttribute('aria-invalid', 'true');
      else input.removeAttribute('aria-invalid');
      const described = [marked && note.id, meaning?.id].filter(Boolean).join(' ');
      if (described) input.setAttribute('aria-describedby', described);
      else input.removeAttribute('aria-describedby');
    }
    note.hidden = !fault;
    // A document may leave a size out; here all of them are asked for.
    note.textContent = fault ? faultText({ ...fault, optional: undefined }) : '';
    if (at) at.row.append(note);
    else form.append(note);
  }

  /** The document, or null: what is at fault is shown then. @returns {Promise<string | null>} */
  async function make() {
    const wanted = await ask(() => planner.make(JSON.stringify(request())), 'make the linkage');
    if (wanted.is === 'late') return null;
    if (wanted.is !== 'trouble') show(wanted.is === 'fault' ? wanted.fault : null);
    said.textContent = wanted.is === 'trouble' ? `The linkage was not made. ${wanted.message}` : '';
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
    if (!chain) given.type = type.input.value;
    Object.assign(given, { base_radius: base.input.value, platform_radius: platform.input.value, length: length.input.value, by: by.value, length_unit: unit.input.value });
    if (await open(text)) done();
  }

  chooseLength();
  return form;
}

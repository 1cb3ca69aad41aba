/**
 * The teach panel: a slider and a number for every joint variable. Moving one drives that joint; the loops stay
 * closed and the other joints follow, in the view and in the other sliders.
 *
 * @typedef {import('./drive.js').Variable} Variable
 * @typedef {{variable: Variable, slider: HTMLInputElement, field: HTMLInputElement, note: HTMLElement}} Row
 */
import { element, focusBeside, setText } from '../../ui/dom.js';
import { entry } from '../../core/edits.js';
import { ANGLE_DECIMALS, lengthUnit, short } from '../../core/format.js';
import { groupAt, shown } from '../../core/shown.js';
import { driveShown, readable, variablesOf } from './drive.js';
import { postureActions } from '../../view3d/hand/posture-actions.js';

/** Steps of a slider over its range: finer than a screen's pixels. */
const STEPS = 2000;

/** @param {import('../../element/workbench.js').App} app @param {HTMLElement} panel */
export function createTeach(app, panel) {
  const { store, player } = app;
  /** @type {Row[]} */
  let rows = [];
  let shape = '';

  const actions = element(
    'p',
    { class: 'teach-actions' },
    ...postureActions(app),
    element('button', { class: 'link', title: 'Show the planned frame again', click: () => store.setView({ posture: null }) }, 'Back to the motion'),
  );
  const intro = element('p', { class: 'meaning' }, 'Move one joint by hand: it is driven, every loop stays closed, and the other joints follow by the least motion.');
  const body = element('div', {});
  panel.replaceChildren(element('h2', {}, 'Joints'), intro, actions, body);

  const unitOf = (/** @type {Variable} */ { turns }) => (turns ? '°' : lengthUnit(store.result.doc?.length_unit));
  const text = (/** @type {Variable} */ variable, /** @type {number} */ value) => short(value, variable.turns ? ANGLE_DECIMALS : undefined);

  /** As a number is typed. @param {string} shown */
  const editable = (shown) => shown.replace('−', '-');

  /** @param {Row} row @param {number} value */
  async function drive(row, value) {
    player.pause();
    const why = await driveShown(app, row.variable, value);
    if (why === null) return;
    for (const other of rows) if (other !== row) say(other, '');
    say(row, why);
    show();
  }

  /** @param {Row} row @param {string} why */
  function say({ field, note }, why) {
    note.hidden = why === '';
    setText(note, why);
    if (why) field.setAttribute('aria-describedby', note.id);
    else field.removeAttribute('aria-describedby');
  }

  /** What was typed: driven to if it can be asked for, else explained. @param {Row} row */
  function typed(row) {
    const { variable, field } = row;
    const value = entry(field.value);
    const [low, high] = [variable.min ?? -Infinity, variable.max ?? Infinity];
    const unit = unitOf(variable);
    field.removeAttribute('aria-invalid');
    // Left as it was: the short number is no wish to go to it.
    if (field.value === editable(field.dataset.shown ?? '')) return say(row, '');
    if (typeof value === 'number' && value >= low && value <= high) return drive(row, value);
    field.setAttribute('aria-invalid', 'true');
    const bounds = [low, high].every(Number.isFinite) ? ` from ${text(variable, low)} to ${text(variable, high)}` : low > -Infinity ? ` of at least ${text(variable, low)}` : high < Infinity ? ` of at most ${text(variable, high)}` : '';
    say(row, `${variable.name} takes a number${bounds} (${unit === '°' ? 'degrees' : unit}), not “${field.value.trim()}”.`);
  }

  /** @param {Variable} variable @returns {HTMLElement} */
  function makeRow(variable) {
    const unit = unitOf(variable);
    const [low, high] = variable.range;
    const name = `chain ${variable.chain + 1}, ${variable.name}`;
    const in_ = variable.turns ? 'degrees' : unit;
    const slider = element('input', { type: 'range', min: low, max: high, step: (high - low) / STEPS || 1, 'aria-label': `${name} in ${in_}` });
    const field = element('input', { type: 'text', inputmode: 'decimal', autocomplete: 'off', class: 'cell', 'aria-label': `${name}, number in ${in_}` });
    const note = element('p', { class: 'fault', role: 'status', hidden: true, id: `teach-note-${variable.index}` });
    /** @type {Row} */
    const row = { variable, slider, field, note };
    rows.push(row);
    slider.addEventListener('input', () => drive(row, Number(slider.value)));
    field.addEventListener('focus', () => field.select());
    field.addEventListener('change', () => typed(row));
    field.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape') return;
      field.removeAttribute('aria-invalid');
      say(row, '');
      field.value = editable(field.dataset.shown ?? '');
      field.select();
    });
    const end = (/** @type {number} */ value, /** @type {number | null} */ limit) =>
      element('span', limit === null ? {} : { class: 'limit', title: 'joint limit' }, text(variable, value));
    return element(
      'div',
      { class: 'teach-row', 'data-variable': variable.index },
      element('span', { class: 'teach-name' }, element('var', {}, variable.name)),
      element('div', { class: 'teach-slider' }, slider, element('div', { class: 'teach-ends', 'aria-hidden': 'true' }, end(low, variable.min), end(high, variable.max))),
      element('span', { class: 'teach-number' }, field, element('small', {}, unit)),
      note,
    );
  }

  function build() {
    const { motion, doc } = store.result;
    if (!motion || !doc) return;
    const variables = variablesOf(motion, doc);
    const next = JSON.stringify([variables, motion.report.chains.map(({ name, type }) => [name, type]), doc.length_unit]);
    if (next === shape) return;
    shape = next;
    rows = [];
    body.replaceChildren(
      ...motion.report.chains.map(({ name, type }, chain) =>
        element(
          'section',
          { class: 'chain', 'data-chain': chain },
          element('header', {}, element('h3', {}, name || `chain ${chain + 1}`, element('span', { class: 'type' }, type))),
          ...variables.filter((variable) => variable.chain === chain).map(makeRow),
        ),
      ),
    );
  }

  function show() {
    if (!panel.classList.contains('shown')) return;
    build();
    const now = shown(store);
    if (!now) return;
    const values = groupAt(now.joints, now);
    for (const { variable, slider, field } of rows) {
      const value = readable(variable, values[variable.index]);
      slider.value = String(value);
      const words = text(variable, value);
      slider.setAttribute('aria-valuetext', `${words} ${unitOf(variable)}`);
      if (field.dataset.shown === words) continue;
      field.dataset.shown = words;
      if (focusBeside(field) !== field || field.getAttribute('aria-invalid') === null) field.value = editable(words);
    }
    actions.classList.toggle('away', !store.view.posture);
    if (!store.view.posture) for (const row of rows) if (!row.field.hasAttribute('aria-invalid')) say(row, '');
  }
  store.subscribe('result', show);
  store.subscribe('view', show);
  // A panel that is not shown is not kept up to date: it catches up when it comes.
  new MutationObserver(show).observe(panel, { attributeFilter: ['class'] });
  show();
}

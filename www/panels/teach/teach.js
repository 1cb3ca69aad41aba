/**
 * The teach panel: a slider and a number for every joint variable. Moving one drives that joint; the loops stay
 * closed and the other joints follow, in the view and in the other sliders.
 *
 * @typedef {import('./drive.js').Variable} Variable
 * @typedef {{text: string, stage: 'typing' | 'driven' | 'refused'}} Entry what was typed into a number's field and is not its value yet
 */
import { chainName } from '../../core/chain-name.js';
import { driverIndex } from '../../core/driven.js';
import { element } from '../../ui/dom.js';
import { withPart } from '../../ui/lazy.js';
import { entry } from '../../core/edits.js';
import { html, live, nothing, render } from '../../ui/render.js';
import { ANGLE_DECIMALS, lengthUnit, short } from '../../core/format.js';
import { groupAt, shown } from '../../core/shown.js';
import { wear } from '../../ui/style-sheets.js';
import look from '../../style/teach.css?inline';
import { driveShown, readable, variablesOf } from './drive.js';
import { postureActions } from '../../view3d/hand/posture-actions.js';

/** Steps of a slider over its range: finer than a screen's pixels. */
const STEPS = 2000;

/** @param {import('../../element/workbench.js').App} app @param {HTMLElement} panel */
export function createTeach(app, panel) {
  const { store, player } = app;
  wear(app.root, look);
  /** The variables of a motion. @type {{motion: unknown, variables: Variable[]}} */
  let of = { motion: null, variables: [] };
  /** By the variable's index. @type {Map<number, Entry>} */
  const entries = new Map();
  /** Why the last drive did not get to where it was asked to. */
  let obstacle = { index: -1, why: '' };

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
  const unitInWords = (/** @type {Variable} */ variable) => (variable.turns ? 'degrees' : unitOf(variable));
  const text = (/** @type {Variable} */ variable, /** @type {number} */ value) => short(value, variable.turns ? ANGLE_DECIMALS : undefined);
  /** As a number is typed. @param {string} words */
  const editable = (words) => words.replace('−', '-');

  /** @param {Variable} variable @param {number} value */
  async function drive(variable, value) {
    const { index } = variable;
    const asked = entries.get(index);
    player.pause();
    const why = await driveShown(app, variable, value);
    if (why !== null) obstacle = { index, why };
    // What has been typed since is not the drive's.
    if (asked && entries.get(index) === asked) entries.delete(index);
    show();
  }

  /** What was typed: driven to if it can be asked for, else explained. @param {Variable} variable @param {string} typed @param {string} words what is shown */
  function take(variable, typed, words) {
    const { index } = variable;
    const value = entry(typed);
    if (obstacle.index === index) obstacle = { index: -1, why: '' };
    const good = typeof value === 'number' && value >= (variable.min ?? -Infinity) && value <= (variable.max ?? Infinity);
    // Left as it was: the short number is no wish to go to it.
    if (typed === editable(words)) entries.delete(index);
    else entries.set(index, { text: typed, stage: good ? 'driven' : 'refused' });
    if (entries.get(index)?.stage === 'driven') drive(variable, Number(value));
    show();
  }

  /** @param {Variable} variable @param {string} typed */
  function refusal(variable, typed) {
    const { min, max, name } = variable;
    const [from, to] = [min, max].map((bound) => (bound === null ? '' : text(variable, bound)));
    const bounds = from && to ? ` from ${from} to ${to}` : from ? ` of at least ${from}` : to ? ` of at most ${to}` : '';
    return `${name} takes a number${bounds} (${unitInWords(variable)}), not “${typed.trim()}”.`;
  }

  /** Makes the motion drive this joint. @param {Variable} variable */
  function driveButton({ chain, joint, freedom, name }) {
    if (store.readonly) return nothing;
    const driven = driverIndex(store.doc, { chain, joint, freedom }) >= 0;
    const load = () => withPart(app, 'Driven joints', () => import('../../core/driver-edits.js'), (edits) => edits.driveJoint(app, { chain, joint, freedom }));
    const words = driven ? 'Driven in the motion' : 'Drive this joint';
    return html`<button class="link teach-drive" ?disabled=${driven} aria-label=${`${words}: ${name} of ${chainName(store.doc.chains[chain], chain)}`} @click=${load}>${words}</button>`;
  }

  /** @param {Variable} variable @param {number} value */
  function row(variable, value) {
    const { index, chain, name, range, min, max } = variable;
    const [low, high] = range;
    const words = text(variable, value);
    const unit = unitOf(variable);
    const label = `${chainName(store.result.doc?.chains[chain], chain)}, ${name}`;
    const typed = entries.get(index);
    const refused = typed?.stage === 'refused';
    const why = refused ? refusal(variable, typed.text) : obstacle.index === index ? obstacle.why : '';
    const end = (/** @type {number} */ at, /** @type {number | null} */ limit) =>
      limit === null ? html`<span>${text(variable, at)}</span>` : html`<span class="limit" title="joint limit">${text(variable, at)}</span>`;
    const input = (/** @type {Event} */ { target }) => /** @type {HTMLInputElement} */ (target);
    const typing = (/** @type {Event} */ event) => entries.set(index, { text: input(event).value, stage: 'typing' });
    const leave = () => {
      // Typed and taken back by hand: no change for the browser, and no wish.
      if (entries.get(index)?.stage === 'typing') entries.delete(index);
      show();
    };
    const press = (/** @type {KeyboardEvent} */ event) => {
      if (event.key !== 'Escape') return;
      entries.delete(index);
      if (obstacle.index === index) obstacle = { index: -1, why: '' };
      show();
      input(event).select();
    };
    return html`<div class="teach-row" data-variable=${index}>
      <span class="teach-name"><var>${name}</var></span>
      <div class="teach-slider">
        <input type="range" min=${low} max=${high} step=${(high - low) / STEPS || 1} aria-label="${label} in ${unitInWords(variable)}" aria-valuetext="${words} ${unit}"
          .value=${live(String(value))} @input=${(/** @type {Event} */ event) => drive(variable, Number(input(event).value))} />
        <div class="teach-ends" aria-hidden="true">${end(low, min)}${end(high, max)}</div>
      </div>
      <span class="teach-number">
        <input type="text" inputmode="decimal" autocomplete="off" class="cell" aria-label="${label}, number in ${unitInWords(variable)}"
          aria-invalid=${refused ? 'true' : nothing} aria-describedby=${why ? `teach-note-${index}` : nothing} .value=${live(typed?.text ?? editable(words))}
          @focus=${(/** @type {Event} */ event) => input(event).select()} @input=${typing} @blur=${leave} @keydown=${press}
          @change=${(/** @type {Event} */ event) => take(variable, input(event).value, words)} />
        <small>${unit}</small>
      </span>
      ${driveButton(variable)}
      <p class="fault" role="status" id="teach-note-${index}" ?hidden=${!why}>${why}</p>
    </div>`;
  }

  function show() {
    const { motion, plain: doc } = store.result;
    if (!panel.classList.contains('shown') || !motion || !doc) return;
    if (of.motion !== motion) of = { motion, variables: variablesOf(motion, doc) };
    const now = shown(store);
    if (!now) return;
    const { posture } = store.view;
    if (!posture) obstacle = { index: -1, why: '' };
    const values = groupAt(now.joints, now);
    const section = (/** @type {string} */ name, /** @type {string} */ type, /** @type {number} */ chain) => html`<section class="chain" data-chain=${chain}>
      <header><h3>${chainName({ name }, chain)}<span class="type">${type}</span></h3></header>
      ${of.variables.filter((variable) => variable.chain === chain).map((variable) => row(variable, readable(variable, values[variable.index])))}
    </section>`;
    render(motion.report.chains.map(({ name, type }, chain) => section(name, type, chain)), body);
    actions.classList.toggle('away', !posture);
  }
  store.subscribe('document', () => {
    // What was typed for another document's joints is no entry for these.
    entries.clear();
  });
  store.subscribe('result', show);
  store.subscribe('view', show);
  // A panel that is not shown is not kept up to date: it catches up when it comes.
  new MutationObserver(show).observe(panel, { attributeFilter: ['class'] });
  show();
}

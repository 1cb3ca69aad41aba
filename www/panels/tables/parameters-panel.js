/**
 * The document's parameters as a table: name, value or expression, and a slider for each that is given as a number.
 */
import look from '../../style/parameters.css?inline';
import { setValue } from '../../core/edits.js';
import { expressionValue } from '../../core/expression-values.js';
import { faultText } from '../../core/fault-text.js';
import { plural, short } from '../../core/format.js';
import { parameterPath, parametersOf } from '../../core/parameter-names.js';
import * as edits from '../../core/parameters.js';
import { createRanges } from '../../core/slider-range.js';
import { valueAt } from '../../core/path.js';
import { sayUndo } from '../../core/undo.js';
import { attachMenu } from '../../ui/menu.js';
import { keyListener, KEYS } from '../../ui/keys.js';
import { attach, html, live, nothing, render } from '../../ui/render.js';
import { wear } from '../../ui/style-sheets.js';

/** Most places that are told one by one. */
const MOST_TOLD = 6;

/**
 * @param {HTMLElement} place
 * @param {import('../../core/store.js').Store} store
 * @param {ReturnType<typeof import('./cells.js').createCells>} cells
 * @param {Parameters<typeof import('./parameters-section.js').createParametersSection>[2]} outside
 */
export function createParametersPanel(place, store, cells, { check, say, nameCell }) {
  wear(/** @type {Document | ShadowRoot} */ (place.getRootNode()), look);
  const ranges = createRanges();
  /** Names that are typed and not taken over, by the present name. @type {Map<string, {text: string, fault: string}>} */
  const typed = new Map();
  let marks = 0;
  const target = (/** @type {Event} */ event) => /** @type {HTMLInputElement} */ (event.target);

  /** The places where a parameter is used, in words. @param {string} name */
  function usesInWords(name) {
    const uses = edits.usesOf(store.doc, name);
    const told = uses.slice(0, MOST_TOLD).map((path) => cells.label(path));
    return uses.length ? `${told.join('; ')}${uses.length > MOST_TOLD ? `; and ${uses.length - MOST_TOLD} more` : ''}` : '';
  }

  /** @param {string} name @param {HTMLInputElement} field */
  async function rename(name, field) {
    const fresh = field.value.trim();
    typed.delete(name);
    if (fresh === name) return draw();
    let fault = edits.nameFault(store.doc, fresh);
    if (!fault) {
      // The names of functions and units are known to the planner.
      const found = await check(edits.renameParameter(store.doc, name, fresh));
      const own = found?.where === parameterPath(fresh) && store.result.fault?.where !== parameterPath(name);
      if (found && own) fault = faultText(found);
    }
    if (fault) typed.set(name, { text: fresh, fault });
    else if (Object.hasOwn(parametersOf(store.doc), name)) store.edit((doc) => edits.renameParameter(doc, name, fresh));
    ranges.rename(name, fresh);
    draw();
  }

  function add() {
    const name = edits.freshParameterName(store.doc);
    store.edit((doc) => edits.addParameter(doc, name, 1));
    draw();
    const field = /** @type {HTMLInputElement | null} */ (place.querySelector(`[data-name="${name}"]`));
    field?.focus();
    field?.select();
  }

  /** @param {string} name @param {number} value */
  function remove(name, value) {
    const { doc: former } = store;
    const uses = edits.usesOf(former, name).length;
    store.edit((doc) => edits.removeParameter(doc, name, value));
    const instead = uses ? ` Its value ${short(value)} is in its place in ${plural(uses, 'cell')}.` : '';
    sayUndo({ store, say }, former, `The parameter ${name} is removed.${instead}`);
    place.querySelector('button')?.focus();
  }

  /** @param {HTMLButtonElement} button @returns {(name: string) => void} */
  function behave(button) {
    let name = '';
    attachMenu(button, () => {
      const uses = usesInWords(name);
      const given = parametersOf(store.doc)[name];
      const value = typeof given === 'number' ? given : expressionValue(store, parameterPath(name));
      return [
        { label: 'Remove', disabled: uses && `It is used in ${uses}`, act: () => remove(name, 0) },
        {
          label: 'Remove, and write its value where it is used',
          disabled: !uses ? 'It is not used' : value === undefined ? 'Its value is not known: mend the fault first' : '',
          act: () => remove(name, value ?? 0),
        },
      ];
    });
    return (now) => {
      name = now;
    };
  }

  /** @param {string} name @param {number} value */
  function slider(name, value) {
    const { low, high, step } = ranges.of(store.origin, name, value);
    const begin = () => {
      marks++;
    };
    const move = (/** @type {Event} */ event) => store.edit((doc) => setValue(doc, parameterPath(name), Number(target(event).value)), `parameter ${name} ${marks}`);
    return html`<input type="range" min=${low} max=${high} step=${step} aria-label="parameter ${name}, slider" aria-valuetext=${short(value)} title="${short(low)} to ${short(high)}"
      ?disabled=${store.readonly} .value=${live(String(value))} @pointerdown=${begin} @focus=${begin} @input=${move} />`;
  }

  /** @param {[string, import('../../core/types.js').Entry]} parameter */
  function row([name, given]) {
    const path = parameterPath(name);
    const entry = typed.get(name);
    const value = expressionValue(store, path);
    const type = (/** @type {Event} */ event) => typed.set(name, { text: target(event).value, fault: '' });
    const press = keyListener({
      keepValue(event) {
        rename(name, target(event));
        target(event).select();
      },
      oldValue(event) {
        typed.delete(name);
        target(event).value = name;
        draw();
        return false;
      },
    });
    return html`<tbody>
      <tr>
        <th scope="row"><input type="text" class="cell text" data-name=${name} aria-label="name of parameter ${name}" aria-invalid=${entry?.fault ? 'true' : nothing}
          aria-describedby=${entry?.fault ? `name-fault-${name}` : nothing} autocomplete="off" autocapitalize="none" spellcheck="false" ?readonly=${store.readonly} .value=${live(entry?.text ?? name)}
          @input=${type} @change=${(/** @type {Event} */ event) => rename(name, target(event))} @keydown=${press} /></th>
        <td>${cells.input({ path, column: 'value', label: `parameter ${name}` })}</td>
        <td class="range">${typeof given === 'number' ? slider(name, given) : html`<output>${value === undefined ? '' : `= ${short(value)}`}</output>`}</td>
        <td class="act"><button class="menu-button quiet edits" title="Actions of parameter ${name}" aria-label="Actions of parameter ${name}" ${attach(behave, name)}>⋯</button></td>
      </tr>
      ${entry?.fault ? html`<tr><td colspan="4"><p class="fault" role="alert" id="name-fault-${name}">${entry.fault}</p></td></tr>` : nothing}
    </tbody>`;
  }

  function draw() {
    const own = Object.entries(parametersOf(store.doc));
    for (const name of typed.keys()) if (!own.some(([present]) => present === name)) typed.delete(name);
    const last = cells.lastNumber();
    const number = last && valueAt(store.doc, last);
    render(
      html`${own.length
          ? html`<table class="parameters-table">
              <caption class="sr">Parameters</caption>
              <thead><tr><th scope="col">name</th><th scope="col">value</th><th scope="col"><span class="sr">slider</span></th><th><span class="sr">actions</span></th></tr></thead>
              ${own.map(row)}
            </table>`
          : html`<p class="muted">A parameter is a number with a name. Any cell takes an expression of parameters, such as 2*base or base*cos(30).</p>`}
        <div class="adders">
          <button class="wide" @click=${add}>+ parameter</button>
          ${typeof number === 'number'
            ? html`<button class="wide" title="In a cell: ${KEYS.parameter.keys[0]}" @click=${() => nameCell(last)}>+ from ${cells.label(last)}: ${short(number)}</button>`
            : nothing}
        </div>`,
      place,
    );
  }
  // The cell that was entered last is offered.
  /** @type {HTMLElement} */ (place.getRootNode()).addEventListener('focusin', () => place.isConnected && draw());
  return { draw };
}

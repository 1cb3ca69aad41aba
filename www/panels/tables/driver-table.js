/**
 * Driven joints as tables: for each the joint, how it goes from value to value, and the values with their times. Loaded when
 * a motion has them.
 *
 * @typedef {import('../../core/store.js').Store} Store
 */
import { drivable, addValue, freshDriver, fullTurn, keptWords, removeValue, withDrivers } from '../../core/driver-edits.js';
import { driverIndex } from '../../core/driven.js';
import { driverName } from '../../core/driven-words.js';
import { ANGLE_DECIMALS, lengthUnit, plural } from '../../core/format.js';
import { without } from '../../core/lists.js';
import { setValue } from '../../core/edits.js';
import { html, live, nothing, repeat } from '../../ui/render.js';
import { wear } from '../../ui/style-sheets.js';
import look from '../../style/drivers.css?inline';
import { setting } from './settings.js';

/** At most so many values of a driver are shown. */
const MOST = 100;

/**
 * @param {HTMLElement} root holds the tables
 * @param {Store} store
 * @param {ReturnType<typeof import('./cells.js').createCells>} cells
 * @returns {() => unknown} the tables, for the present document
 */
export function createDriverTable(root, store, cells) {
  wear(/** @type {ShadowRoot} */ (root.getRootNode()), look);
  const drivers = () => store.doc.motion.drivers ?? [];
  /** @param {(doc: import('../../core/types.js').MechanismDocument) => import('../../core/types.js').MechanismDocument} change */
  const edit = (change) => () => store.edit(change);

  /** Another joint: its values are new. @param {number} at @param {number} index of the variable */
  const choose = (at, index) => {
    const variable = drivable(store.doc)[index];
    const fresh = { ...freshDriver(store, variable), ramp: drivers()[at].ramp ?? 'linear' };
    store.edit((doc) => setValue(doc, `motion.drivers[${at}]`, fresh));
  };

  /** @param {number} at */
  function jointField(at) {
    const all = drivable(store.doc);
    const own = all.findIndex((variable) => driverIndex(store.doc, variable) === at);
    const pick = (/** @type {Event} */ { target }) => choose(at, Number(/** @type {HTMLSelectElement} */ (target).value));
    return html`<select class="cell driver-joint" aria-label=${`joint of driver ${at + 1}`} ?disabled=${store.readonly} @change=${pick}>
      ${own < 0 ? html`<option hidden .selected=${live(true)}>${driverName(store.doc, drivers()[at])}</option>` : nothing}
      ${all.map((variable, index) => {
        const other = driverIndex(store.doc, variable);
        return html`<option value=${index} ?disabled=${other >= 0 && other !== at} .selected=${live(index === own)}>${variable.name}, joint ${variable.joint + 1}</option>`;
      })}
    </select>`;
  }

  /** @param {number} at @param {boolean} turns */
  function valueTable(at, turns) {
    const { values } = drivers()[at];
    const path = `motion.drivers[${at}].values`;
    const degree = store.doc.angles === 'radians' ? 'rad' : '°';
    const unit = turns ? degree : lengthUnit(store.doc.length_unit);
    const inWords = unit === '°' ? 'degrees' : unit;
    const rows = values.slice(0, MOST).map((_, i) => {
      const label = `driver ${at + 1}, value ${i + 1}`;
      return html`<tr>
        <td>${cells.input({ path: `${path}[${i}].time`, column: 'time', label: `${label}, time in seconds` })}</td>
        <td>${cells.input({ path: `${path}[${i}].value`, column: 'value', label: `${label} in ${inWords}`, decimals: degree === '°' && turns ? ANGLE_DECIMALS : undefined })}</td>
        <td class="act"><button class="quiet edits" aria-label=${`Remove ${label}`} title=${values.length > 2 ? 'Remove this value' : 'A driver has at least two values'}
          ?disabled=${values.length <= 2} @click=${edit((doc) => removeValue(doc, at, i))}>×</button></td>
      </tr>`;
    });
    return html`<div class="scroller" data-path=${path}><table class="drive">
      <caption class="sr">Times and values of ${driverName(store.doc, drivers()[at])}</caption>
      <thead><tr><th scope="col">time<small>s</small></th><th scope="col">value<small>${unit}</small></th><th><span class="sr">actions</span></th></tr></thead>
      <tbody>${repeat(rows, (_, i) => i, (row) => row)}</tbody>
    </table></div>
    ${values.length > MOST ? html`<p class="muted">${plural(values.length - MOST, 'more value')} in the document, not shown here.</p>` : nothing}`;
  }

  /** @param {number} at */
  function section(at) {
    const many = drivers().length;
    const own = drivable(store.doc).find((variable) => driverIndex(store.doc, variable) === at);
    const turns = own?.turns ?? true;
    const path = `motion.drivers[${at}]`;
    const name = driverName(store.doc, drivers()[at]);
    return html`<section class="driver" data-path=${path} aria-label=${`driver ${at + 1}: ${name}`}>
      <header>
        ${jointField(at)}
        ${cells.select({ path: `${path}.ramp`, label: `way between the values of driver ${at + 1}`, options: [['linear', 'constant speed'], ['smooth', 'smooth, at rest at each value']] })}
      </header>
      ${valueTable(at, turns)}
      <div class="adders">
        <button class="wide" title="A value after the last and equal to it: a dwell" @click=${edit((doc) => addValue(doc, at))}>+ value</button>
        ${turns ? html`<button class="wide" title="Once round, from its first value" @click=${edit((doc) => fullTurn(doc, at))}>Full turn</button>` : nothing}
        <button class="wide" ?disabled=${many === 1} title=${many === 1 ? 'A motion without key frames has at least one driven joint' : `${name} is driven no more`}
          @click=${edit((doc) => withDrivers(doc, without(doc.motion.drivers ?? [], at)))}>Remove</button>
      </div>
    </section>`;
  }

  return () => {
    const free = drivable(store.doc).find((variable) => driverIndex(store.doc, variable) < 0);
    const add = () => free && store.edit((doc) => withDrivers(doc, [...drivers(), freshDriver(store, free)]));
    return html`<div class="title"><h2>Driven joints</h2><span>${plural(drivers().length, 'driver')}</span></div>
      <p class="muted">The loops stay closed, the other joints follow, and the path of the workpiece is the result. ${keptWords(store)}</p>
      <div data-path="motion.drivers">${repeat(drivers(), (_, at) => at, (_, at) => section(at))}</div>
      <button class="wide" ?disabled=${!free} title=${free ? 'Another joint is driven' : 'Every joint is driven'} @click=${add}>+ driver</button>
      <div class="settings">
        ${setting({ label: 'Frames', title: 'Equally spaced from the first time to the last', control: cells.input({ path: 'motion.frames', label: 'number of frames' }) })}
      </div>`;
  };
}

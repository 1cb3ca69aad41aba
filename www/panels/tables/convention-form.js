/**
 * The convention of a chain's table: what it is in either, side by side, and the switch: the numbers stay as printed, or the
 * motion stays.
 */
import { asPrinted, conventionOf, converted } from '../../core/convention.js';
import { angleUnit, lengthUnit, short } from '../../core/format.js';
import { sayUndo } from '../../core/undo.js';
import { element } from '../../ui/dom.js';
import { openFormDialog } from './form-dialog.js';
import { keptMetric } from './rewriting.js';

/** @typedef {import('../../core/convention.js').Convention} Convention */

/** @type {Record<Convention, string>} */
const NAMES = { modified: 'modified (Craig): X·Z', standard: 'standard: Z·X' };

/** @param {import('../../core/types.js').Chain} chain @param {string} title @param {import('../../core/types.js').MechanismDocument} doc */
export function rowsTable(chain, title, doc) {
  const { sign, decimals } = angleUnit(doc);
  const columns = /** @type {const} */ ([['alpha', 'α', sign], ['a', 'a', ''], ['theta', 'θ', sign], ['d', 'd', '']]);
  const text = (/** @type {unknown} */ value, /** @type {boolean} */ isAngle) => (typeof value === 'number' ? short(value, isAngle ? decimals : undefined) : String(value ?? 0));
  const rows = chain.joints.flatMap(({ type, rows: own = [] }) =>
    own.map((row, r) => element('tr', {}, r ? element('td') : element('th', { scope: 'row' }, type), ...columns.map(([name, , unit]) => element('td', {}, text(row[name], unit !== ''))))),
  );
  const table = element(
    'table',
    { class: 'shown-rows' },
    element('caption', {}, title),
    element('thead', {}, element('tr', {}, element('th', {}, 'joint'), ...columns.map(([, letter, unit]) => element('th', { scope: 'col' }, `${letter} ${unit || lengthUnit(doc.length_unit)}`)))),
    element('tbody', {}, ...rows),
  );
  return element('div', { class: 'scroller' }, table);
}

/**
 * @param {HTMLElement} root holds the tables
 * @param {import('../../core/store.js').Store} store
 * @param {import('../../ui/notice.js').Say} say
 * @param {number} index of the chain
 */
export function openConventionForm(root, store, say, index) {
  const { doc, result } = store;
  const chain = doc.chains[index];
  const now = conventionOf(chain);
  const other = now === 'modified' ? 'standard' : 'modified';
  const plain = result.doc === doc ? result.plain?.chains[index] : undefined;
  const fresh = plain && converted(chain, plain, doc);
  const choice = (/** @type {string} */ value, /** @type {string} */ label, /** @type {string} */ note, /** @type {boolean} */ checked, disabled = false) =>
    element('p', {}, element('label', {}, element('input', { type: 'radio', name: 'switch', value, checked, disabled }), ` ${label}`), element('br'), element('small', {}, note));
  const many = doc.chains.length > 1;
  const all = element('input', { type: 'checkbox' });
  const choices = element(
    'fieldset',
    { class: 'form-field' },
    element('legend', {}, `Switch to ${NAMES[other]}`),
    choice('printed', 'The numbers are a table as printed in this convention', 'They stay, and mean something else: the linkage is another one.', true),
    choice('converted', 'Convert the numbers', fresh ? 'The linkage and its motion stay.' : 'Not now: the document is at fault or still being planned.', false, !fresh),
    ...(many ? [element('p', {}, element('label', {}, all, ' All tables that are in the same convention'))] : []),
  );
  openFormDialog(root, {
    title: `Convention of chain ${index + 1}`,
    body: [
      element('p', {}, 'A row of a modified table is X(α, a) · Z(θ, d): the link before the joint. A row of a standard table is Z(θ, d) · X(α, a): the link behind it; the last one leads to the gripper.'),
      element('div', { class: 'side-by-side' }, rowsTable(chain, `As it is: ${NAMES[now]}`, doc), ...(fresh ? [rowsTable(fresh, `The same linkage: ${NAMES[other]}`, doc)] : [])),
      choices,
    ],
    apply: 'Switch',
    readonly: store.readonly,
    act() {
      const how = /** @type {HTMLInputElement} */ (choices.querySelector(':checked')).value;
      const chains = doc.chains.flatMap((one, i) => (i === index || (all.checked && conventionOf(one) === now && one.joints.some(({ rows }) => rows)) ? [i] : []));
      if (store.doc !== doc) return true;
      const { keep, said } = keptMetric(store);
      if (how === 'printed') store.edit((present) => asPrinted(present, chains, other));
      else store.edit((present) => keep({ ...present, chains: present.chains.map((one, i) => (chains.includes(i) ? converted(one, /** @type {any} */ (result.plain).chains[i], present) : one)) }));
      sayUndo({ store, say }, doc, how === 'printed' ? `The numbers are read as ${NAMES[other]}.` : `The numbers are converted to ${NAMES[other]}; the motion stays.${said}`);
      return true;
    },
  });
}

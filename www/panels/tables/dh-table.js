/**
 * A chain's Denavit–Hartenberg rows as a table, with the joints that they belong to.
 *
 * @typedef {import('../../core/types.js').JointType} JointType
 */
import * as edits from '../../core/edits.js';
import { angleUnit, lengthUnit } from '../../core/format.js';
import { JOINT_LETTERS, JOINT_TYPES, jointOf, variableName } from '../../core/joint-types.js';
import { driveItems } from './drive-items.js';
import { html, nothing, repeat } from '../../ui/render.js';

/** @type {['alpha' | 'a' | 'theta' | 'd', string, 'angle' | 'length'][]} */
const PARAMETERS = [
  ['alpha', 'α', 'angle'],
  ['a', 'a', 'length'],
  ['theta', 'θ', 'angle'],
  ['d', 'd', 'length'],
];

/**
 * @param {import('../../core/store.js').Store} store
 * @param {ReturnType<typeof import('./cells.js').createCells>} cells
 * @param {import('../../core/types.js').Defaults} defaults
 * @param {ReturnType<typeof import('./reorder.js').createArrange>} arrange
 * @param {ReturnType<typeof import('./forms.js').createForms>} forms
 */
export function createDhTable(store, cells, defaults, arrange, forms) {
  /** @param {number} chain @param {number} joint */
  const picker = (chain, joint) =>
    cells.select({
      path: `chains[${chain}].joints[${joint}].type`,
      label: `chain ${chain + 1}, joint ${joint + 1}, type`,
      options: JOINT_LETTERS.map((letter) => [letter, `${letter}  ${JOINT_TYPES[letter].name}`]),
      write: (doc, letter) => edits.setJoint(doc, chain, joint, defaults.joints[/** @type {JointType} */ (letter)]),
    });

  /** @param {number} chain @param {number} joint */
  function menu(chain, joint) {
    const insert = (/** @type {number} */ at) => () => store.edit((doc) => edits.insertJoint(doc, chain, at, defaults.joints.R));
    return arrange.menu(`chains[${chain}].joints[${joint}]`, `joint ${joint + 1} of chain ${chain + 1}`, () => [
      { label: 'Insert a joint before', act: insert(joint) },
      { label: 'Insert a joint after', act: insert(joint + 1) },
      ...driveItems(store, forms, chain, joint),
      { label: 'Remove', act: () => store.edit((doc) => edits.removeJoint(doc, chain, joint)) },
    ]);
  }

  /** @param {number} chain @param {number[]} keys of its joints */
  return (chain, keys) => {
    const { length_unit: unit, chains } = store.doc;
    const angles = angleUnit(store.doc);
    let number = 0;
    const bodies = chains[chain].joints.map((joint, j) => {
      const path = `chains[${chain}].joints[${j}]`;
      const rows = (jointOf(joint.type)?.rows ?? []).map((variables, r) => {
        const row = number++;
        const parameters = PARAMETERS.map(([key, symbol, kind]) => {
          const label = `chain ${chain + 1}, row ${row + 1}, ${symbol} in ${kind === 'angle' ? angles.name : lengthUnit(unit)}`;
          const variable = (key === 'theta' || key === 'd') && variables.includes(key) ? key : null;
          const cell = cells.input({
            path: `${path}.rows[${r}].${key}`,
            column: key,
            decimals: kind === 'angle' ? angles.decimals : undefined,
            label: variable ? `${label}, constant added to the joint variable` : label,
          });
          if (!variable) return html`<td>${cell}</td>`;
          const name = html`<var title="joint variable; the number beside it is added">${variableName(variable, row)}</var>`;
          return html`<td class="variable"><span>${name}<i aria-hidden="true">+</i>${cell}</span></td>`;
        });
        return html`<tr>
          <th scope="row">${row + 1}</th>
          <td class="joint">${r === 0 ? picker(chain, j) : nothing}</td>
          ${parameters}
          <td class="act">${r === 0 ? menu(chain, j) : nothing}</td>
        </tr>`;
      });
      return { key: keys[j], body: html`<tbody data-path=${path}>${rows}</tbody>` };
    });
    return html`<div class="scroller"><table class="dh">
      <caption class="sr">Denavit–Hartenberg rows of chain ${chain + 1}</caption>
      <thead><tr>
        <th scope="col"><span class="sr">row</span></th>
        <th scope="col">joint</th>
        ${PARAMETERS.map(([, symbol, kind]) => html`<th scope="col"><var>${symbol}</var><small>${kind === 'angle' ? angles.sign : lengthUnit(unit)}</small></th>`)}
        <th><span class="sr">actions</span></th>
      </tr></thead>
      ${repeat(bodies, ({ key }) => key, ({ body }) => body)}
    </table></div>`;
  };
}

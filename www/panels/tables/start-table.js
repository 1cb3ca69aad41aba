/**
 * A chain's joint variables as a table: the value that is shown now, the start value and the limits.
 */
import * as edits from '../../core/edits.js';
import { angleUnit, degrees, lengthUnit, short } from '../../core/format.js';
import { asWritten } from '../../core/document-angles.js';
import { chainVariables, variableName } from '../../core/joint-types.js';
import { groupAt, shown } from '../../core/shown.js';
import { html, repeat } from '../../ui/render.js';

/** The joint values of the playhead's frame, or of a posture in its place, as texts chain by chain. @param {import('../../core/store.js').Store} store @returns {string[][]} */
export function shownValues(store) {
  const { motion } = store.result;
  const now = shown(store);
  if (!motion || !now) return [];
  const joints = groupAt(now.joints, now);
  const { name, decimals } = angleUnit(store.doc);
  let at = 0;
  return motion.report.chains.map(({ variables }) =>
    variables.map(({ unit }) => {
      const value = joints[at++];
      return unit === 'rad' ? short(name === 'radians' ? value : degrees(value), decimals) : short(value);
    }),
  );
}

/**
 * @param {import('../../core/store.js').Store} store
 * @param {ReturnType<typeof import('./cells.js').createCells>} cells
 * @param {number} chain
 * @param {number[]} keys of its joints
 * @param {string[]} values that are shown now
 */
export function startTable(store, cells, chain, keys, values) {
  const variables = chainVariables(store.doc.chains[chain]);
  const lengths = lengthUnit(store.doc.length_unit);
  const freedoms = (/** @type {number} */ joint) => variables.filter((v) => v.joint === joint).length;
  const angles = angleUnit(store.doc);
  // The planner tells them in degrees.
  const current = () => (store.result.motion?.report.start[chain] ?? []).map((value, at) => (variables[at]?.variable === 'theta' ? asWritten(store.doc, value) : value));
  const rows = variables.map(({ variable, joint, freedom, row }, index) => {
    const name = variableName(variable, row);
    const label = `chain ${chain + 1}, ${name} in ${variable === 'theta' ? angles.name : lengths}`;
    const decimals = variable === 'theta' ? angles.decimals : undefined;
    const start = cells.input({
      path: `chains[${chain}].start[${index}]`,
      column: 'start',
      label: `${label}, start`,
      optional: true,
      decimals,
      fallback: () => current()[index],
      write: (doc, value) =>
        value === undefined ? edits.clearStart(doc, chain) : edits.setStart(doc, chain, index, value, filled(current(), variables.length)),
    });
    const bounds = /** @type {const} */ (['min', 'max']).map((bound) =>
      cells.input({
        path: `chains[${chain}].joints[${joint}].limits[${freedom}].${bound}`,
        column: bound,
        label: `${label}, ${bound === 'min' ? 'lower' : 'upper'} limit`,
        optional: true,
        decimals,
        write: (doc, value) => edits.setLimit(doc, { chain, joint, freedom, freedoms: freedoms(joint) }, bound, value),
      }),
    );
    return {
      key: `${keys[joint]} ${freedom}`,
      cells: html`<tr>
        <th scope="row"><var>${name}</var><small>${variable === 'theta' ? angles.sign : lengths}</small></th>
        <td class="now"><output>${values[index] ?? ''}</output></td>
        ${[start, ...bounds].map((cell) => html`<td>${cell}</td>`)}
      </tr>`,
    };
  });
  return html`<div class="scroller"><table class="start">
    <caption class="sr">Joint variables of chain ${chain + 1}</caption>
    <thead><tr><td></td>${['now', 'start', 'min', 'max'].map((head) => html`<th scope="col">${head}</th>`)}</tr></thead>
    <tbody data-path="chains[${chain}].start">${repeat(rows, ({ key }) => key, (row) => row.cells)}</tbody>
  </table></div>`;
}

/** @param {number[]} values @param {number} count */
const filled = (values, count) => Array.from({ length: count }, (_, i) => values[i] ?? 0);

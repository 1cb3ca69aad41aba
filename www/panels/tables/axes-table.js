/**
 * A chain's joints by their points and directions at the home position, as a table; and home itself, which all such chains
 * share.
 *
 * @typedef {import('../../core/types.js').JointType} JointType
 */
import { VECTORS, asType, readJoints, withJoints } from '../../core/axes-edits.js';
import { AXES_JOINTS } from '../../core/by-axes.js';
import * as edits from '../../core/edits.js';
import { lengthUnit, plural } from '../../core/format.js';
import { JOINT_LETTERS, JOINT_TYPES } from '../../core/joint-types.js';
import { sayUndo } from '../../core/undo.js';
import { html, nothing, repeat } from '../../ui/render.js';
import { driveItems } from './drive-items.js';
import { createAxesTools } from './axes-tools.js';
import { coordinateCells, coordinateHeads } from './frame-table.js';

const COORDINATES = ['x', 'y', 'z'];
/** Directions are shown with more decimals than lengths: they are of length 1 mostly. */
const DECIMALS = 6;

/**
 * @param {import('../../core/store.js').Store} store
 * @param {ReturnType<typeof import('./cells.js').createCells>} cells
 * @param {ReturnType<typeof import('./reorder.js').createArrange>} arrange
 * @param {import('./typed-parts.js').View} view
 * @param {ReturnType<typeof import('./typed-parts.js').createTypedParts>} typed
 * @param {() => void} draw
 * @param {ReturnType<typeof import('./forms.js').createForms>} forms
 */
export function createAxesTable(store, cells, arrange, view, typed, draw, forms) {
  const tools = createAxesTools(view, draw);

  /** Three cells of a vector. @param {number} chain @param {number} joint @param {'point' | 'axis' | 'second'} field @param {string} what @param {boolean} optional */
  function vector(chain, joint, field, what, optional) {
    const path = `chains[${chain}].joints[${joint}].${field}`;
    const fields = COORDINATES.map((name, at) =>
      cells.input({
        path: `${path}[${at}]`,
        column: `${field === 'point' ? '' : 'd'}${name}`,
        label: `chain ${chain + 1}, joint ${joint + 1}, ${what}, ${name}${field === 'point' ? ` in ${lengthUnit(store.doc.length_unit)}` : ''}`,
        decimals: field === 'point' ? undefined : DECIMALS,
        optional,
        write: (doc, value) => edits.setCoordinate(doc, path, at, value, [0, 0, 0]),
      }),
    );
    return html`<td><div class="point" data-path=${path}>${fields}</div></td>`;
  }

  /** @param {number} chain @param {number} joint */
  function menu(chain, joint) {
    const insert = (/** @type {number} */ at) => () => store.edit((doc) => edits.insertJoint(doc, chain, at, AXES_JOINTS.R));
    const { joints } = store.doc.chains[chain];
    return arrange.menu(`chains[${chain}].joints[${joint}]`, `joint ${joint + 1} of chain ${chain + 1}`, () => [
      { label: 'Insert a joint before', act: insert(joint) },
      { label: 'Insert a joint after', act: insert(joint + 1) },
      ...driveItems(store, forms, chain, joint),
      { label: 'Remove', disabled: joints.length === 1 ? 'A chain has at least one joint' : '', act: () => store.edit((doc) => edits.removeJoint(doc, chain, joint)) },
    ]);
  }

  /** @param {ClipboardEvent} event @param {number} chain */
  function paste(event, chain) {
    const field = /** @type {HTMLElement} */ (event.target);
    const answer = readJoints(event.clipboardData?.getData('text/plain') ?? '', edits.entry);
    const at = /\.joints\[(\d+)\]/.exec(field.dataset.path ?? '')?.[1];
    if (store.readonly || !answer || at === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    if ('fault' in answer) return view.say(`Nothing was pasted. ${answer.fault}`);
    const former = store.doc;
    field.blur();
    store.edit((doc) => withJoints(doc, chain, Number(at), answer.joints));
    sayUndo(view, former, `${plural(answer.joints.length, 'joint')} pasted.`);
  }

  return {
    /** @param {number} chain @param {number[]} keys of its joints */
    table(chain, keys) {
      const { chains, length_unit: unit } = store.doc;
      const bodies = chains[chain].joints.map((joint, j) => {
        const path = `chains[${chain}].joints[${j}]`;
        const type = /** @type {JointType} */ (String(joint.type).toUpperCase().replace('U', 'T'));
        const { optional, axis, second } = VECTORS[type] ?? VECTORS.R;
        const picker = cells.select({
          path: `${path}.type`,
          label: `chain ${chain + 1}, joint ${j + 1}, type`,
          options: JOINT_LETTERS.map((letter) => [letter, `${letter}  ${JOINT_TYPES[letter].name}`]),
          write: (doc, letter) => edits.setJoint(doc, chain, j, asType(doc.chains[chain].joints[j], /** @type {JointType} */ (letter))),
        });
        const more = second || joint.second;
        return {
          key: keys[j],
          body: html`<tbody data-path=${path}>
            <tr>
              <th scope="row">${j + 1}</th>
              <td class="joint">${picker}</td>
              ${vector(chain, j, 'point', 'point', optional.includes('point'))}
              ${vector(chain, j, 'axis', axis, optional.includes('axis'))}
              <td class="act">${menu(chain, j)}</td>
            </tr>
            ${more ? html`<tr><td></td><td colspan="2" class="second">${second || 'second axis'}</td>${vector(chain, j, 'second', second || 'second axis', type !== 'T')}<td></td></tr>` : nothing}
          </tbody>`,
        };
      });
      return html`<div @paste=${(/** @type {ClipboardEvent} */ event) => paste(event, chain)} @focusin=${tools.entered} @focusout=${tools.left}>
        <div class="scroller"><table class="dh axes">
          <caption class="sr">Joints of chain ${chain + 1} by their axes at the home position</caption>
          <thead><tr>
            <th scope="col"><span class="sr">joint</span></th>
            <th scope="col">joint</th>
            <th scope="col">point x y z<small>${lengthUnit(unit)}</small></th>
            <th scope="col">direction x y z</th>
            <th><span class="sr">actions</span></th>
          </tr></thead>
          ${repeat(bodies, ({ key }) => key, ({ body }) => body)}
        </table></div>
        ${store.readonly ? nothing : tools.bar(chain)}
      </div>`;
    },

    /** Home, told once. */
    home() {
      return html`<div class="home">
        <div class="scroller"><table class="frames">
          <caption class="sr">Home: the workpiece's pose at which the joints of all chains by axes are 0</caption>
          <thead><tr><td></td>${coordinateHeads(store.doc)}</tr></thead>
          <tbody><tr data-path="home"><th scope="row">home</th>${coordinateCells(cells, 'home', 'home', store.doc, typed)}</tr></tbody>
        </table></div>
        <p class="muted">Home is where the workpiece is when all joints of the chains by axes are 0. They share it; their points and directions are those of that position, in the fixed frame.</p>
      </div>`;
    },
  };
}

/**
 * The mechanism as tables: for each chain its Denavit–Hartenberg rows, base and gripper, start values and limits.
 *
 * @typedef {import('../../core/store.js').Store} Store
 * @typedef {import('../../core/types.js').Defaults} Defaults
 * @typedef {ReturnType<typeof import('./cells.js').createCells>} Cells
 */
import * as edits from '../../core/edits.js';
import { html, renderRows, repeat } from '../../ui/render.js';
import { createDhTable } from './dh-table.js';
import { coordinateCells, coordinateHeads } from './frame-table.js';
import { createParametersSection } from './parameters-section.js';
import { createRowKeys } from './row-keys.js';
import { shownValues, startTable } from './start-table.js';
import { createTypeField } from './type-field.js';
import { createUnitField } from './unit-field.js';

const FRAMES = [
  ['base', 'G', 'base frame'],
  ['gripper', 'H', 'gripper frame'],
];

/**
 * @param {HTMLElement} panel
 * @param {Store} store
 * @param {Cells} cells
 * @param {Defaults} defaults
 * @param {ReturnType<typeof import('./reorder.js').createArrange>} arrange
 * @param {() => void} findStart asks the planner for start values
 * @param {ReturnType<typeof import('./forms.js').createForms>} forms
 * @param {import('../../ui/notice.js').Say} say
 * @param {(doc: import('../../core/types.js').MechanismDocument) => Promise<import('../../core/types.js').Fault | null>} check asks the planner
 */
export function createChainTables(panel, store, cells, defaults, arrange, findStart, forms, say, check) {
  const chainKeys = createRowKeys();
  /** By the chain's key. @type {Map<number, ReturnType<typeof createRowKeys>>} */
  const jointKeys = new Map();
  /** Keys of the chains whose start values are unfolded. @type {Set<number>} */
  const unfolded = new Set();
  const typeField = createTypeField(store, defaults, draw);
  const dhTable = createDhTable(store, cells, defaults, arrange);
  const unitField = createUnitField(store, say);
  const parameters = createParametersSection(store, cells, { check, say, nameCell: forms.parameter });

  const unit = () => store.doc.length_unit;

  /** @param {number} chain */
  const framesTable = (chain) =>
    html`<div class="scroller"><table class="frames">
      <caption class="sr">Base and gripper frame of chain ${chain + 1}</caption>
      <thead><tr><td></td>${coordinateHeads(unit())}</tr></thead>
      <tbody>${FRAMES.map(([key, letter, name]) => {
        const path = `chains[${chain}].${key}`;
        return html`<tr data-path=${path}>
          <th scope="row">${turnButton(chain, path, letter, name)}</th>
          ${coordinateCells(cells, path, `chain ${chain + 1}, ${name}`, unit())}
        </tr>`;
      })}</tbody>
    </table></div>`;

  /** The frame's letter, which opens its turn in other forms. @param {number} chain @param {string} path @param {string} letter @param {string} name */
  function turnButton(chain, path, letter, name) {
    const label = `${letter}${chain + 1}, ${name} of chain ${chain + 1}: turn as quaternion, matrix, roll-pitch-yaw`;
    return html`<button class="quiet letter" title=${label} aria-label=${label} @click=${() => forms.turn(path, `the ${name} of chain ${chain + 1}`)}
      ><var>${letter}<sub>${chain + 1}</sub></var></button>`;
  }

  /** @param {number} chain */
  const chainMenu = (chain) => {
    const { chains } = store.doc;
    return arrange.menu(`chains[${chain}]`, `chain ${chain + 1}`, () => [
      { label: 'Add a joint', act: () => store.edit((doc) => edits.insertJoint(doc, chain, chains[chain].joints.length, defaults.joints.R)) },
      { label: 'Duplicate', act: () => store.edit((doc) => edits.duplicateChain(doc, chain)) },
      { label: 'Duplicate around an axis…', act: () => forms.copies(chain) },
      { label: 'Base frame as quaternion, matrix…', act: () => forms.turn(`chains[${chain}].base`, `the base frame of chain ${chain + 1}`) },
      { label: 'Gripper frame as quaternion, matrix…', act: () => forms.turn(`chains[${chain}].gripper`, `the gripper frame of chain ${chain + 1}`) },
      { label: 'Remove', disabled: chains.length === 1 ? 'A linkage has at least one chain' : '', act: () => store.edit((doc) => edits.removeChain(doc, chain)) },
    ]);
  };

  /** @param {number} chain @param {number} key @param {string[]} values that are shown now */
  function chainSection(chain, key, values) {
    const type = typeField(chain, key);
    const keysOf = jointKeys.get(key) ?? createRowKeys();
    jointKeys.set(key, keysOf);
    const joints = keysOf(/** @type {any[]} */ (store.doc.chains[chain].joints));
    const fold = (/** @type {Event} */ { target }) => {
      if (/** @type {HTMLDetailsElement} */ (target).open) unfolded.add(key);
      else unfolded.delete(key);
      draw();
    };
    return html`<section class="chain" data-path="chains[${chain}]" data-chain=${chain}>
      <header>
        <h3>${cells.input({ path: `chains[${chain}].name`, label: `name of chain ${chain + 1}`, text: true })}${type.field}</h3>
        ${chainMenu(chain)}
      </header>
      ${type.note}${dhTable(chain, joints)}${framesTable(chain)}
      <details ?open=${unfolded.has(key)} @toggle=${fold}>
        <summary>Start values and limits</summary>
        ${startTable(store, cells, chain, joints, values)}
        <button class="quiet edits" title="Let the planner look for start values that close the loops, in every chain" @click=${findStart}>find a start</button>
      </details>
    </section>`;
  }

  function draw() {
    const { chains } = store.doc;
    const keys = chainKeys(/** @type {any[]} */ (chains));
    for (const known of [jointKeys, unfolded]) for (const key of known.keys()) if (!keys.includes(key)) known.delete(key);
    const values = keys.some((key) => unfolded.has(key)) ? shownValues(store) : [];
    const sections = chains.map((_, chain) => ({ key: keys[chain], section: () => chainSection(chain, keys[chain], values[chain] ?? []) }));
    const { field, choice } = unitField();
    renderRows(
      html`<div class="heads">
          <label class="field"><span>Name</span>${cells.input({ path: 'name', label: 'name of the mechanism', text: true })}</label>
          <label class="field"><span>Unit of length</span>${field}</label>
        </div>
        ${choice}${parameters.section()}
        <h2 class="sr">Chains</h2>
        <div data-path="chains">${repeat(sections, ({ key }) => key, ({ section }) => section())}</div>
        <button class="wide" @click=${() => store.edit((doc) => edits.addChain(doc, defaults.chain))}>+ chain</button>`,
      panel,
    );
  }

  return {
    draw,
    drawParameters: parameters.draw,
    /** The joint values that are shown follow the playhead, where they are unfolded. */
    follow() {
      if (unfolded.size) draw();
    },
  };
}

/**
 * The mechanism as tables: for each chain its Denavit–Hartenberg rows, base and gripper, or its joints by their axes; start
 * values and limits.
 *
 * @typedef {import('../../core/store.js').Store} Store
 * @typedef {import('../../core/types.js').Defaults} Defaults
 * @typedef {ReturnType<typeof import('./cells.js').createCells>} Cells
 */
import { angleUnit } from '../../core/format.js';
import { AXES_JOINTS, axesChain, isByAxes } from '../../core/by-axes.js';
import * as edits from '../../core/edits.js';
import { html, live, nothing, renderRows, repeat } from '../../ui/render.js';
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
 * @param {import('./forms.js').Forms} forms
 * @param {import('../../ui/notice.js').Say} say
 * @param {(doc: import('../../core/types.js').MechanismDocument) => Promise<import('../../core/types.js').Fault | null>} check asks the planner
 * @param {{typed: ReturnType<typeof import('./typed-parts.js').createTypedParts>, view: import('./typed-parts.js').View}} more
 */
export function createChainTables(panel, store, cells, defaults, arrange, findStart, forms, say, check, { typed, view }) {
  const chainKeys = createRowKeys();
  /** By the chain's key. @type {Map<number, ReturnType<typeof createRowKeys>>} */
  const jointKeys = new Map();
  /** Keys of the chains whose start values are unfolded. @type {Set<number>} */
  const unfolded = new Set();
  const typeField = createTypeField(store, defaults, draw);
  const dhTable = createDhTable(store, cells, defaults, arrange, forms);
  const unitField = createUnitField(store, say);
  const parameters = createParametersSection(store, cells, { check, say, nameCell: forms.parameter });

  /** Of chains by axes, when they are loaded. @type {ReturnType<typeof import('./axes-table.js').createAxesTable> | undefined} */
  let axesTable;
  const axes = () => {
    const parts = typed.get();
    return (axesTable ??= parts?.createAxesTable(store, cells, arrange, view, typed, draw, forms));
  };

  /** @param {number} chain */
  const framesTable = (chain) =>
    html`<div class="scroller"><table class="frames">
      <caption class="sr">Base and gripper frame of chain ${chain + 1}</caption>
      <thead><tr><td></td>${coordinateHeads(store.doc)}</tr></thead>
      <tbody>${FRAMES.map(([key, letter, name]) => {
        const path = `chains[${chain}].${key}`;
        return html`<tr data-path=${path}>
          <th scope="row">${turnButton(chain, path, letter, name)}</th>
          ${coordinateCells(cells, path, `chain ${chain + 1}, ${name}`, store.doc, typed)}
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
    const by = isByAxes(chains[chain]);
    return arrange.menu(`chains[${chain}]`, `chain ${chain + 1}`, () => [
      { label: 'Add a joint', act: () => store.edit((doc) => edits.insertJoint(doc, chain, chains[chain].joints.length, (by ? AXES_JOINTS : defaults.joints).R)) },
      { label: 'Duplicate', act: () => store.edit((doc) => edits.duplicateChain(doc, chain)) },
      { label: 'Duplicate around an axis…', act: () => forms.copies(chain) },
      ...(by
        ? [
            { label: 'Show the rows…', act: () => forms.rows(chain) },
            { label: 'Turn into rows', act: () => forms.intoRows(chain) },
            { label: 'Home as quaternion, matrix…', act: () => forms.turn('home', 'home') },
          ]
        : [
            { label: 'Convention of the table…', act: () => forms.convention(chain) },
            { label: 'Give by axes', hint: 'Its joints are 0 at the start then', act: () => forms.byAxes(chain) },
            { label: 'Base frame as quaternion, matrix…', act: () => forms.turn(`chains[${chain}].base`, `the base frame of chain ${chain + 1}`) },
            { label: 'Gripper frame as quaternion, matrix…', act: () => forms.turn(`chains[${chain}].gripper`, `the gripper frame of chain ${chain + 1}`) },
          ]),
      { label: 'Remove', disabled: chains.length === 1 ? 'A linkage has at least one chain' : '', act: () => store.edit((doc) => edits.removeChain(doc, chain)) },
    ]);
  };

  /** @param {number} chain @param {number[]} joints their keys */
  function tablesOf(chain, joints) {
    const one = store.doc.chains[chain];
    if (isByAxes(one)) return axes()?.table(chain, joints) ?? html`<p class="muted" role="status">Loading the table of axes …</p>`;
    const name = one.convention === 'standard' ? 'standard: Z·X' : 'modified (Craig): X·Z';
    const label = `Convention of the table of chain ${chain + 1}: ${name}; switch or compare`;
    const button = html`<button class="quiet" data-path="chains[${chain}].convention" title=${label} aria-label=${label} @click=${() => forms.convention(chain)}>${name}</button>`;
    return html`<p class="convention">${button}</p>${dhTable(chain, joints)}${framesTable(chain)}`;
  }

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
      ${type.note}${tablesOf(chain, joints)}
      <details ?open=${unfolded.has(key)} @toggle=${fold}>
        <summary>Start values and limits${isByAxes(store.doc.chains[chain]) ? ', counted from home' : ''}</summary>
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
    const byAxes = chains.some(isByAxes);
    const angles = angleUnit(store.doc).name;
    const askAngles = (/** @type {Event} */ event) => {
      const select = /** @type {HTMLSelectElement} */ (event.target);
      forms.angles(/** @type {'degrees' | 'radians'} */ (select.value));
      select.value = angles;
    };
    renderRows(
      html`<div class="heads">
          <label class="field"><span>Name</span>${cells.input({ path: 'name', label: 'name of the mechanism', text: true })}</label>
          <label class="field"><span>Unit of length</span>${field}</label>
          <label class="field"><span>Angles</span><select class="cell" data-path="angles" aria-label="unit of angles" ?disabled=${store.readonly} @change=${askAngles}>
            ${['degrees', 'radians'].map((unit) => html`<option value=${unit} .selected=${live(unit === angles)}>${unit}</option>`)}
          </select></label>
        </div>
        ${choice}${parameters.section()}
        <h2 class="sr">Chains</h2>
        ${byAxes ? axes()?.home() : nothing}
        <div data-path="chains">${repeat(sections, ({ key }) => key, ({ section }) => section())}</div>
        <div class="adders">
          <button class="wide" title="A chain by a Denavit–Hartenberg table" @click=${() => store.edit((doc) => edits.addChain(doc, defaults.chain))}>+ chain</button>
          <button class="wide" title="A chain by points and directions of its joints" @click=${() => store.edit((doc) => edits.addChain(doc, axesChain()))}>+ chain by axes</button>
        </div>`,
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

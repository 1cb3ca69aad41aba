/**
 * The mechanism as tables: for each chain its Denavit–Hartenberg rows, base and gripper, start values and limits.
 *
 * @typedef {import('../../core/store.js').Store} Store
 * @typedef {import('../../core/types.js').Defaults} Defaults
 * @typedef {import('../../core/types.js').JointType} JointType
 * @typedef {ReturnType<typeof import('./cells.js').createCells>} Cells
 */
import * as edits from '../../core/edits.js';
import { ANGLE_DECIMALS, degrees, lengthUnit, short } from '../../core/format.js';
import { JOINT_LETTERS, JOINT_TYPES, chainVariables, variableName } from '../../core/joint-types.js';
import { groupAt, shown } from '../../core/shown.js';
import { element, setText } from '../../ui/dom.js';
import { coordinateCells, coordinateHeads } from './frame-table.js';
import { typeField } from './type-field.js';
import { unitField } from './unit-field.js';

/** @type {['alpha' | 'a' | 'theta' | 'd', string, 'angle' | 'length'][]} */
const PARAMETERS = [
  ['alpha', 'α', 'angle'],
  ['a', 'a', 'length'],
  ['theta', 'θ', 'angle'],
  ['d', 'd', 'length'],
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
 */
export function createChainTables(panel, store, cells, defaults, arrange, findStart, forms, say) {
  /** Outputs that follow the playhead: one a joint variable. @type {HTMLOutputElement[][]} */
  let nows = [];
  /** Chains whose start values are unfolded, kept over a rebuild. @type {Set<number>} */
  const unfolded = new Set();

  const unit = () => store.doc.length_unit;

  /** @param {number} chain */
  function dhTable(chain) {
    const { joints } = store.doc.chains[chain];
    /** @type {HTMLElement[]} */
    const body = [];
    let number = 0;
    joints.forEach((joint, j) => {
      const path = `chains[${chain}].joints[${j}]`;
      const rows = JOINT_TYPES[joint.type]?.rows ?? [];
      const group = element('tbody', { 'data-path': path });
      rows.forEach((variables, r) => {
        const row = number++;
        const cellsOfRow = PARAMETERS.map(([key, symbol, kind]) => {
          const label = `chain ${chain + 1}, row ${row + 1}, ${symbol} in ${kind === 'angle' ? 'degrees' : lengthUnit(unit())}`;
          const variable = (key === 'theta' || key === 'd') && variables.includes(key) ? key : null;
          const field = cells.input({
            path: `${path}.rows[${r}].${key}`,
            decimals: kind === 'angle' ? ANGLE_DECIMALS : undefined,
            label: variable ? `${label}, constant added to the joint variable` : label,
          });
          field.dataset.column = key;
          if (!variable) return element('td', {}, field);
          const name = element('var', { title: 'joint variable; the number beside it is added' }, variableName(variable, row));
          return element('td', { class: 'variable' }, element('span', {}, name, element('i', { 'aria-hidden': 'true' }, '+'), field));
        });
        group.append(
          element(
            'tr',
            {},
            element('th', { scope: 'row' }, String(row + 1)),
            element('td', { class: 'joint' }, r === 0 ? jointPicker(chain, j) : ''),
            ...cellsOfRow,
            element('td', { class: 'act' }, r === 0 ? jointMenu(chain, j) : ''),
          ),
        );
      });
      body.push(group);
    });
    return scroller(
      element(
        'table',
        { class: 'dh' },
        element('caption', { class: 'sr' }, `Denavit–Hartenberg rows of chain ${chain + 1}`),
        element(
          'thead',
          {},
          element(
            'tr',
            {},
            element('th', { scope: 'col' }, element('span', { class: 'sr' }, 'row')),
            element('th', { scope: 'col' }, 'joint'),
            ...PARAMETERS.map(([, symbol, kind]) =>
              element('th', { scope: 'col' }, element('var', {}, symbol), element('small', {}, kind === 'angle' ? '°' : lengthUnit(unit()))),
            ),
            element('th', {}, element('span', { class: 'sr' }, 'actions')),
          ),
        ),
        ...body,
      ),
    );
  }

  /** @param {number} chain @param {number} joint */
  function jointPicker(chain, joint) {
    return cells.select({
      path: `chains[${chain}].joints[${joint}].type`,
      label: `chain ${chain + 1}, joint ${joint + 1}, type`,
      options: JOINT_LETTERS.map((letter) => [letter, `${letter}  ${JOINT_TYPES[letter].name}`]),
      write: (doc, letter) => edits.setJoint(doc, chain, joint, defaults.joints[/** @type {JointType} */ (letter)]),
    });
  }

  /** @param {number} chain @param {number} joint */
  function jointMenu(chain, joint) {
    const insert = (/** @type {number} */ at) => () => store.edit((doc) => edits.insertJoint(doc, chain, at, defaults.joints.R));
    return arrange.menu(`chains[${chain}].joints[${joint}]`, `joint ${joint + 1} of chain ${chain + 1}`, () => [
      { label: 'Insert a joint before', act: insert(joint) },
      { label: 'Insert a joint after', act: insert(joint + 1) },
      { label: 'Remove', act: () => store.edit((doc) => edits.removeJoint(doc, chain, joint)) },
    ]);
  }

  /** @param {number} chain */
  const framesTable = (chain) =>
    scroller(
      element(
        'table',
        { class: 'frames' },
        element('caption', { class: 'sr' }, `Base and gripper frame of chain ${chain + 1}`),
        element('thead', {}, element('tr', {}, element('td', {}), ...coordinateHeads(unit()))),
        element(
          'tbody',
          {},
          ...[
            ['base', 'G', 'base frame'],
            ['gripper', 'H', 'gripper frame'],
          ].map(([key, letter, name]) =>
            element(
              'tr',
              { 'data-path': `chains[${chain}].${key}` },
              element('th', { scope: 'row' }, turnButton(chain, key, letter, name)),
              ...coordinateCells(cells, `chains[${chain}].${key}`, `chain ${chain + 1}, ${name}`, unit()),
            ),
          ),
        ),
      ),
    );

  /** The frame's letter, which opens its turn in other forms. @param {number} chain @param {string} key @param {string} letter @param {string} name */
  function turnButton(chain, key, letter, name) {
    const label = `${letter}${chain + 1}, ${name} of chain ${chain + 1}: turn as quaternion, matrix, roll-pitch-yaw`;
    return element(
      'button',
      { class: 'quiet letter', title: label, 'aria-label': label, click: () => forms.turn(`chains[${chain}].${key}`, `the ${name} of chain ${chain + 1}`) },
      element('var', {}, letter, element('sub', {}, String(chain + 1))),
    );
  }

  /** @param {number} chain */
  function startTable(chain) {
    const variables = chainVariables(store.doc.chains[chain]);
    const freedoms = (/** @type {number} */ joint) => variables.filter((v) => v.joint === joint).length;
    nows[chain] = [];
    const rows = variables.map(({ variable, joint, freedom, row }, index) => {
      const unitName = variable === 'theta' ? '°' : lengthUnit(unit());
      const name = variableName(variable, row);
      const label = `chain ${chain + 1}, ${name} in ${variable === 'theta' ? 'degrees' : lengthUnit(unit())}`;
      const now = element('output', {});
      nows[chain].push(now);
      const current = () => store.result.motion?.report.start[chain] ?? [];
      const start = cells.input({
        path: `chains[${chain}].start[${index}]`,
        label: `${label}, start`,
        optional: true,
        decimals: variable === 'theta' ? ANGLE_DECIMALS : undefined,
        fallback: () => current()[index],
        write: (doc, value) =>
          value === undefined ? edits.clearStart(doc, chain) : edits.setStart(doc, chain, index, value, filled(current(), variables.length)),
      });
      const bounds = /** @type {const} */ (['min', 'max']).map((bound) =>
        cells.input({
          path: `chains[${chain}].joints[${joint}].limits[${freedom}].${bound}`,
          label: `${label}, ${bound === 'min' ? 'lower' : 'upper'} limit`,
          optional: true,
          decimals: variable === 'theta' ? ANGLE_DECIMALS : undefined,
          write: (doc, value) => edits.setLimit(doc, { chain, joint, freedom, freedoms: freedoms(joint) }, bound, value),
        }),
      );
      const fields = [start, ...bounds];
      fields.forEach((field, column) => {
        field.dataset.column = ['start', 'min', 'max'][column];
      });
      return element(
        'tr',
        {},
        element('th', { scope: 'row' }, element('var', {}, name), element('small', {}, unitName)),
        element('td', { class: 'now' }, now),
        ...fields.map((field) => element('td', {}, field)),
      );
    });
    return scroller(
      element(
        'table',
        { class: 'start' },
        element('caption', { class: 'sr' }, `Joint variables of chain ${chain + 1}`),
        element('thead', {}, element('tr', {}, element('td', {}), ...['now', 'start', 'min', 'max'].map((head) => element('th', { scope: 'col' }, head)))),
        element('tbody', { 'data-path': `chains[${chain}].start` }, ...rows),
      ),
    );
  }

  /** @param {number} chain */
  function chainSection(chain) {
    const name = cells.input({ path: `chains[${chain}].name`, label: `name of chain ${chain + 1}`, text: true });
    const { chains } = store.doc;
    const type = typeField(panel, store, defaults, chain);
    const details = element(
      'details',
      {
        open: unfolded.has(chain),
        toggle: () => {
          if (details.open) unfolded.add(chain);
          else unfolded.delete(chain);
          showNow();
        },
      },
      element('summary', {}, 'Start values and limits'),
      startTable(chain),
      element('button', { class: 'quiet edits', title: 'Let the planner look for start values that close the loops, in every chain', click: findStart }, 'find a start'),
    );
    return element(
      'section',
      { class: 'chain', 'data-path': `chains[${chain}]`, 'data-chain': chain },
      element(
        'header',
        {},
        element('h3', {}, name, type.field),
        arrange.menu(`chains[${chain}]`, `chain ${chain + 1}`, () => [
          { label: 'Add a joint', act: () => store.edit((doc) => edits.insertJoint(doc, chain, chains[chain].joints.length, defaults.joints.R)) },
          { label: 'Duplicate', act: () => store.edit((doc) => edits.duplicateChain(doc, chain)) },
          { label: 'Duplicate around an axis…', act: () => forms.copies(chain) },
          { label: 'Base frame as quaternion, matrix…', act: () => forms.turn(`chains[${chain}].base`, `the base frame of chain ${chain + 1}`) },
          { label: 'Gripper frame as quaternion, matrix…', act: () => forms.turn(`chains[${chain}].gripper`, `the gripper frame of chain ${chain + 1}`) },
          { label: 'Remove', disabled: chains.length === 1 ? 'A linkage has at least one chain' : '', act: () => store.edit((doc) => edits.removeChain(doc, chain)) },
        ]),
      ),
      type.note,
      dhTable(chain),
      framesTable(chain),
      details,
    );
  }

  /** The joint values that are shown, of the playhead's frame or of a posture in its place, where they are unfolded. */
  function showNow() {
    const { motion } = store.result;
    const now = shown(store);
    if (!motion || !now) return;
    const joints = groupAt(now.joints, now);
    let at = 0;
    motion.report.chains.forEach(({ variables }, chain) => {
      variables.forEach(({ unit: kind }, index) => {
        const value = joints[at++];
        const output = nows[chain]?.[index];
        if (output && unfolded.has(chain)) setText(output, kind === 'rad' ? short(degrees(value), ANGLE_DECIMALS) : short(value));
      });
    });
  }

  return {
    /** Builds the tables anew: the document has another shape. */
    rebuild() {
      nows = [];
      const { chains } = store.doc;
      const unitOfLength = unitField(panel, store, say);
      panel.replaceChildren(
        element(
          'div',
          { class: 'heads' },
          element('label', { class: 'field' }, element('span', {}, 'Name'), cells.input({ path: 'name', label: 'name of the mechanism', text: true })),
          element('label', { class: 'field' }, element('span', {}, 'Unit of length'), unitOfLength.field),
        ),
        unitOfLength.choice,
        element('h2', { class: 'sr' }, 'Chains'),
        element('div', { 'data-path': 'chains' }, ...chains.map((_, index) => chainSection(index))),
        element('button', { class: 'wide', click: () => store.edit((doc) => edits.addChain(doc, defaults.chain)) }, '+ chain'),
      );
    },
    showNow,
  };
}

/** @param {number[]} values @param {number} count */
const filled = (values, count) => Array.from({ length: count }, (_, i) => values[i] ?? 0);

/** A table wider than a phone scrolls inside its own frame. @param {HTMLElement} table */
const scroller = (table) => element('div', { class: 'scroller' }, table);

/**
 * The rows, base and gripper that a chain by its axes stands for, to be looked at and copied.
 */
import { short } from '../../core/format.js';
import { copyText } from '../../ui/copy.js';
import { element, setText } from '../../ui/dom.js';
import { blockText } from './block-text.js';
import { rowsTable } from './convention-form.js';
import { openFormDialog } from './form-dialog.js';

const FRAME = /** @type {const} */ (['x', 'y', 'z', 'longitude', 'latitude', 'roll']);

/**
 * @param {HTMLElement} root holds the tables
 * @param {import('../../core/store.js').Store} store
 * @param {number} index of the chain
 */
export function openRowsForm(root, store, index) {
  const { plain } = store.result;
  const chain = plain?.chains[index];
  const told = element('p', { class: 'muted', role: 'status' });
  if (!plain || !chain) {
    openFormDialog(root, { title: 'Rows', body: [element('p', {}, 'The chain has no rows yet: the document is at fault.')], apply: '', act: () => true, readonly: true });
    return;
  }
  const frames = /** @type {const} */ (['base', 'gripper']);
  const number = (/** @type {unknown} */ value) => Number(value ?? 0);
  const framesTable = element(
    'table',
    { class: 'shown-rows' },
    element('thead', {}, element('tr', {}, element('td'), ...FRAME.map((name) => element('th', { scope: 'col' }, name)))),
    element('tbody', {}, ...frames.map((name) => element('tr', {}, element('th', { scope: 'row' }, name), ...FRAME.map((part) => element('td', {}, short(number(chain[name]?.[part]))))))),
  );
  const blocks = {
    'the rows': () => chain.joints.flatMap(({ rows = [] }) => rows.map(({ alpha, a, theta, d }) => [alpha, a, theta, d].map((value) => String(number(value))))),
    'base and gripper': () => frames.map((name) => FRAME.map((part) => String(number(chain[name]?.[part])))),
  };
  const copies = Object.entries(blocks).map(([what, rows]) =>
    element('button', {
      type: 'button',
      async click() {
        const copied = await copyText(blockText(rows()));
        setText(told, copied ? `Copied: ${what}, in whole numbers.` : 'The browser does not let this page copy.');
      },
    }, `Copy ${what}`),
  );
  openFormDialog(root, {
    title: `Rows of chain ${index + 1}`,
    body: [
      element('p', {}, 'What the points and directions of this chain stand for; angles in degrees. “Turn into rows” in the chain’s menu makes it the table that is edited.'),
      rowsTable(chain, 'modified (Craig): X·Z', plain),
      element('div', { class: 'scroller' }, framesTable),
      element('p', { class: 'form-buttons' }, ...copies),
      told,
    ],
    apply: '',
    act: () => true,
    readonly: true,
  });
}

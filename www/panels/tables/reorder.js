/**
 * Putting things in another order: chains, the joints of a chain, key frames; from their menus, and with Alt and the
 * arrows from any of their cells.
 *
 * @typedef {import('../../core/store.js').Store} Store
 * @typedef {import('../../ui/menu.js').MenuItem} MenuItem
 */
import * as edits from '../../core/edits.js';
import { valueAt } from '../../core/path.js';
import { KEYS } from '../../ui/keys.js';
import { menuButton } from '../../ui/menu.js';

/** A thing in a list that a person may arrange: the list's path and the thing's index. */
const THING = /^(chains\[(\d+)\]\.joints|chains|motion\.key_frames)\[(\d+)\]$/;

/**
 * @param {HTMLElement} root holds the tables
 * @param {Store} store
 */
export function createArrange(root, store) {
  /** @param {string} path of a thing @param {number} step @returns {boolean} whether there is room that way */
  function canMove(path, step) {
    const [, list, , index] = THING.exec(path) ?? [];
    const to = Number(index) + step;
    return !store.readonly && list !== undefined && to >= 0 && to < valueAt(store.doc, list).length;
  }

  /** @param {string} path @param {number} step */
  function move(path, step) {
    const [, list, chain, index] = THING.exec(path) ?? [];
    if (!canMove(path, step)) return;
    const from = Number(index);
    const to = from + step;
    store.edit((doc) => {
      if (list === 'chains') return edits.moveChain(doc, from, to);
      if (list === 'motion.key_frames') return edits.moveKeyFrame(doc, from, to);
      return edits.moveJoint(doc, Number(chain), from, to);
    });
    store.setView({ selected: `${list}[${to}]` });
  }

  /** Gives the focus back to a thing's menu, which its edit may have made anew. @param {string} path */
  const focusMenu = (path) => /** @type {HTMLElement | null} */ (root.querySelector(`[data-menu="${path}"]`))?.focus();

  root.addEventListener('keydown', (event) => {
    const step = { ArrowUp: -1, ArrowDown: 1 }[event.key];
    if (!step || !event.altKey || event.ctrlKey || event.metaKey) return;
    const field = /** @type {HTMLElement} */ (event.target);
    /** @type {HTMLElement | null} */
    let thing = field.closest('[data-path]');
    while (thing && !THING.test(thing.dataset.path ?? '')) thing = thing.parentElement?.closest('[data-path]') ?? null;
    const path = thing?.dataset.path;
    if (!path) return;
    event.preventDefault();
    event.stopPropagation();
    if (!canMove(path, step)) return;
    const [, list, , index] = /** @type {RegExpExecArray} */ (THING.exec(path));
    const next = `${list}[${Number(index) + step}]`;
    const own = field.dataset.path ?? field.dataset.menu ?? '';
    move(path, step);
    // The hand stays at the same cell of the thing that moved.
    const there = own.replace(path, next);
    /** @type {HTMLElement | null} */ (root.querySelector(`[data-path="${there}"]:is(input, select), [data-menu="${there}"]`))?.focus();
  });

  /** @param {string} path @returns {MenuItem[]} */
  const movers = (path) =>
    [-1, 1].map((step) => ({
      label: step < 0 ? 'Move up' : 'Move down',
      key: KEYS.reorder.keys[step < 0 ? 0 : 1],
      disabled: canMove(path, step) ? '' : store.readonly ? 'This linkage is read only' : step < 0 ? 'It is the first' : 'It is the last',
      act: () => {
        const [, list, , index] = /** @type {RegExpExecArray} */ (THING.exec(path));
        move(path, step);
        focusMenu(`${list}[${Number(index) + step}]`);
      },
    }));

  return {
    /**
     * The button with everything that can be done with a thing, moving it included.
     * @param {string} path
     * @param {string} name "chain 2", for screen readers
     * @param {() => Exclude<MenuItem, 'line'>[]} more what else can be done
     */
    menu(path, name, more) {
      const button = menuButton(`Actions of ${name}`, () => [
        ...movers(path),
        'line',
        ...more().map(({ act, ...item }) => ({
          ...item,
          act: () => {
            act();
            if (!button.isConnected) focusMenu(path);
          },
        })),
      ]);
      button.classList.add('quiet');
      button.dataset.menu = path;
      button.setAttribute('aria-label', `Actions of ${name}`);
      button.title = `Actions of ${name}`;
      button.textContent = '⋯';
      return button;
    },
  };
}

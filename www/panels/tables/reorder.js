/**
 * Putting things in another order: chains, the joints of a chain, key frames; from their menus, and with Alt and the
 * arrows from any of their cells.
 *
 * @typedef {import('../../core/store.js').Store} Store
 * @typedef {import('../../ui/menu.js').MenuItem} MenuItem
 * @typedef {{path: string, more: () => Exclude<MenuItem, 'line'>[]}} Thing with what can be done with it beside moving it
 */
import * as edits from '../../core/edits.js';
import { valueAt } from '../../core/path.js';
import { focusBeside } from '../../ui/dom.js';
import { KEYS, onKeys } from '../../ui/keys.js';
import { attachMenu } from '../../ui/menu.js';
import { attach, html } from '../../ui/render.js';

/** A thing in a list that a person may arrange: the list's path and the thing's index. */
const THING = /^(chains\[(\d+)\]\.joints|chains|motion\.key_frames)\[(\d+)\]$/;

/**
 * @param {HTMLElement} root holds the tables
 * @param {Store} store
 * @param {(target: Element) => void} bringOut from under the view, which stays on top of the tables on a phone
 */
export function createArrange(root, store, bringOut) {
  /** @param {string} path of a thing @param {number} step @returns {boolean} whether there is room that way */
  function canMove(path, step) {
    const [, list, , index] = THING.exec(path) ?? [];
    const to = Number(index) + step;
    return !store.readonly && list !== undefined && to >= 0 && to < valueAt(store.doc, list).length;
  }

  /** @param {string} path @param {number} step */
  async function move(path, step) {
    const [, list, chain, index] = THING.exec(path) ?? [];
    if (!canMove(path, step)) return;
    const from = Number(index);
    const to = from + step;
    // Their table has loaded it.
    const { moveKeyFrame } = list === 'motion.key_frames' ? await import('../../core/key-frame-edits.js') : { moveKeyFrame: null };
    store.edit((doc) => {
      if (list === 'chains') return edits.moveChain(doc, from, to);
      if (moveKeyFrame) return moveKeyFrame(doc, from, to);
      return edits.moveJoint(doc, Number(chain), from, to);
    });
    store.setView({ selected: `${list}[${to}]` });
    // The focus goes with its thing, in the same cell or button.
    const focused = focusBeside(root);
    if (!focused || !root.contains(focused)) return;
    focused.scrollIntoView({ block: 'nearest' });
    bringOut(focused);
  }

  onKeys(root, {
    reorder(event, at) {
      const field = /** @type {HTMLElement} */ (event.target);
      /** @type {HTMLElement | null} */
      let thing = field.closest('[data-path]');
      while (thing && !THING.test(thing.dataset.path ?? '')) thing = thing.parentElement?.closest('[data-path]') ?? null;
      const path = thing?.dataset.path;
      if (!path) return false;
      event.stopPropagation();
      move(path, at ? 1 : -1);
    },
  });

  /** @param {string} path @returns {MenuItem[]} */
  const movers = (path) =>
    [-1, 1].map((step) => ({
      label: step < 0 ? 'Move up' : 'Move down',
      key: KEYS.reorder.keys[step < 0 ? 0 : 1],
      disabled: canMove(path, step) ? '' : store.readonly ? 'This linkage is read only' : step < 0 ? 'It is the first' : 'It is the last',
      act: () => move(path, step),
    }));

  const menuOf = (/** @type {string} */ path) => /** @type {HTMLElement | null} */ (root.querySelector(`[data-menu="${path}"]`));

  /** Gives a thing's button its menu. @param {HTMLButtonElement} button @returns {(now: Thing) => void} */
  function behave(button) {
    /** @type {Thing} */
    let thing;
    attachMenu(button, () => {
      const { path, more } = thing;
      return [
        ...movers(path),
        'line',
        ...more().map(({ act, ...item }) => ({
          ...item,
          act: () => {
            act();
            // Of a thing that went, the focus goes to the one in its place, or to the one before it.
            if (!button.isConnected) (menuOf(path) ?? menuOf(path.replace(/\d+(?=]$)/, (index) => String(Number(index) - 1))))?.focus();
          },
        })),
      ];
    });
    return (now) => {
      thing = now;
    };
  }

  return {
    /**
     * The button with everything that can be done with a thing, moving it included.
     * @param {string} path
     * @param {string} name "chain 2", for screen readers
     * @param {() => Exclude<MenuItem, 'line'>[]} more what else can be done
     */
    menu(path, name, more) {
      return html`<button class="menu-button quiet" data-menu=${path} title="Actions of ${name}" aria-label="Actions of ${name}" ${attach(behave, { path, more })}>⋯</button>`;
    },
  };
}

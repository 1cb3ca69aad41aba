/**
 * The object tree: what the mechanism and its motion are made of. Selecting here selects everywhere; Enter goes to the
 * thing's table. By the ARIA pattern of trees: arrows, Home, End and letters go through it.
 *
 * @typedef {{path: string, name: string, more?: string, children?: Item[]}} Item
 */
import { element, focusBeside } from '../ui/dom.js';
import { onKeys } from '../ui/keys.js';
import { atRest } from '../core/at-rest.js';
import { chainName } from '../core/chain-name.js';
import { hasDrivers } from '../core/driven.js';
import { plural } from '../core/format.js';
import { keyFramesOf } from '../core/key-frames.js';
import { same } from '../core/spread.js';
import { html, nothing, render, repeat } from '../ui/render.js';
import { jointOf, chainType } from '../core/joint-types.js';

/** At most so many key frames are listed. */
const MOST = 100;
/** The path of the item that stands for the others. */
const MORE = 'motion.key_frames';

/** Whether an item stands for several things, none of which it is. @param {string} path */
const isNoThing = (path) => path === 'motion' || path === MORE;

/** @param {import('../core/types.js').MechanismDocument} doc @returns {Item[]} */
function itemsOf(doc) {
  const { chains, motion } = doc;
  const keys = keyFramesOf(doc);
  return [
    ...chains.map((chain, c) => {
      const path = `chains[${c}]`;
      return {
        path,
        name: chainName(chain, c),
        more: chainType(chain),
        children: [
          { path: `${path}.base`, name: 'base', more: `G${c + 1}` },
          ...chain.joints.map(({ type }, j) => ({ path: `${path}.joints[${j}]`, name: `joint ${j + 1}`, more: `${type} ${jointOf(type)?.name ?? ''}` })),
          { path: `${path}.gripper`, name: 'gripper', more: `H${c + 1}` },
        ],
      };
    }),
    { path: 'workpiece', name: 'workpiece' },
    {
      path: 'motion',
      name: 'motion',
      more: hasDrivers(doc) ? plural((motion.drivers ?? []).length, 'driven joint') : `${keys.length} key frames`,
      children: hasDrivers(doc) ? driversOf(doc) : listed(keys),
    },
  ];
}

/** The first ones, and how many more there are: all are in the table. @param {import('../core/types.js').KeyFrame[]} keys @returns {Item[]} */
function listed(keys) {
  const first = keys.slice(0, keys.length > MOST ? MOST - 1 : MOST).map((key, k) => ({ path: `motion.key_frames[${k}]`, name: key.name || `key frame ${k + 1}` }));
  const more = keys.length - first.length;
  return more ? [...first, { path: MORE, name: `${more} more`, more: 'in the table of key frames' }] : first;
}

/** @param {import('../core/types.js').MechanismDocument} doc @returns {Item[]} */
const driversOf = (doc) => (doc.motion.drivers ?? []).map(({ chain, joint }, d) => ({ path: `motion.drivers[${d}]`, name: `driver ${d + 1}`, more: `chain ${chain}, joint ${joint}` }));

/**
 * @param {HTMLDetailsElement} place
 * @param {Pick<import('../element/workbench.js').App, 'store' | 'narrow'>} app
 * @param {(path: string) => void} enter goes to a thing's table
 */
export function createTree(place, { store, narrow }, enter) {
  const tree = element('ul', { role: 'tree', 'aria-label': 'Objects', class: 'tree' });
  place.append(tree);
  // Where there is room for it beside the tables.
  place.open = !narrow() && matchMedia('(min-width: 1100px) and (min-height: 780px)').matches;
  /** Paths of the branches that are open. @type {Set<string>} */
  const open = new Set();
  /** The item that Tab comes to. */
  let stop = '';
  let items = itemsOf(store.doc);

  const seen = () => items.flatMap((item) => [item, ...(open.has(item.path) ? (item.children ?? []) : [])]);
  const branchOf = (/** @type {string} */ path) => items.find(({ children }) => children?.some((child) => child.path === path));
  const nodeOf = (/** @type {string} */ path) => /** @type {HTMLElement | null} */ (tree.querySelector(`[data-item="${path}"]`));
  const pathOf = (/** @type {EventTarget | null} */ target) =>
    /** @type {HTMLElement | null} */ (/** @type {Element} */ (target).closest('[role=treeitem]'))?.dataset.item;

  /**
   * An item and its children, one after the other: a flat tree, whose levels are said, so that an item's name is its own.
   * @param {Item} item @param {number} index @param {Item[]} siblings @param {string} [branch] path of the item above
   * @returns {unknown[]}
   */
  const rows = ({ path, name, more, children }, index, siblings, branch) => [
    {
      path,
      row: html`<li
        role="treeitem"
        data-item=${path}
        tabindex=${path === stop ? 0 : -1}
        class=${path === store.view.hovered ? 'pointed' : nothing}
        aria-selected=${path === store.view.selected}
        aria-level=${branch ? 2 : 1}
        aria-posinset=${index + 1}
        aria-setsize=${siblings.length}
        aria-expanded=${children ? open.has(path) : nothing}
        ?hidden=${branch !== undefined && !open.has(branch)}
      >${children ? html`<span class="arrow" aria-hidden="true">${open.has(path) ? '▾' : '▸'}</span>` : nothing}${name}${more ? html` <small>${more}</small>` : nothing}</li>`,
    },
    ...(children ?? []).flatMap((child, at, all) => rows(child, at, all, path)),
  ];

  function draw() {
    const all = /** @type {{path: string, row: unknown}[]} */ (items.flatMap((item, index) => rows(item, index, items)));
    if (!all.some(({ path }) => path === stop)) {
      stop = items[0].path;
      // What had the focus is no more: it goes to where Tab would come, not out of the tree.
      const focused = tree.contains(focusBeside(tree));
      draw();
      if (focused) nodeOf(stop)?.focus();
      return;
    }
    render(repeat(all, ({ path }) => path, ({ row }) => row), tree);
  }

  /** @param {string} path @param {boolean} on */
  function expand(path, on) {
    if (on) open.add(path);
    else open.delete(path);
    draw();
  }

  /** @param {Item | undefined} item */
  function go(item) {
    if (!item) return;
    stop = item.path;
    draw();
    nodeOf(stop)?.focus();
  }

  /** @param {string} path */
  function select(path) {
    stop = path;
    store.setView({ selected: isNoThing(path) ? '' : path });
    draw();
  }

  tree.addEventListener('click', ({ target }) => {
    const path = pathOf(target);
    if (path === undefined) return;
    if (items.some((item) => item.path === path && item.children)) expand(path, !open.has(path));
    select(path);
    nodeOf(path)?.focus();
  });
  tree.addEventListener('pointerover', ({ target, pointerType }) => {
    const path = pathOf(target);
    if (pointerType === 'mouse') store.setView({ hovered: path === undefined || isNoThing(path) ? '' : path });
  });
  tree.addEventListener('pointerleave', () => store.setView({ hovered: '' }));
  /** On an item, and then for nobody else. @param {(path: string, arrow: number) => void} act @returns {import('../ui/keys.js').Handler} */
  const onItem = (act) => (event, at) => {
    const path = pathOf(event.target);
    if (path === undefined) return false;
    event.stopPropagation();
    act(path, at);
  };
  onKeys(tree, {
    object: onItem((path, arrow) => {
      const all = seen();
      const at = all.findIndex((item) => item.path === path);
      const closed = all[at].children && !open.has(path);
      const acts = [
        () => (open.has(path) ? expand(path, false) : go(branchOf(path))),
        () => (closed ? expand(path, true) : open.has(path) && go(all[at + 1])),
        () => go(all[at - 1]),
        () => go(all[at + 1]),
      ];
      acts[arrow]();
    }),
    chooseObject: onItem(select),
    enterObject: onItem((path) => {
      select(path);
      enter(path);
    }),
  });
  // Keys that every tree has.
  tree.addEventListener('keydown', (event) => {
    const path = pathOf(event.target);
    if (path === undefined || event.ctrlKey || event.metaKey || event.altKey) return;
    const all = seen();
    const at = all.findIndex((item) => item.path === path);
    if (event.key === 'Home') go(all[0]);
    else if (event.key === 'End') go(all[all.length - 1]);
    else if (/^\p{L}$/u.test(event.key)) {
      const from = [...all.slice(at + 1), ...all.slice(0, at + 1)];
      go(from.find(({ name }) => name.toLowerCase().startsWith(event.key.toLowerCase())));
    } else return;
    event.preventDefault();
    event.stopPropagation();
  });

  /** The item that is selected, here or elsewhere, is marked, and its branch is opened. @param {string} selected */
  function mark(selected) {
    const branch = branchOf(selected);
    if (branch) open.add(branch.path);
    if (branch || items.some(({ path }) => path === selected)) stop = selected;
    draw();
    reveal(nodeOf(selected));
  }

  /** Scrolls the tree's own box only: the page stays where it is. @param {HTMLElement | null} item */
  function reveal(item) {
    if (!item) return;
    const box = tree.getBoundingClientRect();
    const row = item.getBoundingClientRect();
    if (row.top < box.top) tree.scrollTop += row.top - box.top;
    if (row.bottom > box.bottom) tree.scrollTop += row.bottom - box.bottom;
  }

  atRest(store, ['document'], () => {
    const next = itemsOf(store.doc);
    // Most edits are of numbers, which it does not list.
    if (same(next, items)) return;
    items = next;
    draw();
  });
  store.select(({ view }) => view.selected, mark);
  store.select(({ view }) => view.hovered, draw);
  mark(store.view.selected);
}

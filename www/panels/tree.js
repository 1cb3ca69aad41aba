/**
 * The object tree: what the mechanism and its motion are made of. Selecting here selects everywhere; Enter goes to the
 * thing's table. By the ARIA pattern of trees: arrows, Home, End and letters go through it.
 *
 * @typedef {{path: string, name: string, more?: string, children?: Item[]}} Item
 */
import { element, focusBeside } from '../ui/dom.js';
import { chainName } from '../core/chain-name.js';
import { JOINT_TYPES, chainType } from '../core/joint-types.js';

/** @param {import('../core/types.js').MechanismDocument} doc @returns {Item[]} */
function itemsOf({ chains, motion }) {
  return [
    ...chains.map((chain, c) => {
      const path = `chains[${c}]`;
      return {
        path,
        name: chainName(chain, c),
        more: chainType(chain),
        children: [
          { path: `${path}.base`, name: 'base', more: `G${c + 1}` },
          ...chain.joints.map(({ type }, j) => ({ path: `${path}.joints[${j}]`, name: `joint ${j + 1}`, more: `${type} ${JOINT_TYPES[type]?.name ?? ''}` })),
          { path: `${path}.gripper`, name: 'gripper', more: `H${c + 1}` },
        ],
      };
    }),
    { path: 'workpiece', name: 'workpiece' },
    {
      path: 'motion',
      name: 'motion',
      more: `${motion.key_frames.length} key frames`,
      children: motion.key_frames.map((key, k) => ({ path: `motion.key_frames[${k}]`, name: key.name || `key frame ${k + 1}` })),
    },
  ];
}

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
  /** @type {Set<string>} */
  const open = new Set();
  let shape = '';
  /** The item that Tab comes to. */
  let stop = '';

  const nodes = () => /** @type {HTMLElement[]} */ ([...tree.querySelectorAll('[role=treeitem]')]);
  const seen = () => nodes().filter((node) => !node.hidden);
  const nodeOf = (/** @type {string} */ path) => nodes().find((node) => node.dataset.item === path);

  /**
   * An item and its children, one after the other: a flat tree, whose levels are said, so that an item's name is its own.
   * @param {Item[]} items @param {string} [branch] path of the item above @returns {HTMLElement[]}
   */
  const flat = (items, branch) =>
    items.flatMap(({ path, name, more, children }, index) => [
      element(
        'li',
        {
          role: 'treeitem', 'data-item': path, 'data-branch': branch, tabindex: -1, 'aria-selected': 'false', 'aria-level': branch ? 2 : 1,
          'aria-posinset': index + 1, 'aria-setsize': items.length, 'aria-expanded': children ? String(open.has(path)) : undefined,
          hidden: branch !== undefined && !open.has(branch),
        },
        name,
        more ? ' ' : '',
        more ? element('small', {}, more) : '',
      ),
      ...(children ? flat(children, path) : []),
    ]);

  /** @param {HTMLElement} item @param {boolean} on */
  function expand(item, on) {
    const path = item.dataset.item ?? '';
    if (!item.hasAttribute('aria-expanded')) return;
    if (on) open.add(path);
    else open.delete(path);
    item.setAttribute('aria-expanded', String(on));
    for (const child of nodes()) if (child.dataset.branch === path) child.hidden = !on;
  }

  /** @param {HTMLElement | undefined} item */
  function go(item) {
    if (!item) return;
    setStop(item.dataset.item ?? '');
    item.focus();
  }

  /** @param {string} path */
  function setStop(path) {
    stop = path;
    for (const item of nodes()) item.tabIndex = item.dataset.item === path ? 0 : -1;
  }

  /** @param {HTMLElement} item */
  function select(item) {
    setStop(item.dataset.item ?? '');
    store.setView({ selected: item.dataset.item === 'motion' ? '' : item.dataset.item });
  }

  tree.addEventListener('click', ({ target }) => {
    const item = /** @type {HTMLElement | null} */ (/** @type {Element} */ (target).closest('[role=treeitem]'));
    if (!item) return;
    expand(item, item.getAttribute('aria-expanded') !== 'true');
    select(item);
    item.focus();
  });
  tree.addEventListener('pointerover', ({ target, pointerType }) => {
    const path = /** @type {HTMLElement | null} */ (/** @type {Element} */ (target).closest('[role=treeitem]'))?.dataset.item;
    if (pointerType === 'mouse') store.setView({ hovered: path === 'motion' ? '' : path });
  });
  tree.addEventListener('pointerleave', () => store.setView({ hovered: '' }));
  tree.addEventListener('keydown', (event) => {
    const item = /** @type {HTMLElement | null} */ (/** @type {Element} */ (event.target).closest('[role=treeitem]'));
    if (!item || event.ctrlKey || event.metaKey || event.altKey) return;
    const all = seen();
    const at = all.indexOf(item);
    const expanded = item.getAttribute('aria-expanded');
    if (event.key === 'ArrowDown') go(all[at + 1]);
    else if (event.key === 'ArrowUp') go(all[at - 1]);
    else if (event.key === 'Home') go(all[0]);
    else if (event.key === 'End') go(all[all.length - 1]);
    else if (event.key === 'ArrowRight' && expanded === 'false') expand(item, true);
    else if (event.key === 'ArrowRight' && expanded === 'true') go(all[at + 1]);
    else if (event.key === 'ArrowLeft' && expanded === 'true') expand(item, false);
    else if (event.key === 'ArrowLeft') go(nodeOf(item.dataset.branch ?? ''));
    else if (event.key === ' ') select(item);
    else if (event.key === 'Enter') {
      select(item);
      enter(item.dataset.item ?? '');
    } else if (/^\p{L}$/u.test(event.key)) {
      const from = [...all.slice(at + 1), ...all.slice(0, at + 1)];
      go(from.find((other) => other.textContent?.toLowerCase().startsWith(event.key.toLowerCase())));
    } else return;
    event.preventDefault();
    event.stopPropagation();
  });

  function build() {
    const items = itemsOf(store.doc);
    const next = JSON.stringify(items);
    if (next === shape) return;
    shape = next;
    const focused = tree.contains(focusBeside(tree));
    tree.replaceChildren(...flat(items));
    setStop(nodeOf(stop) ? stop : items[0].path);
    if (focused) nodeOf(stop)?.focus();
    mark();
  }

  /** The item that is selected, here or elsewhere, is marked, and its branch is opened. */
  function mark() {
    const { selected, hovered } = store.view;
    for (const item of nodes()) {
      const on = item.dataset.item === selected;
      item.classList.toggle('pointed', item.dataset.item === hovered);
      if ((item.getAttribute('aria-selected') === 'true') === on) continue;
      item.setAttribute('aria-selected', String(on));
      if (!on) continue;
      const branch = nodeOf(item.dataset.branch ?? '');
      if (branch) expand(branch, true);
      setStop(selected);
      // In its own box only: the page stays where it is.
      const box = tree.getBoundingClientRect();
      const row = item.getBoundingClientRect();
      if (row.top < box.top) tree.scrollTop += row.top - box.top;
      if (row.bottom > box.bottom) tree.scrollTop += row.bottom - box.bottom;
    }
  }
  store.subscribe('document', build);
  store.subscribe('view', mark);
  build();
}

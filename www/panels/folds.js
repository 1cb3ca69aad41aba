/**
 * Panels beside the view that can be folded away, each by a button at the edge of the view; and the view alone, with nothing
 * but its animation bar.
 */
import { setText } from '../ui/dom.js';
import { KEYS, keyTip, onKeys } from '../ui/keys.js';
import { recall, remember } from '../ui/kept-layout.js';

const SIDES = /** @type {const} */ (['tables', 'info']);

/** Screens whose lesser side is below this are phones, in pixels: held across, one has no room for tables beside the view. */
const PHONE = 480;

/** What takes letters itself. */
const TAKES_LETTERS = 'input:not([type=range]), select, textarea';

/** @param {Pick<import('../element/workbench.js').App, 'find' | 'root' | 'store' | 'keys' | 'signal'>} app */
export function createFolds({ find, root, store, keys, signal }) {
  const frame = find('frame');
  const button = find('view-only');
  const kept = recall();
  const open = { tables: true, info: kept.info ?? true };

  /** Nothing that is hidden keeps the focus. @param {() => void} change @param {HTMLElement} next takes it then */
  function keepFocus(change, next) {
    const at = root.activeElement;
    change();
    if (at && !at.checkVisibility()) next.focus();
  }

  /** @param {(typeof SIDES)[number]} side @param {boolean} isOpen */
  function set(side, isOpen) {
    open[side] = isOpen;
    const fold = find(`fold-${side}`);
    keepFocus(() => frame.classList.toggle(`no-${side}`, !isOpen), fold);
    fold.setAttribute('aria-expanded', String(isOpen));
  }

  for (const side of SIDES) {
    set(side, open[side]);
    find(`fold-${side}`).addEventListener('click', () => {
      set(side, (kept[side] = !open[side]));
      remember({ [side]: open[side] });
    });
  }
  // A screen may itself be unfolded.
  const fit = () => set('tables', kept.tables ?? Math.min(screen.width, screen.height) >= PHONE);
  addEventListener('resize', fit, { signal });
  fit();

  const turn = () => store.setView({ only: !store.view.only });
  const showOnly = () => {
    const { only } = store.view;
    keepFocus(() => frame.classList.toggle('only', only), find('canvas'));
    button.setAttribute('aria-pressed', String(only));
    return only;
  };
  showOnly();
  store.select(({ view }) => view.only, () => {
    const only = showOnly();
    setText(find('view-live'), only ? `Only the view and the animation bar are shown. ${KEYS.allPanels.keys[0]} brings the rest back.` : 'The panels are back.');
  });
  button.addEventListener('click', turn);
  keyTip(button, 'Only the view and the animation bar', 'viewOnly');
  onKeys(find('stage'), { viewOnly: ({ target }) => (/** @type {Element} */ (target).closest(TAKES_LETTERS) ? false : turn()) });
  onKeys(
    keys,
    {
      allPanels: () => (!store.view.only || [root, document].some((tree) => tree.querySelector(':popover-open, dialog[open]')) ? false : turn()),
    },
    { signal },
  );

  return {
    /** Something in a panel is wanted: unfolds what holds it. It is not remembered for another visit. @param {Element} panel */
    unfold(panel) {
      store.setView({ only: false });
      const isInfo = panel === find('info');
      if (isInfo) set('info', (kept.info = true));
      // The info panel is one of the tables' tabs where there is less room.
      if (!isInfo || !find('fold-info').checkVisibility()) set('tables', (kept.tables = true));
    },
  };
}

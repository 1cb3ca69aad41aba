/**
 * The value of the expression in the cell that one is in or points at, with its unit, below the cell.
 */
import look from '../../style/parameters.css?inline';
import { expressionValue } from '../../core/expression-values.js';
import { measured } from '../../core/number-steps.js';
import { element, focusBeside, setText } from '../../ui/dom.js';
import { wear } from '../../ui/style-sheets.js';
import { floating } from './floating.js';

/** @param {HTMLElement} root holds the tables @param {import('../../core/store.js').Store} store */
export function createExpressionValue(root, store) {
  const tree = /** @type {Document | ShadowRoot} */ (root.getRootNode());
  wear(tree, look);
  const told = element('output', { class: 'expression-value', popover: 'manual', id: 'expression-value' });
  root.append(told);
  /** @type {HTMLInputElement | null} */
  let at = null;

  const expressionCell = (/** @type {EventTarget | null} */ target) => (target instanceof HTMLInputElement && target.matches('.cell[data-path]:not(.text)') ? target : null);

  function place() {
    const path = at?.dataset.path ?? '';
    const value = at?.isConnected && at.matches('.expression') ? expressionValue(store, path) : undefined;
    // What is being typed has no value yet.
    if (!at || value === undefined || at.matches('.typing')) return told.hidePopover();
    const box = at.getBoundingClientRect();
    if (tree.elementFromPoint(box.left + box.width / 2, box.top + box.height / 3) !== at) return told.hidePopover();
    setText(told, `= ${measured(store.doc, path, value)}`);
    told.showPopover();
    told.style.left = `${Math.max(4, Math.min(box.left, innerWidth - told.offsetWidth - 4))}px`;
    told.style.top = `${box.bottom + 1}px`;
    // A fault is told first.
    if (!at.hasAttribute('aria-describedby')) at.setAttribute('aria-describedby', told.id);
  }
  const float = floating(told, place);

  /** @param {HTMLInputElement | null} cell */
  function show(cell) {
    if (at !== cell && at?.getAttribute('aria-describedby') === told.id) at.removeAttribute('aria-describedby');
    at = cell;
    if (at) float.begin();
    else float.end();
    place();
  }
  const focused = () => expressionCell(focusBeside(root));
  root.addEventListener('focusin', ({ target }) => show(expressionCell(target)));
  root.addEventListener('focusout', () => show(null));
  root.addEventListener('input', () => place());
  root.addEventListener('pointerover', ({ target, pointerType }) => {
    // A pointer that rests over a plain number takes nothing from the cell that has the focus.
    const cell = expressionCell(target);
    if (pointerType === 'mouse' && cell?.matches('.expression')) show(cell);
  });
  root.addEventListener('pointerout', ({ target }) => {
    if (target === at) show(focused());
  });
  // After the tables have shown the edit.
  store.subscribe('result', () => {
    if (at) place();
  });
  return (/** @type {Element} */ cell) => show(expressionCell(cell));
}

/**
 * A slider at the number that one points at or is in: dragged sideways it changes the number, and the motion follows. Page
 * Up and Page Down do the same from the keyboard. A drag is one step of undo; Escape takes it back. Where a cell is the name
 * of a parameter, that is what changes; an expression has no slider.
 */
import look from '../../style/slide.css?inline';
import { stepOf, stepped } from '../../core/number-steps.js';
import { valueAt } from '../../core/path.js';
import { element, focusBeside, setText } from '../../ui/dom.js';
import { KEYS, isHeld, onKeys, spokenKey } from '../../ui/keys.js';
import { wear } from '../../ui/style-sheets.js';
import { NUMBER_CELLS } from './cell-tools.js';
import { floating } from './floating.js';

/** Pixels of a drag for one step. */
const PIXELS = 4;
/** Steps at once with Shift. */
const MANY = 10;
const TIP = `Drag sideways to change the number (${KEYS.number.keys.join(', ')}); ${KEYS.slideTen.keys[0]}: ten steps`;
const EVENTS = /** @type {const} */ (['pointermove', 'pointerup', 'pointercancel']);

/**
 * @param {HTMLElement} root holds the tables
 * @param {import('../../core/store.js').Store} store
 * @param {ReturnType<typeof import('./cells.js').createCells>} cells
 * @param {import('../../ui/notice.js').Say} say
 * @returns {(cell: Element) => void} shows the slider at a cell
 */
export function createNumberSlide(root, store, cells, say) {
  const tree = /** @type {Document | ShadowRoot} */ (root.getRootNode());
  wear(tree, look);
  // What it does, the keys do too; a screen reader has the cell itself.
  const handle = element('div', { class: 'slide', popover: 'manual', 'aria-hidden': 'true', title: TIP });
  const spoken = element('p', { class: 'sr', role: 'status' });
  root.append(handle, spoken);
  /** The cell that has the slider. @type {HTMLInputElement | null} */
  let at = null;
  /** @type {{path: string, value: unknown, from: number, step: number, x: number, mark: string, over: AbortController} | null} */
  let drag = null;
  /** Counts drags and stays in cells: what belongs to one is undone in one step. */
  let marks = 0;

  const numberCell = (/** @type {EventTarget | null} */ target) => (target instanceof HTMLInputElement && target.matches(NUMBER_CELLS) ? target : null);
  const pathOf = (/** @type {HTMLInputElement | null} */ cell) => cells.source(cell?.dataset.path ?? '');
  /** One step of the number of a cell. @param {HTMLInputElement | null} cell @param {number} from */
  const stepAt = (cell, from) => stepOf(store.doc, cell?.dataset.path ?? '', from, store.result.plain ?? store.doc);

  /** @param {string} path @param {unknown} value @param {string} mark */
  const write = (path, value, mark) => store.edit((doc) => cells.written(doc, path, value === undefined || value === null ? '' : String(value)), mark);

  /** Puts the slider to its cell; out of sight where the cell is. */
  function place() {
    const box = at?.isConnected ? at.getBoundingClientRect() : null;
    const seen = box && (drag || tree.elementFromPoint(box.left + box.width / 2, box.top + box.height / 3) === at);
    if (!box || !seen) return handle.hidePopover();
    handle.showPopover();
    handle.style.left = `${box.left + (box.width - handle.offsetWidth) / 2}px`;
    handle.style.top = `${box.bottom - Math.min(5, handle.offsetHeight / 4)}px`;
  }

  const float = floating(handle, place);

  /** @param {HTMLInputElement | null} field */
  function show(field) {
    if (drag) return;
    at = field && cells.number(pathOf(field)) !== null ? field : null;
    if (at) float.begin();
    else float.end();
    handle.style.width = matchMedia('(pointer: coarse)').matches || !field ? '' : `${field.offsetWidth}px`;
    place();
  }

  /** @param {PointerEvent} event */
  function begin(event) {
    const path = pathOf(at);
    const from = path ? cells.number(path) : null;
    if (event.button !== 0 || from === null) return;
    // The cell keeps the focus, or the keyboard of a phone would come and go.
    event.preventDefault();
    handle.setPointerCapture(event.pointerId);
    handle.classList.add('dragged');
    drag = { path, value: valueAt(store.doc, path), from, step: stepAt(at, from), x: event.clientX, mark: `slide ${++marks}`, over: new AbortController() };
    onKeys(window, { oldValue: escape }, { capture: true, signal: drag.over.signal });
  }

  /** @param {PointerEvent} event */
  function move(event) {
    if (!drag) return;
    const count = Math.round((event.clientX - drag.x) / PIXELS) * (isHeld(event, 'slideTen') ? MANY : 1);
    write(drag.path, stepped(drag.from, drag.step, count), drag.mark);
    place();
  }

  /** @param {boolean} back whether the number becomes what it was */
  function end(back) {
    if (!drag) return;
    const { path, value, mark, over } = drag;
    drag = null;
    handle.classList.remove('dragged');
    over.abort();
    if (back) write(path, value, mark);
    place();
  }

  /** @param {KeyboardEvent} event */
  function escape(event) {
    event.stopPropagation();
    end(true);
  }

  handle.addEventListener('pointerdown', begin);
  for (const name of EVENTS) {
    handle.addEventListener(name, (event) => {
      if (name === 'pointermove') move(event);
      else end(name === 'pointercancel');
    });
  }
  handle.addEventListener('pointerleave', (event) => {
    if (event.relatedTarget !== at) show(numberCell(focusBeside(root)));
  });

  /** @param {KeyboardEvent} event @param {number} count of steps */
  function step({ target }, count) {
    const cell = numberCell(target);
    const path = pathOf(cell);
    const from = path ? cells.number(path) : null;
    const typed = valueAt(store.doc, path);
    if (typeof typed === 'string') say(`“${typed}” is an expression, which has no steps. Type a number or another expression, or move the slider of one of its parameters.`);
    if (from === null) return typeof typed === 'string';
    const value = stepped(from, stepAt(cell, from), count);
    write(path, value, `keys ${path} ${marks}`);
    setText(spoken, String(value));
  }
  onKeys(root, {
    number: (event, at) => step(event, at ? -1 : 1),
    numberTen: (event, at) => step(event, at ? -MANY : MANY),
  });

  /** @param {HTMLInputElement | null} field */
  function enter(field) {
    marks++;
    setText(spoken, '');
    field?.setAttribute('aria-keyshortcuts', KEYS.number.keys.map(spokenKey).join(' '));
    show(field);
  }
  root.addEventListener('focusin', ({ target }) => enter(numberCell(target)));
  root.addEventListener('focusout', () => show(null));
  root.addEventListener('pointerover', ({ target, pointerType }) => {
    const field = numberCell(target);
    if (field && pointerType === 'mouse') show(field);
  });
  root.addEventListener('pointerout', (event) => {
    if (numberCell(event.target) && event.relatedTarget !== handle) show(numberCell(focusBeside(root)));
  });
  // After the tables have shown the edit.
  store.subscribe('result', () => {
    if (at) place();
  });
  return (cell) => enter(numberCell(cell));
}

/**
 * What comes to a cell when one points at it or enters it: blocks of cells, the slider of a number, the value of an expression,
 * the drawing of a turn. Loaded then.
 */
import { onKeys } from '../../ui/keys.js';
import { parseBlock } from './block-text.js';

/** The numbers of the tables. */
export const NUMBER_CELLS = 'input.cell:not(.text)[data-path]';
/** The angles of a frame. */
export const TURN_CELLS = ['longitude', 'latitude', 'roll'].map((name) => `input[data-path$=".${name}"]:not([data-path^="parameters."])`).join(', ');

const textOf = (/** @type {ClipboardEvent} */ event) => event.clipboardData?.getData('text/plain') ?? '';

/** Whether a pasted text goes into more cells than one, and is no document. @param {ClipboardEvent} event */
const isBlock = (event) => parseBlock(textOf(event)).flat().length > 1 && !/^\s*[{[]/.test(textOf(event));

/** Within a text that is being changed, left and right go through its letters. @param {KeyboardEvent} event */
function isForLetters({ key, target }) {
  const { selectionStart, selectionEnd, value } = /** @type {HTMLInputElement} */ (target);
  return /Left|Right/.test(key) && !(selectionStart === 0 && selectionEnd === value.length);
}

/**
 * @param {HTMLElement} root holds the tables
 * @param {import('../../core/store.js').Store} store
 * @param {ReturnType<typeof import('./cells.js').createCells>} cells
 * @param {import('../../ui/notice.js').Say} say
 * @param {(path: string) => void} nameCell makes a parameter of a cell's number
 */
export function cellTools(root, store, cells, say, nameCell) {
  /**
   * @param {string} what
   * @param {(target: Element) => boolean | undefined} isWanted
   * @param {() => Promise<(cell: Element) => void>} load begins it, and gives what shows it at a cell
   * @param {import('../../ui/keys.js').KeyId[]} [keys] it answers to these: pressed while it is loaded, they are pressed once more then
   * @param {(event: ClipboardEvent) => boolean} [pastes] whether it is to paste this, likewise once it is loaded
   */
  function atFirst(what, isWanted, load, keys = [], pastes = () => false) {
    /** @param {Event} event */
    const come = async (event) => {
      // Of an event in a shadow tree the target is known only while it is dispatched.
      const target = /** @type {Element} */ (event.target);
      if (!isWanted(target)) return;
      leave();
      /** What is done once more then. @type {(() => void)[]} */
      const held = [];
      /** @param {Event} event @param {() => Event} again */
      const hold = ({ target: cell }, again) => held.push(() => /** @type {Element} */ (cell).matches(':focus') && cell?.dispatchEvent(again()));
      const holdKey = (/** @type {KeyboardEvent} */ event) => isWanted(/** @type {Element} */ (event.target)) && !isForLetters(event) && hold(event, () => new KeyboardEvent('keydown', event));
      const loading = new AbortController();
      onKeys(root, Object.fromEntries(keys.map((key) => [key, holdKey])), { signal: loading.signal, capture: true });
      const holdPaste = (/** @type {ClipboardEvent} */ event) => {
        if (!isWanted(/** @type {Element} */ (event.target)) || !pastes(event)) return;
        event.preventDefault();
        event.stopPropagation();
        // After its event a clipboard can be read no more.
        const clipboardData = new DataTransfer();
        clipboardData.setData('text/plain', textOf(event));
        hold(event, () => new ClipboardEvent('paste', { clipboardData, bubbles: true, cancelable: true, composed: true }));
      };
      root.addEventListener('paste', holdPaste, loading);
      try {
        const show = await load().finally(() => loading.abort());
        // In the meantime one may be elsewhere.
        if (target.matches(':hover, :focus')) show(target);
        for (const again of held) again();
      } catch (error) {
        say(`${what} could not be loaded (${error instanceof Error ? error.message : error}). The next cell that is entered tries again.`);
        root.addEventListener('focusin', come);
      }
    };
    const leave = () => ['focusin', 'pointerover'].forEach((name) => root.removeEventListener(name, come));
    ['focusin', 'pointerover'].forEach((name) => root.addEventListener(name, come));
  }

  if (!store.readonly) {
    onKeys(root, {
      parameter({ target }) {
        const cell = /** @type {HTMLElement} */ (target);
        if (!cell.matches(NUMBER_CELLS) || cell.dataset.path?.startsWith('parameters.')) return false;
        nameCell(cell.dataset.path ?? '');
      },
    });
    atFirst('The slider of numbers', (target) => target.matches(NUMBER_CELLS), async () => (await import('./number-slide.js')).createNumberSlide(root, store, cells, say), ['number', 'numberTen']);
  }
  atFirst('Blocks of cells', (target) => target.matches('.cell'), async () => {
    (await import('./cell-block.js')).gridBlock(root, store, cells, say);
    return () => {};
  }, ['block'], (event) => !store.readonly && isBlock(event));
  atFirst('The value of expressions', (target) => target.matches(NUMBER_CELLS), async () => (await import('./expression-value.js')).createExpressionValue(root, store));
  atFirst('The drawing of turns', (target) => target.matches(TURN_CELLS), async () => (await import('./turn-drawing.js')).createTurnDrawing(root));
}

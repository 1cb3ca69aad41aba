/**
 * What comes to a cell when one points at it or enters it: the slider of a number, the value of an expression, the drawing of
 * a turn. Loaded then.
 */
import { onKeys } from '../../ui/keys.js';

/** The numbers of the tables. */
export const NUMBER_CELLS = 'input.cell:not(.text)[data-path]';
/** The angles of a frame. */
export const TURN_CELLS = ['longitude', 'latitude', 'roll'].map((name) => `input[data-path$=".${name}"]:not([data-path^="parameters."])`).join(', ');

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
   */
  function atFirst(what, isWanted, load, keys = []) {
    /** @param {Event} event */
    const come = async (event) => {
      // Of an event in a shadow tree the target is known only while it is dispatched.
      const target = /** @type {Element} */ (event.target);
      if (!isWanted(target)) return;
      leave();
      /** @type {KeyboardEvent[]} */
      const pressed = [];
      const hold = (/** @type {KeyboardEvent} */ event) => event.target === target && pressed.push(event);
      const loading = new AbortController();
      onKeys(root, Object.fromEntries(keys.map((key) => [key, hold])), { signal: loading.signal });
      try {
        const show = await load().finally(() => loading.abort());
        // In the meantime one may be elsewhere.
        if (target.matches(':hover, :focus')) show(target);
        if (target.matches(':focus')) for (const event of pressed) target.dispatchEvent(new KeyboardEvent('keydown', event));
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
  atFirst('The value of expressions', (target) => target.matches(NUMBER_CELLS), async () => (await import('./expression-value.js')).createExpressionValue(root, store));
  atFirst('The drawing of turns', (target) => target.matches(TURN_CELLS), async () => (await import('./turn-drawing.js')).createTurnDrawing(root));
}

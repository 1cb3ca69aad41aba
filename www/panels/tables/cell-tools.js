/**
 * What comes to a cell when one points at it or enters it: keys and blocks as in a spreadsheet, the slider of a number, the
 * drawing of a turn. Loaded then.
 */

import { isBlock } from './block-text.js';
import { gridAt } from './grid.js';

/** The numbers of the tables. */
export const NUMBER_CELLS = 'input.cell:not(.text)[data-path]';
/** The angles of a frame. */
export const TURN_CELLS = 'input[data-path$=".longitude"], input[data-path$=".latitude"], input[data-path$=".roll"]';

/**
 * @param {HTMLElement} root holds the tables
 * @param {import('../../core/store.js').Store} store
 * @param {ReturnType<typeof import('./cells.js').createCells>} cells
 * @param {import('../../ui/notice.js').Say} say
 */
export function cellTools(root, store, cells, say) {
  /**
   * @param {string} what
   * @param {(target: Element) => boolean | undefined} isWanted
   * @param {() => Promise<(cell: Element) => void>} load begins it, and gives what shows it at a cell
   */
  function atFirst(what, isWanted, load) {
    /** @param {Event} event */
    const come = async (event) => {
      // Of an event in a shadow tree the target is known only while it is dispatched.
      const target = /** @type {Element} */ (event.target);
      if (!isWanted(target)) return;
      leave();
      try {
        const show = await load();
        // In the meantime one may be elsewhere.
        if (target.matches(':hover, :focus')) show(target);
      } catch (error) {
        say(`${what} could not be loaded (${error instanceof Error ? error.message : error}). The next cell that is entered tries again.`);
        root.addEventListener('focusin', come);
      }
    };
    const leave = () => ['focusin', 'pointerover'].forEach((name) => root.removeEventListener(name, come));
    ['focusin', 'pointerover'].forEach((name) => root.addEventListener(name, come));
  }

  /** Once it is loaded. @type {Promise<(field: HTMLInputElement, text: string) => void> | null} */
  let blocks = null;
  let ready = false;
  const loadBlocks = () => {
    blocks ??= import('./cell-block.js').then(({ gridBlock }) => gridBlock(root, store, cells, say));
    blocks.then(
      () => (ready = true),
      () => (blocks = null),
    );
    return blocks;
  };
  atFirst('What chooses blocks of cells', (target) => target.matches('.cell'), async () => {
    await loadBlocks();
    return () => {};
  });
  // A key that comes before what it is for is given to it then.
  root.addEventListener('keydown', (event) => {
    const { target, key, shiftKey } = event;
    if (ready || !shiftKey || !key.startsWith('Arrow') || !(target instanceof HTMLInputElement) || !target.matches('.cell')) return;
    event.preventDefault();
    const again = new KeyboardEvent('keydown', event);
    loadBlocks().then(() => target.dispatchEvent(again), () => {
      // The next one tries again.
    });
  });
  root.addEventListener('paste', async (event) => {
    const field = event.target;
    const text = event.clipboardData?.getData('text/plain') ?? '';
    if (store.readonly || !(field instanceof HTMLInputElement) || !gridAt(field) || !isBlock(text)) return;
    event.preventDefault();
    event.stopPropagation();
    try {
      (await loadBlocks())(field, text);
    } catch (error) {
      say(`Nothing was pasted: a part of the page could not be loaded (${error instanceof Error ? error.message : error}). Try again.`);
    }
  });
  if (!store.readonly) {
    atFirst('The slider of numbers', (target) => target.matches(NUMBER_CELLS), async () => (await import('./number-slide.js')).createNumberSlide(root, store, cells));
  }
  atFirst('The drawing of turns', (target) => target.matches(TURN_CELLS), async () => (await import('./turn-drawing.js')).createTurnDrawing(root));
}

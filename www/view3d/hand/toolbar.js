/**
 * The bar over the canvas that says what is in hand and offers how to move it.
 *
 * @typedef {'move' | 'turn' | 'freedoms'} Mode
 * @typedef {ReturnType<typeof import('../../core/freedom-words.js').freedomInWords>} Freedom
 * @typedef {{mode: Mode, space: 'world' | 'local', snap: boolean}} How
 */
import { element, setText } from '../../ui/dom.js';

/** @type {[Mode, string, string][]} */
const MODES = [
  ['move', 'Move', 'Move along axes (G)'],
  ['turn', 'Turn', 'Turn about axes (R)'],
  ['freedoms', 'Freedoms', 'Move along the freedoms that exist here (D)'],
];

/**
 * @param {HTMLElement} place
 * @param {(change: Partial<How>) => void} choose
 * @param {(index: number, sign: number) => void} nudge one step along a freedom
 */
export function createDragBar(place, choose, nudge) {
  const name = element('strong', {});
  const modes = MODES.map(([mode, text, title]) =>
    element('button', { 'data-mode': mode, title, 'aria-pressed': 'false', click: () => choose({ mode }) }, text),
  );
  /** @type {How} */
  let how = { mode: 'move', space: 'world', snap: false };
  const space = element('button', { title: 'Axes of the world or its own (X)', click: () => choose({ space: how.space === 'world' ? 'local' : 'world' }) });
  const snap = element('button', { 'aria-pressed': 'false', click: () => choose({ snap: !how.snap }) });
  const list = element('ul', { class: 'freedoms', 'aria-label': 'Freedoms here' });
  const readout = element('p', { class: 'readout', 'aria-hidden': 'true' });
  const spoken = element('p', { class: 'sr', role: 'status' });
  const buttons = element('div', { class: 'drag-buttons', role: 'toolbar', 'aria-label': 'Drag' }, name, ...modes, space, snap);
  buttons.append(readout);
  const bar = element('section', { class: 'drag-bar', 'aria-label': 'In hand', hidden: true }, buttons, list, spoken);
  place.prepend(bar);

  // One stop of the Tab key; arrows go from button to button.
  const stops = [...modes, space, snap];
  buttons.addEventListener('keydown', (event) => {
    const seen = stops.filter((button) => !button.hidden);
    const at = seen.indexOf(/** @type {HTMLButtonElement} */ (event.target));
    const to = { ArrowRight: at + 1, ArrowLeft: at - 1, Home: 0, End: seen.length - 1 }[event.key];
    if (at < 0 || to === undefined) return;
    event.preventDefault();
    seen[(to + seen.length) % seen.length].focus();
  });
  buttons.addEventListener('focusin', ({ target }) => {
    for (const button of stops) button.tabIndex = button === target ? 0 : -1;
  });
  for (const button of stops.slice(1)) button.tabIndex = -1;

  /** @param {Freedom} words @param {number} index */
  function freedom(words, index) {
    const step = (/** @type {number} */ sign, /** @type {string} */ text) =>
      element('button', { 'data-way': text === '+' ? 'Forwards' : 'Backwards', click: () => nudge(index, sign) }, text);
    const item = element('li', { 'data-freedom': index }, step(-1, '−'), element('span', {}), step(1, '+'));
    label(item, words, index);
    item.addEventListener('keydown', (event) => {
      const sign = { ArrowRight: 1, ArrowUp: 1, '+': 1, '=': 1, ArrowLeft: -1, ArrowDown: -1, '-': -1 }[event.key];
      if (!sign) return;
      event.preventDefault();
      nudge(index, sign);
    });
    return item;
  }

  /** @param {HTMLElement} item @param {Freedom} words @param {number} index */
  function label(item, words, index) {
    item.title = words.whole;
    setText(item.children[1], `${index + 1} ${words.short}`);
    for (const button of item.querySelectorAll('button')) {
      button.setAttribute('aria-label', `${button.dataset.way} along freedom ${index + 1}: ${words.whole}`);
    }
  }

  /** What the list says now. */
  let listed = '';
  return {
    /**
     * @param {{name: string, how: How, steps: string, pullable: boolean, freedoms: Freedom[] | null} | null} what null: nothing is in hand;
     *   `freedoms` null: not known yet
     */
    show(what) {
      bar.hidden = !what;
      if (!what) return;
      how = what.how;
      setText(name, what.name);
      for (const button of modes) {
        button.hidden = button.dataset.mode === 'freedoms' && !what.pullable;
        button.setAttribute('aria-pressed', String(button.dataset.mode === how.mode));
      }
      const screws = how.mode === 'freedoms';
      space.hidden = snap.hidden = readout.hidden = screws;
      setText(space, how.space === 'world' ? 'World axes' : 'Own axes');
      setText(snap, `Snap ${what.steps}`);
      snap.title = `In steps of ${what.steps} (or hold Shift while dragging)`;
      snap.setAttribute('aria-pressed', String(how.snap));
      list.hidden = !screws;
      const texts = what.freedoms;
      const now = JSON.stringify(texts);
      if (!screws || !texts || now === listed) return;
      listed = now;
      // The one in use keeps the focus: its words change with every step.
      const old = /** @type {HTMLElement[]} */ ([...list.querySelectorAll('[data-freedom]')]);
      if (old.length === texts.length && texts.length) return texts.forEach((words, index) => label(old[index], words, index));
      list.replaceChildren(...(texts.length ? texts.map(freedom) : [element('li', {}, 'None: the workpiece cannot move here.')]));
    },
    /** @param {string} text where it is */
    tell: (text) => setText(readout, text),
    /** @param {string} text */
    say: (text) => setText(spoken, text),
  };
}

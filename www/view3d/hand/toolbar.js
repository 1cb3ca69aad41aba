/**
 * The bar beside the view that says what is in hand and offers how to move it.
 *
 * @typedef {'move' | 'turn' | 'freedoms'} Mode
 * @typedef {ReturnType<typeof import('../../core/freedom-words.js').freedomInWords>} Freedom
 * @typedef {{mode: Mode, space: 'world' | 'local', snap: boolean}} How
 *
 * @typedef {object} InHand
 * @property {string} name
 * @property {How} how
 * @property {string} steps length of a step, with its unit
 * @property {boolean} pullable whether it has freedoms
 * @property {Freedom[] | null} freedoms null: not known yet
 * @property {string} place where it is, in words
 */
import { element, setText } from '../../ui/dom.js';
import { withKey } from '../../ui/keys.js';
import { html, nothing, render } from '../../ui/render.js';

/** @type {[Mode, string, string][]} */
const MODES = [
  ['move', 'Move', withKey('Move along axes', 'move')],
  ['turn', 'Turn', withKey('Turn about axes', 'turn')],
  ['freedoms', 'Freedoms', withKey('Move along the freedoms that exist here', 'freedoms')],
];

/** Which way along a freedom a key goes. @type {Record<string, 1 | -1>} */
const WAYS = { ArrowRight: 1, ArrowUp: 1, '+': 1, '=': 1, ArrowLeft: -1, ArrowDown: -1, '-': -1 };

/**
 * @param {HTMLElement} place
 * @param {(change: Partial<How>) => void} choose
 * @param {(index: number, sign: number) => void} nudge one step along a freedom
 */
export function createDragBar(place, choose, nudge) {
  const bar = element('section', { class: 'drag-bar', 'aria-label': 'In hand', hidden: true });
  place.append(bar);
  /** Where it is; it changes with every move. */
  const readout = element('p', { class: 'readout', 'aria-hidden': 'true' });
  /** @type {InHand | null} */
  let held = null;
  /** For screen readers, and the place that it was said of: it goes when that is no longer so. */
  let spoken = { text: '', place: '' };
  /** The toolbar's one stop of the Tab key. */
  let stop = 'move';

  /** Arrows go from button to button. @param {KeyboardEvent} event */
  function go(event) {
    const buttons = [...bar.querySelectorAll('.drag-buttons button')];
    const at = buttons.indexOf(/** @type {Element} */ (event.target));
    const to = { ArrowRight: at + 1, ArrowLeft: at - 1, Home: 0, End: buttons.length - 1 }[event.key];
    if (at < 0 || to === undefined) return;
    event.preventDefault();
    /** @type {HTMLElement} */ (buttons[(to + buttons.length) % buttons.length]).focus();
  }

  /** @param {FocusEvent} event */
  function enter({ target }) {
    stop = /** @type {HTMLElement} */ (target).dataset.stop ?? stop;
    show();
  }

  /** @param {KeyboardEvent} event @param {number} index */
  function along(event, index) {
    const sign = WAYS[event.key];
    if (!sign) return;
    event.preventDefault();
    nudge(index, sign);
  }

  /** @param {Freedom} words @param {number} index */
  function freedom({ short, whole }, index) {
    const step = (/** @type {1 | -1} */ sign, /** @type {string} */ way, /** @type {string} */ text) =>
      html`<button aria-label="${way} along freedom ${index + 1}: ${whole}" @click=${() => nudge(index, sign)}>${text}</button>`;
    return html`<li data-freedom=${index} title=${whole} @keydown=${(/** @type {KeyboardEvent} */ event) => along(event, index)}>
      ${step(-1, 'Backwards', '−')}<span>${index + 1} ${short}</span>${step(1, 'Forwards', '+')}
    </li>`;
  }

  /** @param {string} where */
  function tell(where) {
    setText(readout, where);
    readout.title = where;
  }

  function show() {
    bar.hidden = !held;
    if (!held) return render(nothing, bar);
    const { name, how, steps, pullable, freedoms } = held;
    tell(held.place);
    const byFreedoms = how.mode === 'freedoms';
    const modes = MODES.filter(([mode]) => mode !== 'freedoms' || pullable);
    const stops = [...modes.map(([mode]) => mode), ...(byFreedoms ? [] : ['space', 'snap'])];
    const tab = (/** @type {string} */ one) => (one === (stops.includes(stop) ? stop : stops[0]) ? 0 : -1);
    const world = how.space === 'world';
    render(
      html`<div class="drag-buttons" role="toolbar" aria-label="Drag" @keydown=${go} @focusin=${enter}>
          <strong>${name}</strong>
          ${modes.map(
            ([mode, text, title]) =>
              html`<button data-stop=${mode} tabindex=${tab(mode)} title=${title} aria-pressed=${mode === how.mode} @click=${() => choose({ mode })}>${text}</button>`,
          )}
          ${byFreedoms
            ? nothing
            : html`<button data-stop="space" tabindex=${tab('space')} title=${withKey('Axes of the world or its own', 'axes')} @click=${() => choose({ space: world ? 'local' : 'world' })}>${world ? 'World axes' : 'Own axes'}</button>
                <button
                  data-stop="snap" tabindex=${tab('snap')} title="In steps of ${steps} (or hold Shift while dragging)" aria-pressed=${how.snap}
                  @click=${() => choose({ snap: !how.snap })}>Snap ${steps}</button>`}
        </div>
        ${byFreedoms
          ? html`<ul class="freedoms" aria-label="Freedoms here">
              ${freedoms?.length === 0 ? html`<li>None: the workpiece cannot move here.</li>` : (freedoms ?? []).map(freedom)}
            </ul>`
          : readout}
        <p class="sr" role="status">${spoken.text}</p>`,
      bar,
    );
  }

  return {
    /** It is elsewhere, and all else as it was; for while it is moved. */
    tell,
    /** @param {InHand | null} what null: nothing is in hand */
    show(what) {
      held = what;
      if (held?.place !== spoken.place) spoken = { text: '', place: '' };
      show();
    },
    /** Says something of what is in hand as it is shown now. @param {string} text */
    say(text) {
      spoken = { text, place: held?.place ?? '' };
      show();
    },
  };
}

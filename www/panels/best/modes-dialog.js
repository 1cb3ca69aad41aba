/**
 * All ways to assemble the linkage at a key frame: each with its picture, how close it is there, how many starts led to it, and what
 * the motion that is planned from it costs. Each can become the document's start.
 *
 * @typedef {import('../../core/types.js').Mode} Mode
 * @typedef {import('../../core/types.js').Modes} Modes
 */
import { ask } from '../../core/ask.js';
import { textOf } from '../../core/document-text.js';
import { takeStarts } from '../../core/edits.js';
import { plural } from '../../core/format.js';
import { keyFramesOf } from '../../core/key-frames.js';
import { allTimes, keyFrameFrames } from '../../core/playhead.js';
import { sayUndo } from '../../core/undo.js';
import { Search } from '../../planner/search.js';
import dialogLook from '../../style/dialog.css?inline';
import look from '../../style/modes.css?inline';
import { openDialogIn } from '../../ui/dialog.js';
import { element, setText } from '../../ui/dom.js';
import { attach, html, live, nothing, render, renderRows, repeat } from '../../ui/render.js';
import { wear } from '../../ui/style-sheets.js';
import { foundOf } from './at-rest.js';
import { branchesSentence, distance, isNothing, unseenSentence } from './best-words.js';
import { jointLines } from './mode-joints.js';
import { bestMode, ordered } from './mode-order.js';
import { createModePictures, PICTURE } from './mode-pictures.js';

/** How close a mode is at the key frame. @param {Mode} mode */
const closeness = ({ reached, metric }) => (reached ? 'reaches the key frame' : `distance ${distance(metric)} from the key frame`);

/**
 * Chains make their starts by themselves, and one start of a chain is in all ways with its configuration: those of the ways have no sum.
 * @param {Mode} mode @param {number} frames of the motion
 */
const facts = ({ starts, mean, largest = 0, certified }, frames) => [
  `${plural(starts, 'start')} or more of each chain led to it`,
  mean === undefined ? 'its motion is not planned yet' : isNothing(largest) ? 'motion from it: every frame reaches its goal' : `motion from it: mean distance ${distance(mean)}, largest ${distance(largest)}`,
  ...(certified === undefined || certified >= frames ? [] : [`${plural(certified, 'frame')} of ${frames} certified`]),
];

/** @param {import('../../element/workbench.js').App} app @param {number} first key frame, from 0 @param {Parameters<typeof createModePictures>[2]} drawing */
export function openModes({ root, find, store, player, scene, say, signal }, first, drawing) {
  wear(root, dialogLook);
  wear(root, look);
  const { doc } = store;
  const search = new Search();
  const pictures = scene && createModePictures({ store, player }, scene, drawing);
  let life = new AbortController();
  let key = Math.min(first, keyFramesOf(doc).length - 1);
  /** @type {Modes | null} */
  let modes = null;
  let message = '';
  let running = false;
  /** @type {'key' | 'motion'} */
  let order = 'key';

  const head = element('div', { class: 'modes-head' });
  const note = element('p', { class: 'modes-note' });
  const status = element('p', { class: 'sr', role: 'status' });
  const list = element('ul', { class: 'modes-list', 'aria-label': 'Ways to assemble' });
  const dialog = openDialogIn(find('bench'), 'Ways to assemble', head, note, status, list);
  dialog.classList.add('ways');
  dialog.addEventListener('close', leave);
  // A document that comes from elsewhere has other ways.
  const unsubscribe = store.subscribe('document', () => dialog.close());
  signal.addEventListener('abort', leave);

  function leave() {
    unsubscribe();
    life.abort();
    search.leave();
  }

  async function begin() {
    life.abort();
    life = new AbortController();
    const { signal: ended } = life;
    if (modes?.key !== key) modes = null;
    running = true;
    message = '';
    draw();
    const onProgress = (/** @type {Modes} */ soFar) => {
      if (ended.aborted) return;
      modes = soFar;
      draw();
    };
    const found = await ask(() => search.modes(textOf(doc), key, { signal: ended, onProgress }), 'look for ways to assemble');
    if (ended.aborted) return;
    running = false;
    if (found.is === 'answer') modes = found.value;
    else message = found.message;
    draw();
    setText(status, message || `${plural(modes?.found.length ?? 0, 'way')} to assemble found.`);
  }

  /** Stop takes the button's place, and the focus with it. */
  function goOn() {
    begin();
    head.querySelector('button')?.focus();
  }

  function stop() {
    life.abort();
    running = false;
    draw();
    head.querySelector('button')?.focus();
  }

  /** The document starts with this mode from now on: an edit that undo takes back. @param {Mode} mode @param {number} number */
  async function startFrom(mode, number) {
    const text = await ask(() => search.textWithMode(textOf(doc), mode.index), 'take over the start');
    if (text.is === 'late' || store.doc !== doc) return;
    if (text.is !== 'answer') {
      message = text.message;
      return draw();
    }
    dialog.close();
    store.edit((present) => takeStarts(present, JSON.parse(text.value).chains));
    sayUndo({ store, say }, doc, `Way ${number} was made the start.`);
  }

  const keyName = (/** @type {number} */ index) => keyFramesOf(doc)[index].name || `key frame ${index + 1}`;

  /** @param {Event} event */
  function chooseKey({ target }) {
    key = Number(/** @type {HTMLSelectElement} */ (target).value);
    begin();
  }

  /** @param {Event} event */
  function chooseOrder({ target }) {
    order = /** @type {HTMLSelectElement} */ (target).value === 'motion' ? 'motion' : 'key';
    draw();
  }

  function drawHead() {
    const progress = modes?.progress ?? 0;
    const best = bestMode(modes);
    const doing = progress < 0.5 ? 'looking for ways' : 'planning from each';
    render(
      html`<label>at <select aria-label="Key frame" .value=${live(String(key))} @change=${chooseKey}>${keyFramesOf(doc).map((_, index) => html`<option value=${index} ?selected=${index === key}>${keyName(index)}</option>`)}</select></label>
        <label>order <select aria-label="Order" .value=${live(order)} @change=${chooseOrder}><option value="key">nearest at the key frame</option><option value="motion">closest motion</option></select></label>
        ${running
          ? html`<progress max="100" value=${Math.floor(100 * progress)} aria-label="Search for ways to assemble"></progress><button @click=${stop}>Stop</button><span class="muted">${doing}, ${Math.floor(100 * progress)} %</span>`
          : progress < 1 ? html`<button @click=${goOn}>Go on searching</button>` : nothing}
        ${best && !store.readonly ? html`<button class="best-mode" ?disabled=${best.is_start} title="Start from the way whose motion is closest on average" @click=${() => startFrom(best, numberOf(best))}>${best.is_start ? 'Its start is the best mode' : 'Start from the best mode'}</button>` : nothing}`,
      head,
    );
  }

  /** Its place by nearness, which it is called by. @param {Mode} mode */
  const numberOf = (mode) => ordered(modes?.found ?? [], 'key').findIndex(({ index }) => index === mode.index) + 1;

  /** @param {Mode} mode */
  function card(mode) {
    const { motion, plain } = store.result;
    const number = numberOf(mode);
    const best = bestMode(modes)?.index === mode.index;
    const frame = motion && plain ? keyFrameFrames(plain, allTimes(motion))[key] ?? 0 : 0;
    const picture = (/** @type {HTMLCanvasElement} */ canvas) => {
      let drawn = '';
      return (/** @type {Mode} */ of) => {
        const now = `${key} ${of.metric} ${of.joints.join()}`;
        if (now !== drawn) pictures?.show(canvas, of, frame);
        drawn = now;
      };
    };
    return html`<li class=${best ? 'best' : ''}>
      ${pictures ? html`<canvas role="img" aria-label=${`Way ${number}, seen from the same side as the others`} width=${PICTURE.width} height=${PICTURE.height} ${attach(picture, mode)}></canvas>` : nothing}
      <h3>Way ${number} ${mode.is_start ? html`<small>the document’s start</small>` : nothing}${best ? html`<small class="mark">best mode</small>` : nothing}</h3>
      <p>${closeness(mode)}</p>
      ${[...facts(mode, motion?.goal_frames ?? 0), ...jointLines(mode, modes?.found ?? [], motion?.report.chains ?? [])].map((text) => html`<p class="muted">${text}</p>`)}
      ${store.readonly ? nothing : html`<button ?disabled=${mode.is_start} aria-label=${`Start from this: way ${number}`} @click=${() => startFrom(mode, number)}>Start from this</button>`}
    </li>`;
  }

  function draw() {
    drawHead();
    const found = modes?.found ?? [];
    const { best, doc: searched } = foundOf({ signal }) ?? {};
    const branches = modes && best && searched === doc && !running ? branchesSentence(best, modes.frame, found.length) : '';
    const text = message || (modes ? `${plural(found.length, 'way')} found by ${plural(modes.starts, 'start')}. ${unseenSentence(modes, 'way')} ${branches}` : 'Looking for ways to put the chains together …');
    setText(note, text.trim());
    renderRows(repeat(ordered(found, order), ({ index }) => index, card), list);
  }

  begin();
}

/**
 * The panel of the best motion: the search with its progress, branches as lanes, what is known and what may be missing in words,
 * and how much calmer it may be. Loaded when it is first seen.
 */
import { nameOf } from '../../core/best-motions.js';
import { drivesJoints } from '../../core/driven.js';
import { plural } from '../../core/format.js';
import { keyFrameFrames, allTimes } from '../../core/playhead.js';
import { element, setText } from '../../ui/dom.js';
import { html, ifDefined, live, nothing, render } from '../../ui/render.js';
import { recall, remember } from '../../ui/kept-layout.js';
import { wear } from '../../ui/style-sheets.js';
import look from '../../style/best.css?inline';
import { isApplet } from './at-rest.js';
import { boundSentence, branchName, distance, jointMotion, jointStep, jointUnit, searchWords, unseenSentence } from './best-words.js';
import { calmSlider, pointsOf } from './calm.js';
import { createLanesPicture } from './lanes-picture.js';

/** What can be shown in the view. @type {(name: 'best' | 'calmer') => [import('./search-state.js').Which, string, string][]} */
const shownBy = (name) => [
  ['followed', 'followed', 'The motion that the planner follows from frame to frame'],
  ['both', 'both', `The followed motion, and the ${name} one as a ghost`],
  ['best', name, `The ${name} motion alone; its numbers stand in the panels`],
];

/** What joint motions are measured in, where the numbers do not have it. @param {import('../../core/types.js').Motion | null} motion */
const unit = (motion) => (jointUnit(motion) ? html` <small>${jointUnit(motion)}</small>` : nothing);

/**
 * @param {Pick<import('../../element/workbench.js').App, 'root' | 'find' | 'store' | 'player' | 'signal' | 'keys' | 'interaction'>} app @param {HTMLElement} panel
 * @param {import('./search-state.js').SearchState} search
 * @param {(key: number) => void} openModes
 */
export function createBestPanel({ root, find, store, player, signal, keys, interaction }, panel, search, openModes) {
  wear(root, look);
  const goTo = (/** @type {number} */ frame) => {
    player.pause();
    player.frame = frame;
  };
  const lanes = createLanesPicture({ find, signal, goTo });
  const head = element('div', { class: 'best-head' });
  const words = element('p', { class: 'best-verdict' });
  const status = element('p', { class: 'sr', role: 'status' });
  const body = element('div', { class: 'best-body' });

  /** The key frame at the playhead or before it. */
  function keyHere() {
    const { motion, plain } = store.result;
    if (!motion || !plain) return 0;
    const frames = keyFrameFrames(plain, allTimes(motion));
    return Math.max(0, frames.filter((frame) => frame <= store.view.frame).length - 1);
  }

  // On another page it is only looked for when it is asked for.
  const byItself = isApplet({ interaction, keys, root });
  const box = element('input', { type: 'checkbox', checked: recall().search !== false, change: () => remember({ search: box.checked }) });
  const foot = element('label', { class: 'by-itself', title: 'When all rests after a plan that does not reach its goals' }, box, 'Look for a better motion after each plan');
  foot.hidden = !byItself;
  panel.replaceChildren(head, words, status, lanes.root, body, foot);

  // In a row of its own, where no other button is before or after: a double click meets its place twice.
  function stop() {
    search.stop();
    head.querySelector('button')?.focus();
  }

  function drawHead() {
    const { running, best, motion, which } = search.now;
    const obstacle = search.obstacle();
    const percent = Math.floor(100 * (best?.progress ?? 0));
    const isOver = best?.progress === 1;
    // While an edit is planned the button stays, and with it the focus that comes back from the dialog.
    const isDriven = drivesJoints(store.result.motion);
    const choices = html`<fieldset class="which" ?disabled=${!motion}><legend>Shown</legend>${shownBy(nameOf(motion)).map(
      ([which_, label, title]) => html`<label title=${title}><input type="radio" name="best-shown" .checked=${live(which === which_)} @change=${() => search.show(which_)} />${label}</label>`,
    )}</fieldset>`;
    render(
      html`<button ?disabled=${obstacle !== '' || isOver} aria-disabled=${ifDefined(running ? 'true' : undefined)} @click=${search.begin}>${best && !isOver && !running ? 'Go on searching' : 'Look for a better motion'}</button>
        ${isDriven ? nothing : html`<button aria-disabled=${ifDefined(obstacle ? 'true' : undefined)} @click=${() => search.obstacle() || openModes(keyHere())} title="All ways to assemble the linkage at a key frame">Ways to assemble…</button>${choices}`}
        ${running
          ? html`<div class="doing"><button @click=${stop}>Stop the search</button><progress max="100" value=${percent} aria-label="Search for a better motion"></progress>
              <span class="muted">${percent} %, ${plural(best?.starts ?? 0, 'start')}</span></div>`
          : nothing}`,
      head,
    );
  }

  function drawBody() {
    const { best, motion, message, running } = search.now;
    const text = search.obstacle() || message || searchWords(search.now, store.result.motion);
    setText(words, text);
    // Said once it is over; while it goes on the numbers change too often.
    if (!running) setText(status, best ? text : '');
    lanes.update(best, store.result.motion, nameOf(motion) === 'calmer');
    if (!best) return render(nothing, body);
    const now = motion ?? store.result.motion;
    /** @type {[string, (cost: import('../../core/types.js').MotionCost) => string][]} */
    const rows = [
      ['mean distance', ({ mean }) => distance(mean)],
      ['largest distance', ({ largest }) => distance(largest)],
      ['largest joint step', ({ largest_step }) => jointStep(largest_step, now)],
    ];
    const { choice } = search.now;
    const calm = choice > 0 ? best.curve[choice - 1] : null;
    render(
      html`<section aria-label="Followed and best motion in numbers">
          <table class="plain best-numbers">
            <caption>Distances from the goal, ½‖q − g‖², over all frames</caption>
            <thead><tr><td></td><th scope="col">followed</th><th scope="col">best</th>${calm ? html`<th scope="col">calmer</th>` : nothing}</tr></thead>
            <tbody>${rows.map(([name, write]) => html`<tr><th scope="row">${name}${name === 'largest joint step' ? unit(now) : nothing}</th><td>${write(best.followed)}</td><td>${write(best.best)}</td>${calm ? html`<td>${write(calm)}</td>` : nothing}</tr>`)}</tbody>
          </table>
          <p>${boundSentence(best)}</p>
          <p>${plural(best.starts, 'start')} made, ${plural(best.branches.length, 'branch', 'branches')} found. ${unseenSentence(best, 'branch')}</p>
        </section>
        ${calmSlider(search.now, search.choose)}
        <details class="data"><summary>Table<span class="sr"> of branches, switches and calmer motions</span></summary>${tables(best, now)}</details>`,
      body,
    );
  }

  /** All that is drawn, in numbers. @param {import('../../core/types.js').Best} best @param {import('../../core/types.js').Motion | null} motion */
  function tables(best, motion) {
    const used = new Set(best.lane);
    const jump = (/** @type {number} */ frame) => html`<button class="link" aria-label=${`To frame ${frame + 1}`} @click=${() => goTo(frame)}>${frame + 1}</button>`;
    const mean = (/** @type {Float64Array} */ metric) => distance(metric.reduce((sum, value) => sum + value, 0) / metric.length);
    return html`<div class="best-tables" role="region" aria-label="Branches, switches and calmer motions">
      <table class="plain"><caption>Branches</caption>
        <thead><tr><th scope="col">branch</th><th scope="col">from frame</th><th scope="col">to</th><th scope="col">mean distance</th><th scope="col">in the best motion</th></tr></thead>
        <tbody>${best.branches.map(({ first, metric }, branch) => html`<tr><th scope="row">${branchName(branch)}</th><td>${jump(first)}</td><td>${first + metric.length}</td><td>${mean(metric)}</td><td>${used.has(branch) ? 'yes' : 'no'}</td></tr>`)}</tbody>
      </table>
      ${best.switches.length ? html`<table class="plain"><caption>Switches of the best motion</caption>
        <thead><tr><th scope="col">before frame</th><th scope="col">from</th><th scope="col">to</th><th scope="col">joint motion${unit(motion)}</th><th scope="col">largest distance on the way</th></tr></thead>
        <tbody>${best.switches.map(({ frame, from, to, length, largest }) => html`<tr><th scope="row">${jump(frame)}</th><td>${branchName(from)}</td><td>${branchName(to)}</td><td>${jointMotion(length, motion)}</td><td>${distance(largest)}</td></tr>`)}</tbody>
      </table>` : nothing}
      ${best.curve.length ? html`<table class="plain"><caption>From closer to calmer</caption>
        <thead><tr><th scope="col">position</th><th scope="col">mean distance</th><th scope="col">largest distance</th><th scope="col">largest joint step${unit(motion)}</th></tr></thead>
        <tbody>${pointsOf(best, motion).map(({ point }, index) => html`<tr><th scope="row">${index + 1}</th><td>${distance(point.mean)}</td><td>${distance(point.largest)}</td><td>${jointStep(point.largest_step, motion)}</td></tr>`)}</tbody>
      </table>` : nothing}
    </div>`;
  }

  function draw() {
    drawHead();
    drawBody();
    lanes.showAt(store.view.frame);
  }
  search.subscribe(draw);
  store.subscribe('result', draw);
  store.select(({ view }) => view.frame, (frame) => lanes.showAt(frame));
  draw();
}

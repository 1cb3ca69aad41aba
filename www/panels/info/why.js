/**
 * "Why not closer" in the info panel: the certificate, the chains that hold the workpiece back, what is left of the
 * gap, and the freedoms at what is shown.
 *
 * @typedef {import('../../core/types.js').Why} Why
 */
import { html, nothing, render, repeat } from '../../ui/render.js';
import { capital, chainName } from '../../core/chain-name.js';
import { freedomInWords } from '../../core/freedom-words.js';
import { drivesJoints, told } from '../../core/driven.js';
import { sentence } from '../../core/format.js';
import { percentages } from '../../core/percentages.js';
import { groupAt, hasNoGoal, shown, shownEnd } from '../../core/shown.js';
import { atLimits, certificate, mostHolding, twistInWords, wrenchInWords } from './why-words.js';

/** @param {Pick<import('../../element/workbench.js').App, 'find' | 'store' | 'explain'>} app */
export function createWhy({ find, store, explain }) {
  const root = find('why');
  /** Kept while a frame between has no gap. */
  let gapOpen = false;

  /** @param {string} hovered */
  const point = (hovered) => () => store.setView({ hovered });

  /** A chain's share, and what it withstands. @param {number} chain @param {string} name @param {number} percent @param {string} holds */
  function bar(chain, name, percent, holds) {
    const place = `chains[${chain}]`;
    const { hovered, selected } = store.view;
    const choose = () => store.setView({ selected: selected === place ? '' : place });
    return html`<li data-place=${place} class=${hovered === place || hovered.startsWith(`${place}.`) ? 'pointed' : ''}>
      <button aria-pressed=${String(selected === place)} @click=${choose} @pointerenter=${point(place)} @pointerleave=${point('')} @focus=${point(place)} @blur=${point('')}>
        <span>${name}</span>
        <span class="share-track" aria-hidden="true"><i class=${`chain-${chain % 5}`} .style=${`width: ${percent}%`}></i></span>
        <strong>${percent} %</strong>
      </button>
      ${percent > 0 ? html`<small>${holds}</small>` : nothing}
    </li>`;
  }

  /** What holds the workpiece back from its goal. @param {Why} why */
  function holding(why) {
    const { motion } = store.result;
    const end = shownEnd(store);
    if (!motion || !end) return nothing;
    const { doc, joints, index } = why.of;
    const { metric, bounds } = motion.report;
    const shares = percentages(why.chains.map(({ share }) => share));
    const frames = store.view.posture ? 1 : motion.frames;
    const limits = atLimits(why.held, doc, motion.report, groupAt(joints, { index, frames }));
    return html`<p class="why-sentence">${mostHolding(why, doc, metric.length) || 'No chain holds it back here: the linkage could still come nearer.'}</p>
      <ul class="why-limits">${limits.map((text) => html`<li>${text}</li>`)}</ul>
      <ul class="shares" aria-label="Share of each chain in holding the workpiece back">
        ${repeat(why.chains, (_, i) => i, ({ wrench }, i) => bar(i, chainName(doc.chains[i], i), shares[i], `withstands ${wrenchInWords(wrench, metric.length)}`))}
      </ul>
      <p class="why-proof">${certificate(why, end.status, end, bounds)}</p>
      <details ?open=${gapOpen} @toggle=${(/** @type {Event} */ { target }) => (gapOpen = /** @type {HTMLDetailsElement} */ (target).open)}>
        <summary>What is left of the gap</summary>
        <dl class="why-gap">
          <dt>The gap</dt><dd>${twistInWords(why.gap, doc.length_unit)}</dd>
          <dt>in free directions</dt><dd>${twistInWords(why.free_part, doc.length_unit)}</dd>
          <dt>in blocked directions</dt><dd>${twistInWords(why.blocked_part, doc.length_unit)}</dd>
        </dl>
      </details>`;
  }

  /** @param {Why} why */
  function freedoms({ freedoms: screws, of: { doc } }) {
    const texts = screws.map((screw) => capital(freedomInWords(screw, doc.length_unit).whole));
    return html`<details>
      <summary>Freedoms here: ${screws.length}</summary>
      <ul class="why-freedoms">${(texts.length ? texts : ['None: the workpiece is held.']).map((text) => html`<li>${text}</li>`)}</ul>
    </details>`;
  }

  /** Why the driven joints of the motion do not have their values at this frame. */
  function ofDrivers() {
    const { result: { motion }, view: { frame, posture } } = store;
    if (posture || !motion || !drivesJoints(motion)) return nothing;
    return told.words.driveReasons(motion, frame).map((text) => html`<p class="why-sentence">${sentence(text)}</p>`);
  }

  /** What is said of the goal. @param {string} kind @param {Why | null} why */
  function ofGoal(kind, why) {
    if (kind === 'closure_lost') return html`<p class="why-sentence">The loops are open here, so nothing can be said of what holds the workpiece.</p>`;
    if (kind === 'reached') return html`<p class="why-sentence">The goal is met; nothing holds it back.</p>`;
    return kind === 'held' && why ? holding(why) : nothing;
  }

  let isAsked = false;
  /** What can be said of a posture only when the planner has been asked, which a person may wish. @param {string} kind */
  function wish(kind) {
    if (isAsked) return html`<p class="muted">The planner is being asked …</p>`;
    const ask = () => {
      isAsked = true;
      explain();
      show();
      // The button is gone.
      root.focus();
    };
    return html`<button class="link" @click=${ask}>${kind === 'held' ? 'Show what holds it back' : 'Show the freedoms here'}</button>`;
  }

  /** Which kind of words stand there now; '' before the planner has said any. */
  let said = '';
  /** What is said belongs to what is shown; while that moves the words of a moment ago stay, unless they would contradict it. */
  function show() {
    const what = shown(store);
    const end = shownEnd(store);
    const { why } = store;
    if (!what || !end) {
      root.hidden = true;
      return;
    }
    const driven = hasNoGoal(store);
    const byMotion = driven && !store.view.posture;
    // What is only passed on the way to somewhere is not held back.
    const kind = byMotion ? `by drivers ${end.status}` : driven ? 'driven' : ['reached', 'closure_lost', 'passing'].includes(end.status) ? end.status : 'held';
    const { of } = why ?? {};
    const fits = of !== undefined && of.joints === what.joints && of.goal === what.goal && of.index === what.index;
    const stale = !fits && end.status !== 'closure_lost';
    const contradicts = said !== kind || of?.doc !== what.doc;
    root.classList.toggle('waiting', stale && !contradicts);
    root.classList.toggle('unsaid', stale && contradicts);
    const unasked = stale && !why && said === '';
    root.hidden = stale && !unasked && (!why || said === '');
    if (stale && !unasked) return;
    if (unasked) root.classList.remove('waiting', 'unsaid');
    else said = kind;
    render(
      html`<h2 id="why-title">${byMotion && ['at_limit', 'stalled'].includes(end.status) ? 'What stops the drivers' : driven || kind === 'passing' ? 'What is free here' : 'Why not closer'}</h2>
        ${ofDrivers()}${ofGoal(kind, why)}${unasked ? wish(kind) : why && end.status !== 'closure_lost' ? freedoms(why) : nothing}`,
      root,
    );
  }

  store.subscribe('why', show);
  store.subscribe('result', show);
  store.subscribe('view', show);
  show();
}

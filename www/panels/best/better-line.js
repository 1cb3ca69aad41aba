/**
 * In the info panel: that a better pose exists in the shown frame, or a finite one where the planner lost its way, with a button
 * that shows it. Over the view: that the best motion is shown in place of the followed one.
 */
import { bestMotions } from '../../core/best-motions.js';
import { statusName } from '../../core/status-words.js';
import { element } from '../../ui/dom.js';
import { html, nothing, render } from '../../ui/render.js';
import { distance } from './best-words.js';

/** @param {Pick<import('../../element/workbench.js').App, 'find' | 'store'>} app @param {import('./search-state.js').SearchState} search */
export function createBetterLine({ find, store }, search) {
  const root = find('better');
  const note = element('p', { class: 'by-hand', id: 'best-shown', hidden: true });
  find('by-hand').before(note);

  /** @param {import('./search-state.js').Which} which */
  const show = (which) => () => {
    search.show(which);
    // The button may be gone.
    root.focus();
  };

  /** From a calmer motion to the best one itself. */
  function showBest() {
    search.choose(0);
    root.focus();
  }

  /** What is known of the motion that takes the followed one's place: the best one, or a calmer one. */
  const other = () => search.now.motion && bestMotions.get(search.now.motion);
  /** A way back from a calmer motion. */
  const toBest = () => (other()?.name === 'calmer' ? html`<button class="link" @click=${showBest}>Show the best one</button> ` : nothing);

  /** What is said of the shown frame. */
  function line() {
    const { frame, posture } = store.view;
    const { which } = search.now;
    if (posture || store.result.doc !== search.now.doc) return nothing;
    const better = search.betterAt(frame);
    if (which === 'best') return html`${other()?.name === 'calmer' ? other()?.words : 'This is the best motion'}${better ? `: ${distance(better.best)} here instead of ${distance(better.now)}` : ''}. ${toBest()}<button class="link" @click=${show('followed')}>Show the followed one</button>`;
    const more = which === 'both' ? html`<button class="link" @click=${show('followed')}>Hide it</button>` : html`<button class="link" @click=${show('both')}>Show it</button>`;
    if (search.isFoundWhereLost(frame)) return html`${lost(frame)} here; a finite closest pose was found. ${more}`;
    return better ? html`A better pose exists: ${distance(better.best)} instead of ${distance(better.now)}. ${more}` : nothing;
  }

  /** How the followed motion failed in a frame. @param {number} frame */
  function lost(frame) {
    const { followed } = search.now;
    return followed && statusName(followed, frame) === 'closure_lost' ? 'The planner lost the loops' : 'The planner ran away or stalled';
  }

  function draw() {
    const { which } = search.now;
    note.hidden = which !== 'best' || store.view.posture !== null;
    if (!note.hidden) render(html`${other()?.words}. ${toBest()}<button class="link" @click=${show('followed')}>Back to the followed one</button>`, note);
    // While the motion plays, a line that comes and goes would move all that is below.
    if (store.view.playing) return;
    const said = line();
    root.hidden = said === nothing;
    render(said === nothing ? nothing : html`<p>${said}</p>`, root);
  }
  search.subscribe(draw);
  store.subscribe('view', draw);
  store.subscribe('result', draw);
  draw();
}

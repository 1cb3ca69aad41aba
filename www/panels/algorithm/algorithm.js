/**
 * The planner's own iterations at the shown frame, step by step: the paper's gradient (Fig. 3) and Newton's method.
 * The linkage in the view steps along. Loaded when the panel is first seen.
 *
 * @typedef {import('../../core/types.js').Trace} Trace
 * @typedef {import('../../core/types.js').Posture} Posture
 * @typedef {import('./algorithm-words.js').Method} Method
 */
import { ask } from '../../core/ask.js';
import { textOf } from '../../core/document-text.js';
import { chainName } from '../../core/chain-name.js';
import { drivesJoints } from '../../core/driven.js';
import { element } from '../../ui/dom.js';
import { html, render } from '../../ui/render.js';
import { scientific } from '../../core/format.js';
import { wear } from '../../ui/style-sheets.js';
import { SLOPES, iterateInWords, kept, leastMetric } from './algorithm-words.js';
import { createConvergence } from './convergence.js';
import { createMatrixPicture } from './matrix-picture.js';
import { plotLook } from '../charts/plot.js';
import { postureOf } from './posture-of.js';
import { createSteps } from './steps.js';
import look from '../../style/algorithm.css?inline';

/** @param {Pick<import('../../element/workbench.js').App, 'root' | 'store' | 'planner' | 'player' | 'signal'>} app @param {HTMLElement} panel */
export function createAlgorithm({ root, store, planner, player, signal }, panel) {
  wear(root, plotLook);
  wear(root, look);
  /** @type {Trace | null} */
  let trace = null;
  /** What the trace was made for. @type {{doc: unknown, frame: number}} */
  let made = { doc: null, frame: -1 };
  /** @type {Method} */
  let method = 'gradient';
  let at = 0;
  /** The posture that stands in the view for an iterate. @type {Posture | null} */
  let mine = null;
  let seen = false;

  const note = element('p', { class: 'muted' });
  const iterate = element('div');
  const steps = createSteps({
    choose: (index) => show(index, true),
    chooseMethod(chosen) {
      method = chosen;
      show(0, mine !== null);
    },
  });
  const matrix = createMatrixPicture((hovered) => store.setView({ hovered }));
  const convergence = createConvergence((chosen, index) => {
    method = chosen;
    show(index, true);
  }, signal);
  const body = element(
    'div',
    { class: 'algorithm', hidden: true },
    element('section', { class: 'block', 'aria-label': 'Iteration' }, steps.root, iterate),
    matrix.root,
    convergence.root,
  );
  panel.replaceChildren(note, body);

  /** @param {unknown} text or a template with a button in it; '' for nothing */
  function say(text) {
    note.hidden = text === '';
    render(html`${text}`, note);
  }

  /** The button in the note had the focus: it goes on among the iterates, once they are there. */
  let goOn = false;
  /** Does what must be done before there are iterations to look into. @param {() => void} act */
  const first = (act) => () => {
    goOn = true;
    act();
  };

  /** Gives the view its frame back. */
  function release() {
    steps.stop();
    if (mine && store.view.posture === mine) store.setView({ posture: null });
    mine = null;
  }

  /** Traces the shown frame, if that is not what is there. */
  async function refresh() {
    const { motion, doc } = store.result;
    if (!seen || !motion || !doc) return;
    if (drivesJoints(motion)) {
      release();
      trace = null;
      body.hidden = true;
      made = { doc: null, frame: -1 };
      return say('Joints are driven in this motion: there is no goal, and so no iterations towards the pose that is closest to it. A motion with key frames has them.');
    }
    const { playing, posture } = store.view;
    const away = posture !== null && posture !== mine;
    if (playing || away) {
      steps.stop();
      mine = null;
      body.hidden = true;
      made = { doc: null, frame: -1 };
      return say(
        playing
          ? html`The motion plays. <button @click=${first(() => player.pause())}>Pause</button> to look into the iterations of one frame.`
          : html`The linkage is moved by hand. <button @click=${first(() => store.setView({ posture: null }))}>Go back to the motion</button> to look
              into the iterations of one frame.`,
      );
    }
    const frame = Math.min(store.view.frame, motion.frames - 1);
    if (made.doc === doc && made.frame === frame) return;
    steps.stop();
    made = { doc, frame };
    const width = motion.joints.length / motion.frames;
    const before = frame > 0 ? motion.joints.slice((frame - 1) * width, frame * width) : new Float64Array();
    const answer = await ask(() => planner.trace(textOf(doc), frame, before), 'find the iterations');
    if (made.doc !== doc || made.frame !== frame || answer.is === 'late') return;
    if (answer.is !== 'answer') {
      trace = null;
      body.hidden = true;
      const again = first(() => {
        made = { doc: null, frame: -1 };
        refresh();
      });
      return say(html`The iterations could not be found. ${answer.message} <button @click=${again}>Try again</button>`);
    }
    trace = answer.value;
    const open = kept(trace.gradient) === 0;
    body.hidden = open;
    if (open) return say('The loops cannot be closed from this start: there is nothing to iterate.');
    say(
      `Frame ${frame + 1} of ${motion.goal_frames}: both methods start from ${frame > 0 ? `the answer of frame ${frame}` : 'the start of the motion'}. ` +
        'The view shows the frame until an iterate is chosen here. Scrub to another frame to look into that one.',
    );
    convergence.show(trace);
    show(0, false);
    if (goOn) steps.focus();
    goOn = false;
  }

  /** @param {number} index of an iterate that is kept @param {boolean} inView whether the view shows it in place of the frame */
  function show(index, inView) {
    const { motion, doc } = store.result;
    if (!trace || !motion || !doc || !seen) return;
    const history = trace[method];
    const last = kept(history) - 1;
    at = Math.min(last, Math.max(0, index));
    steps.show(method, at, history);
    convergence.point(method, history.iteration[at]);
    const posture = postureOf(trace, method, at, motion.report.bounds);
    draw();
    if (inView) {
      mine = posture;
      store.setView({ posture });
      player.invalidate();
    }
    showMatrix(doc, posture.joints);
  }

  /** The joint values whose matrix was asked for last. @type {unknown} */
  let asked = null;
  /** @param {import('../../core/types.js').MechanismDocument} doc @param {Float64Array} joints */
  async function showMatrix(doc, joints) {
    asked = joints;
    const found = await ask(() => planner.matrix(textOf(doc), joints.slice()), 'find the matrix');
    if (asked !== joints || found.is === 'late') return;
    if (found.is !== 'answer') return matrix.fail(`[A] could not be found. ${found.message}`);
    matrix.show(found.value, doc.chains.map(chainName));
    draw(found.value.columns - found.value.rank);
  }

  /** The iterate in words and numbers. @param {number} [freedoms] directions of the null space, once they are known */
  function draw(freedoms) {
    if (!trace) return;
    const history = trace[method];
    const { heading, steps: lines } = iterateInWords(method, history, at, { frame: made.frame, freedoms });
    const slope = SLOPES[method];
    const row = (/** @type {string} */ name, /** @type {string} */ title, /** @type {number} */ value) =>
      html`<div><dt title=${title}>${name}</dt><dd><output>${scientific(value)}</output></dd></div>`;
    render(
      html`<h2>${heading}</h2>
        <ol class="flow">${lines.map(([text, equation]) => html`<li>${text} <span class="equation">${equation}</span></li>`)}</ol>
        <dl class="numbers">
          ${row('f = ½‖q − g‖²', 'Eq. 29', history.metric[at])}
          ${row('f − f*', 'above the minimum', Math.abs(history.metric[at] - leastMetric(trace)))}
          ${row(slope.name, slope.meaning, history.projected_gradient[at])}
          ${row('Closure', 'how far the loops are open: lengths as shares of the mechanism’s size, or rad', history.closure[at])}
          ${row('σ min of [A]', 'the smallest singular value that is not 0 because of surplus constraints: lengths as shares of the mechanism’s size, about the workpiece’s origin', history.sigma_min[at])}
        </dl>`,
      iterate,
    );
  }

  new IntersectionObserver((entries) => {
    seen = entries[entries.length - 1].isIntersecting;
    if (seen) refresh();
    else release();
  }).observe(panel);
  store.subscribe('result', refresh);
  store.subscribe('view', () => {
    // Scrubbing, playing, an edit or a hand took the linkage.
    if (mine && store.view.posture !== mine) {
      mine = null;
      steps.stop();
    }
    refresh();
  });
}

/**
 * The planner's own iterations at the shown frame, step by step: the paper's gradient (Fig. 3) and Newton's method.
 * The linkage in the view steps along. Loaded when the panel is first seen.
 *
 * @typedef {import('../../core/types.js').Trace} Trace
 * @typedef {import('../../core/types.js').Posture} Posture
 * @typedef {import('./algorithm-words.js').Method} Method
 */
import { textOf } from '../../core/document-text.js';
import { element, setText } from '../../ui/dom.js';
import { scientific } from '../../core/format.js';
import { wear } from '../../ui/style-sheets.js';
import { Superseded } from '../../planner/planner.js';
import { iterateInWords, kept, leastMetric } from './algorithm-words.js';
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
  const heading = element('h2');
  const list = element('ol', { class: 'flow' });
  /** @type {Record<string, HTMLElement>} */
  const numbers = {};
  const row = (/** @type {string} */ key, /** @type {string} */ name, /** @type {string} */ title) => {
    numbers[key] = element('output', {}, '–');
    return element('div', {}, element('dt', { title }, name), element('dd', {}, numbers[key]));
  };
  const table = element(
    'dl',
    { class: 'numbers' },
    row('metric', 'f = ½‖q − g‖²', 'Eq. 29'),
    row('above', 'f − f*', 'above the minimum'),
    row('slope', '‖a‖, projected gradient', 'Eq. 31'),
    row('closure', 'Closure', 'how far the loops are open: lengths as shares of the mechanism’s size, or rad'),
    row('sigma', 'σ min of [A]', 'the smallest singular value that is not 0 because of surplus constraints: lengths as shares of the mechanism’s size, about the workpiece’s origin'),
  );
  const steps = createSteps({
    choose: (index) => show(index),
    chooseMethod(chosen) {
      method = chosen;
      show(0);
    },
  });
  const matrix = createMatrixPicture((hovered) => store.setView({ hovered }));
  const convergence = createConvergence((chosen, index) => {
    method = chosen;
    show(index);
  }, signal);
  const body = element(
    'div',
    { class: 'algorithm', hidden: true },
    element('section', { class: 'block', 'aria-label': 'Iteration' }, steps.root, heading, list, table),
    matrix.root,
    convergence.root,
  );
  panel.replaceChildren(note, body);

  /** @param {string} text */
  function say(text) {
    note.hidden = text === '';
    setText(note, text);
  }

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
    if (store.view.playing) {
      steps.stop();
      mine = null;
      body.hidden = true;
      made = { doc: null, frame: -1 };
      return say('The motion plays. Pause it to look into the iterations of one frame.');
    }
    const frame = Math.min(store.view.frame, motion.frames - 1);
    if (made.doc === doc && made.frame === frame) return;
    steps.stop();
    made = { doc, frame };
    const width = motion.joints.length / motion.frames;
    const before = frame > 0 ? motion.joints.slice((frame - 1) * width, frame * width) : new Float64Array();
    try {
      const answer = await planner.trace(textOf(doc), frame, before);
      if (made.doc !== doc || made.frame !== frame) return;
      trace = answer;
    } catch (error) {
      if (error instanceof Superseded) return;
      trace = null;
      say(`The iterations could not be found (${error instanceof Error ? error.message : error}).`);
    }
    const open = trace !== null && kept(trace.gradient) === 0;
    body.hidden = !trace || open;
    if (!trace) return;
    if (open) return say('The loops cannot be closed from this start: there is nothing to iterate.');
    say(
      `Frame ${frame + 1} of ${motion.frames}: both methods start from ${frame > 0 ? `the answer of frame ${frame}` : 'the start of the motion'}. ` +
        'Scrub to another frame to look into that one.',
    );
    convergence.show(trace);
    show(0);
  }

  /** @param {number} index of an iterate that is kept */
  function show(index) {
    const { motion, doc } = store.result;
    if (!trace || !motion || !doc || !seen) return;
    const history = trace[method];
    const last = kept(history) - 1;
    at = Math.min(last, Math.max(0, index));
    steps.show(method, at, history);
    numbers.metric.textContent = scientific(history.metric[at]);
    numbers.above.textContent = scientific(Math.abs(history.metric[at] - leastMetric(trace)));
    numbers.slope.textContent = scientific(history.projected_gradient[at]);
    numbers.closure.textContent = scientific(history.closure[at]);
    numbers.sigma.textContent = scientific(history.sigma_min[at]);
    sayStep();
    convergence.point(method, history.iteration[at]);
    mine = postureOf(trace, method, at, motion.report.bounds);
    store.setView({ posture: mine });
    player.invalidate();
    planner.matrix(textOf(doc), mine.joints.slice()).then(
      (answer) => {
        matrix.show(answer);
        sayStep(answer.columns - answer.rank);
      },
      (error) => {
        if (!(error instanceof Superseded)) throw error;
      },
    );
  }

  /** @param {number} [freedoms] directions of the null space */
  function sayStep(freedoms) {
    if (!trace) return;
    const { heading: title, steps: lines } = iterateInWords(method, trace[method], at, { frame: made.frame, freedoms });
    setText(heading, title);
    list.replaceChildren(...lines.map(([text, equation]) => element('li', {}, text, ' ', element('span', { class: 'equation' }, equation))));
  }

  new IntersectionObserver((entries) => {
    seen = entries[entries.length - 1].isIntersecting;
    if (seen) refresh().then(() => !mine && trace && !store.view.playing && !store.view.posture && show(at));
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

/**
 * The info panel: the frame at the playhead in words and numbers, the motion as a whole, mobility, chains, warnings.
 */
import { angle, length, plural, scientific, sentence, short } from '../../core/format.js';
import { element, setText } from '../../ui/dom.js';
import { shownEnd } from '../../core/shown.js';
import { PULLED, countStatuses, metricSentence, mobilitySentence, partSentence, singularSentence, statusWords, worstFrame } from '../../core/status-words.js';

/** @param {Pick<import('../../element/workbench.js').App, 'find' | 'store' | 'player'>} app */
export function createStatus({ find, store, player }) {
  const numbers = {
    translation: find('gap-translation'),
    rotation: find('gap-rotation'),
    metric: find('metric'),
    closure: find('closure'),
    misfit: find('misfit'),
    sigma: find('sigma'),
    gradient: find('gradient'),
    iterations: find('iterations'),
  };

  function showFrame() {
    const end = shownEnd(store);
    if (!end) return;
    const { posture } = store.view;
    const name = posture?.note && end.status === 'stalled' ? 'iterate' : posture?.value !== undefined ? 'driven' : end.status;
    const { sign, word, meaning } = statusWords(name);
    setText(find('frame-title'), posture ? 'This posture' : 'This frame');
    find('frame-status').dataset.status = name;
    setText(find('frame-sign'), sign);
    setText(find('frame-word'), word);
    setText(find('frame-meaning'), (posture && !posture.note && PULLED[name]) || meaning);
    setText(numbers.translation, length(end.translation_gap, store.result.doc?.length_unit));
    setText(numbers.rotation, angle(end.rotation_gap));
    setText(numbers.metric, scientific(end.metric));
    setText(numbers.closure, scientific(end.closure));
    setText(numbers.misfit, scientific(end.misfit));
    setText(numbers.sigma, short(end.sigma_min));
    setText(numbers.gradient, scientific(end.projected_gradient));
    setText(numbers.iterations, String(end.iterations));
    showBounds(end.misfit);
  }

  /** What the numbers of the certificate are at most in an answer. @param {number} misfit */
  function showBounds(misfit) {
    const bounds = store.result.motion?.report.bounds;
    if (!bounds) return;
    const { posture } = store.view;
    // By hand it is always Newton's method that answers, and an iterate is no answer.
    const slope = posture ? store.insight?.stationary : bounds.projected_gradient;
    const shown = { closure: bounds.closure, misfit: bounds.misfit, gradient: posture?.note || posture?.value !== undefined ? undefined : slope };
    for (const [name, bound] of Object.entries(shown)) setText(find(`${name}-bound`), bound === undefined ? '' : `at most ${scientific(bound)}`);
    find('misfit-row').hidden = !(misfit > 0);
  }


  /** @param {string} text @param {number} frame */
  const jump = (text, frame) => element('button', { class: 'link', click: () => goTo(frame) }, text);

  /** @param {number} frame */
  function goTo(frame) {
    player.pause();
    player.frame = frame;
  }

  function showMotion() {
    const { motion, doc } = store.result;
    if (!motion) return;
    const { report } = motion;
    const part = partSentence(motion);
    const worst = worstFrame(motion.metric);
    find('motion-summary').replaceChildren(
      `${plural(motion.frames, 'frame')}: ${countStatuses(motion)}. Farthest from the goal in frame ${worst + 1}: `,
      jump(`${length(motion.translation_gap[worst], doc?.length_unit)}, ${angle(motion.rotation_gap[worst])}`, worst),
      `.${part && ` ${part}`}`,
    );
    setText(find('motion-metric'), metricSentence(report.metric, doc?.length_unit));
    setText(find('mobility-count'), short(report.mobility_count));
    setText(find('mobility-difference'), unknownsLessEquations(report.chains));
    setText(find('mobility-rank'), String(report.mobility_rank));
    showMobility();
    find('chain-rows').replaceChildren(
      ...report.chains.map((chain) =>
        element(
          'tr',
          {},
          element('th', { scope: 'row' }, chain.name),
          ...[chain.type, String(chain.freedoms), String(chain.constraints), chain.category].map((text) => element('td', {}, text)),
        ),
      ),
    );
    find('warnings').hidden = report.warnings.length === 0;
    find('warning-list').replaceChildren(
      ...report.warnings.map((warning) =>
        element(
          'li',
          {},
          `${sentence(warning.message)} `,
          warning.first === undefined ? '' : jump(`Show frame ${warning.first + 1}`, warning.first),
        ),
      ),
    );
  }

  /** The mobility in words, with what is peculiar to the shown posture. */
  function showMobility() {
    const { motion } = store.result;
    if (!motion) return;
    const { mobility_count: count, mobility_rank: rank } = motion.report;
    const here = singularSentence(store.insight?.mobility_rank ?? rank, rank);
    setText(find('mobility-sentence'), `${mobilitySentence(count, rank)}${here && ` ${here}`}`);
  }

  store.subscribe('insight', () => {
    showMobility();
    if (store.view.posture) showFrame();
  });
  const show = () => {
    showMotion();
    showFrame();
  };
  store.subscribe('view', showFrame);
  store.subscribe('result', show);
  show();
}

/**
 * Eq. 26 as a sum: n = 8 + Σnᵢ unknowns, the dual quaternion and the joint values, less m = 6k + 2 equations.
 * @param {{freedoms: number}[]} chains
 */
function unknownsLessEquations(chains) {
  const n = chains.reduce((sum, { freedoms }) => sum + freedoms, 8);
  const m = 6 * chains.length + 2;
  return `${n} − ${m} = ${short(n - m)}`;
}

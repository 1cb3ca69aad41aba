/**
 * The info panel: the frame at the playhead in words and numbers, the motion as a whole, mobility, chains, warnings.
 *
 * @typedef {import('../store.js').Store} Store
 * @typedef {import('../player.js').Player} Player
 */
import { angle, length, plural, scientific, short } from '../format.js';
import { byId, element, setText } from '../dom.js';
import { shownEnd } from '../shown.js';
import { parts, sentence } from './fault-note.js';
import { PULLED, countStatuses, frameSentence, mobilitySentence, singularSentence, statusWords, worstFrame } from './words.js';

/** Pause before the live region speaks, in milliseconds: while the motion plays it would never stop. */
const SPEAK_AFTER = 600;

/**
 * @param {Store} store
 * @param {Player} player
 * @param {() => void} goToFault
 */
export function createStatus(store, player, goToFault) {
  const numbers = {
    translation: byId('gap-translation'),
    rotation: byId('gap-rotation'),
    metric: byId('metric'),
    closure: byId('closure'),
    sigma: byId('sigma'),
    gradient: byId('gradient'),
    iterations: byId('iterations'),
  };
  byId('go-to-fault').addEventListener('click', goToFault);

  function showFrame() {
    const end = shownEnd(store);
    if (!end) return;
    const { posture } = store.view;
    const name = posture?.note && end.status === 'stalled' ? 'iterate' : posture?.value !== undefined ? 'driven' : end.status;
    const { sign, word, meaning } = statusWords(name);
    setText(byId('frame-title'), posture ? 'This posture' : 'This frame');
    byId('frame-status').dataset.status = name;
    setText(byId('frame-sign'), sign);
    setText(byId('frame-word'), word);
    setText(byId('frame-meaning'), (posture && !posture.note && PULLED[name]) || meaning);
    setText(numbers.translation, length(end.translation_gap, store.result.document?.length_unit));
    setText(numbers.rotation, angle(end.rotation_gap));
    setText(numbers.metric, scientific(end.metric));
    setText(numbers.closure, scientific(end.closure));
    setText(numbers.sigma, short(end.sigma_min));
    setText(numbers.gradient, scientific(end.projected_gradient));
    setText(numbers.iterations, String(end.iterations));
  }

  /** @param {string} text @param {number} frame */
  const jump = (text, frame) => element('button', { class: 'link', click: () => goTo(frame) }, text);

  /** @param {number} frame */
  function goTo(frame) {
    player.pause();
    player.frame = frame;
  }

  function showMotion() {
    const { motion, document, fault, trouble } = store.result;
    byId('fault-banner').hidden = !fault;
    setText(byId('fault-text'), fault ? `${parts(fault).what}${motion ? ' The last good motion is still shown.' : ''}` : '');
    byId('trouble').hidden = !trouble;
    setText(byId('trouble'), trouble);
    if (!motion) return;
    const { report } = motion;
    const worst = worstFrame(motion.metric);
    byId('motion-summary').replaceChildren(
      `${plural(motion.frames, 'frame')}: ${countStatuses(motion)}. Largest gap `,
      jump(`${length(motion.translation_gap[worst], document?.length_unit)}, ${angle(motion.rotation_gap[worst])}`, worst),
      '.',
    );
    setText(byId('mobility-count'), short(report.mobility_count));
    setText(byId('mobility-difference'), unknownsLessEquations(report.chains));
    setText(byId('mobility-rank'), String(report.mobility_rank));
    showMobility();
    byId('chain-rows').replaceChildren(
      ...report.chains.map((chain) =>
        element(
          'tr',
          {},
          element('th', { scope: 'row' }, chain.name),
          ...[chain.type, String(chain.freedoms), String(chain.constraints), chain.category].map((text) => element('td', {}, text)),
        ),
      ),
    );
    byId('warnings').hidden = report.warnings.length === 0;
    byId('warning-list').replaceChildren(
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

  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let speech;
  function speak() {
    clearTimeout(speech);
    speech = setTimeout(() => {
      const { motion, fault, trouble } = store.result;
      if (store.view.playing && !fault && !trouble) return;
      setText(byId('live'), fault ? sentence(fault.message) : trouble || (motion ? frameSentence(store) : ''));
    }, SPEAK_AFTER);
  }

  /** The mobility in words, with what is peculiar to the shown posture. */
  function showMobility() {
    const { motion } = store.result;
    if (!motion) return;
    const { mobility_count: count, mobility_rank: rank } = motion.report;
    const here = singularSentence(store.insight?.mobility_rank ?? rank, rank);
    setText(byId('mobility-sentence'), `${mobilitySentence(count, rank)}${here && ` ${here}`}`);
  }

  store.subscribe('insight', showMobility);
  store.subscribe('view', () => {
    showFrame();
    speak();
  });
  store.subscribe('result', () => {
    showMotion();
    showFrame();
    speak();
  });
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

/**
 * The info panel: the frame at the playhead in words and numbers, the motion as a whole, mobility, chains, warnings.
 */
import { angle, length, plural, scientific, sentence, short } from '../../core/format.js';
import { html, nothing, render } from '../../ui/render.js';
import { setText } from '../../ui/dom.js';
import { atRest } from '../../core/at-rest.js';
import { chainName } from '../../core/chain-name.js';
import { createStandardHint } from '../../core/standard-hint.js';
import { drivesJoints, told } from '../../core/driven.js';
import { hasNoGoal, isDriven, shownEnd } from '../../core/shown.js';
import {
  PULLED, countStatuses, largestGaps, metricSentence, mobilitySentence, partSentence, singularSentence, statusName, statusWords,
} from '../../core/status-words.js';

/** What the planner says where it knows of other conventions. */
const STANDARD = {
  code: 'standard-table',
  message: 'read as standard tables (Z·X) these rows fit the start and the first key frame; as modified ones (X·Z), as they are read, they do not',
  first: undefined,
};

/** Numbers that have a bound, by the ids of their outputs. @type {Record<string, string>} */
const NAMES = { closure: 'closure', misfit: 'misfit', gradient: 'projected gradient', curvature: 'least curvature' };

/** @param {Pick<import('../../element/workbench.js').AppWithPanels, 'find' | 'store' | 'player' | 'planner' | 'unfold'>} app */
export function createStatus({ find, store, player, planner, unfold }) {
  const looksStandard = createStandardHint({ store, planner }, () => showMotion());
  /** All tables, as printed. The warning goes, and the focus with it to what is told beside the table. */
  function readAsStandard() {
    store.edit((doc) => ({ ...doc, chains: doc.chains.map((chain) => (chain.joints.every(({ rows }) => rows) ? { ...chain, convention: 'standard' } : chain)) }));
    unfold(find('mechanism'));
    const tree = /** @type {ShadowRoot} */ (find('warnings').getRootNode());
    /** @type {HTMLElement | null} */ (tree.querySelector('[data-path$=".convention"]'))?.focus();
  }
  /** Where joints are driven there is no goal: nothing is said of one. @param {string[]} ids of numbers */
  function showWithGoal(ids) {
    for (const id of ids) {
      const row = find(id).closest('div');
      if (row) row.hidden = hasNoGoal(store);
    }
  }

  /** What stands first: how the shown posture ended, and its gap. */
  function showVerdict() {
    const end = shownEnd(store);
    if (!end) return;
    const { posture } = store.view;
    const driven = isDriven(posture);
    const name = posture?.note && end.status === 'stalled' ? 'iterate' : driven ? 'driven' : end.status;
    const { sign, word, meaning } = statusWords(name);
    setText(find('frame-title'), posture ? 'This posture' : 'This frame');
    find('frame-status').dataset.status = name;
    setText(find('frame-sign'), sign);
    setText(find('frame-word'), word);
    const special = posture ? (posture.note ? '' : PULLED[name]) : drivesJoints(store.result.motion) ? told.words.statusMeaning(name) : '';
    setText(find('frame-meaning'), special || meaning);
    showWithGoal(['gap-translation', 'gap-rotation']);
    setText(find('gap-translation'), length(end.translation_gap, store.result.doc?.length_unit));
    setText(find('gap-rotation'), angle(end.rotation_gap));
  }

  function showCertificate() {
    const end = shownEnd(store);
    if (!end) return;
    showWithGoal(['metric', 'gradient', 'curvature']);
    find('misfit-row').hidden = !(end.misfit > 0);
    const { gradient, curvature, bounds, out } = certificateNumbers(store, end);
    const numbers = {
      metric: scientific(end.metric),
      closure: scientific(end.closure),
      misfit: scientific(end.misfit),
      sigma: short(end.sigma_min),
      gradient: gradient === undefined ? '–' : scientific(gradient),
      curvature: curvature === undefined ? '–' : curvature === null ? 'no direction is free' : scientific(curvature),
      iterations: String(end.iterations),
    };
    for (const [id, text] of Object.entries(numbers)) setText(find(id), text);
    for (const [id, text] of Object.entries(bounds)) setText(find(`${id}-bound`), text);
    showFaults(out, end.status);
  }

  /** What is not within its bound is told beside the fold's name, and marked inside. @param {string[]} out ids of numbers @param {string} status */
  function showFaults(out, status) {
    const faults = out.map((id) => NAMES[id]);
    const note = find('certificate-fault');
    const text = faults.length ? `not within its bound: ${faults.join(', ')}` : ['stalled', 'closure_lost'].includes(status) ? 'not certified' : '';
    setText(note, text);
    note.hidden = text === '';
    for (const id of Object.keys(NAMES)) find(id).closest('div')?.classList.toggle('out', out.includes(id));
  }

  /** @param {string} text @param {number} frame */
  const jump = (text, frame) => html`<button class="link" @click=${() => goTo(frame)}>${text}</button>`;

  /** @param {number} frame */
  function goTo(frame) {
    player.pause();
    player.frame = frame;
  }

  /** The two largest gaps, each a way to its frame. @param {import('../../core/types.js').Motion} motion @param {string | undefined} unit */
  function gapsSentence(motion, unit) {
    if (drivesJoints(motion)) return '';
    const reached = Array.from({ length: motion.frames }, (_, frame) => statusName(motion, frame)).every((name) => name === 'reached');
    if (reached) return 'Every frame reaches its goal.';
    const { shift, turn } = largestGaps(motion);
    return html`Largest shift from the goal: ${jump(`${length(shift.value, unit)}, frame ${shift.frame + 1}`, shift.frame)}. Largest turn:
      ${jump(`${angle(turn.value)}, frame ${turn.frame + 1}`, turn.frame)}.`;
  }

  function showMotion() {
    const { motion, doc } = store.result;
    if (!motion) return;
    const { report } = motion;
    const unit = doc?.length_unit;
    render(
      html`${plural(motion.frames, 'frame')}: ${countStatuses(motion)}. ${gapsSentence(motion, unit)} ${partSentence(motion)}`,
      find('motion-summary'),
    );
    setText(find('motion-metric'), drivesJoints(motion) ? 'Joints are driven: there is no goal, and no distance from one.' : metricSentence(report.metric, unit));
    setText(find('mobility-count'), short(report.mobility_count));
    setText(find('mobility-difference'), unknownsLessEquations(report.chains));
    setText(find('mobility-rank'), String(report.mobility_rank));
    showMobility();
    render(
      report.chains.map(
        (chain, i) => html`<tr>
          <th scope="row">${chainName(chain, i)}</th>
          <td>${chain.type}</td>
          <td>${chain.freedoms}</td>
          <td>${chain.constraints}</td>
          <td>${chain.category}</td>
        </tr>`,
      ),
      find('chain-rows'),
    );
    const warnings = [...report.warnings, ...(looksStandard() ? [STANDARD] : [])];
    find('warnings').hidden = warnings.length === 0;
    render(
      warnings.map(
        ({ code, message, first }) => html`<li>${sentence(message)} ${first === undefined ? nothing : jump(`Show frame ${first + 1}`, first)}
          ${code === STANDARD.code && !store.readonly ? html`<button class="link" @click=${readAsStandard}>Read as standard tables</button>` : nothing}</li>`,
      ),
      find('warning-list'),
    );
  }

  /** The mobility in words, with what is peculiar to the shown posture. */
  function showMobility() {
    const { motion } = store.result;
    if (!motion) return;
    const { mobility_count: count, mobility_rank: rank } = motion.report;
    const here = singularSentence(store.why?.mobility_rank ?? rank, rank);
    setText(find('mobility-sentence'), `${mobilitySentence(count, rank)}${here && ` ${here}`}`);
  }

  store.subscribe('why', () => {
    showMobility();
    showCertificate();
  });
  for (const part of /** @type {const} */ (['view', 'result'])) store.subscribe(part, showVerdict);
  /** @type {HTMLDetailsElement} */
  const certificate = find('certificate');
  atRest(store, ['view', 'result'], showCertificate, () => certificate.open && showCertificate());
  atRest(store, ['result'], showMotion);
  showMotion();
  showVerdict();
  showCertificate();
}

/**
 * The numbers of the certificate that depend on who answers, and what every number is at most or at least in an answer: all of
 * them Rust's. A planned frame is held against the bounds of its motion, whose method may have one of its own; by hand it
 * is always Newton's method that answers; an iterate of the gradient method, whose ‖a‖ is another measure, has Newton's here.
 * @param {import('../../core/store.js').Store} store @param {NonNullable<ReturnType<typeof shownEnd>>} end
 */
export function certificateNumbers({ result: { motion }, view: { posture }, why }, end) {
  const bounds = motion?.report.bounds;
  const atMost = (/** @type {number | undefined} */ bound) => (bound === undefined ? '' : `at most ${scientific(bound)}`);
  const curvature = why?.least_curvature;
  const gradient = Number.isFinite(end.projected_gradient) ? end.projected_gradient : why?.projected_gradient;
  const steepest = posture ? why?.stationary : bounds?.projected_gradient;
  // What is on the way of a calmer motion is no closest pose, and not said to be one.
  const noGoal = hasNoGoal({ result: { motion }, view: { posture } }) || /** @type {string} */ (end.status) === 'passing';
  /** @type {[string, boolean][]} */
  const outside = [
    ['closure', end.closure > (bounds?.closure ?? Infinity)],
    ['misfit', end.misfit > (bounds?.misfit ?? Infinity)],
    ['gradient', !noGoal && (gradient ?? 0) > (steepest ?? Infinity)],
    ['curvature', !noGoal && why != null && curvature != null && curvature < -why.flat],
  ];
  return {
    gradient,
    curvature,
    /** Ids of the numbers that are not within their bounds. */
    out: outside.flatMap(([id, isOut]) => (isOut ? [id] : [])),
    bounds: {
      closure: atMost(bounds?.closure),
      misfit: atMost(bounds?.misfit),
      gradient: atMost(steepest),
      curvature: why && curvature != null ? `at least ${scientific(-why.flat)}` : '',
    },
  };
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

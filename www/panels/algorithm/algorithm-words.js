/**
 * An iterate of a planner in words and equations, as Fig. 3 of the paper has them. Knows no DOM.
 *
 * @typedef {import('../../core/types.js').History} History
 * @typedef {import('../../core/types.js').Trace} Trace
 * @typedef {'gradient' | 'newton'} Method
 */
import { plural, scientific } from '../../core/format.js';

export const METHODS = /** @type {const} */ ({ gradient: 'Gradient (the paper’s)', newton: 'Newton (the default)' });

/**
 * The slope by which each method stops. They are two measures of one thing, and differ by a factor: the gradient goes through joints and
 * dual quaternion together, Newton through motions of the workpiece.
 */
export const SLOPES = {
  gradient: {
    name: '‖a‖ of Eq. 31',
    meaning: 'the pull of the goal projected on the null space of [A], joints and dual quaternion together; lengths in units of the metric’s length. Not the projected gradient of the certificate, which is measured as Newton’s method does',
  },
  newton: { name: 'Projected gradient', meaning: 'the slope of f along the free directions, as in the certificate; lengths as shares of the mechanism’s size' },
};

/** Number of iterates that are kept. @param {History} history */
export const kept = (history) => history.iteration.length;

/** f above its minimum; Newton's open iterates may lie below it. @param {History} history @param {number} minimum */
export const above = (history, minimum) => Array.from(history.metric, (f) => Math.abs(f - minimum));

/** f at the minimum: the certified one, or the least that was met. @param {Trace} trace */
export function leastMetric({ minimum, gradient, newton }) {
  const seen = [gradient.metric.at(-1) ?? Infinity, newton.metric.at(-1) ?? Infinity];
  return minimum ?? Math.min(...seen);
}

/** @param {History} history @param {number} at @param {number} frame from 0 */
function where(history, at, frame) {
  if (at > 0) return `Iterate ${history.iteration[at]} of ${history.last}.`;
  return frame > 0 ? `The start: the answer of frame ${frame}.` : 'The start of the motion.';
}

/**
 * What happens at an iterate, step by step; the equation, if the paper has one, stands in the second place.
 * @param {Method} method @param {History} history @param {number} at @param {{frame: number, freedoms?: number}} what
 * @returns {{heading: string, steps: [string, string][]}}
 */
export function iterateInWords(method, history, at, { frame, freedoms }) {
  const heading = where(history, at, frame);
  const slope = scientific(history.projected_gradient[at]);
  const open = scientific(history.closure[at]);
  const last = at === kept(history) - 1;
  const directions = freedoms === undefined ? 'the null space of [A]' : `the ${plural(freedoms, 'direction')} of the null space of [A]`;
  if (method === 'gradient') {
    /** @type {[string, string][]} */
    const steps = [
      [`Linearise the closed loops. They are open by ${open}.`, '[A] Δr = E (21–25)'],
      [`Project the pull of the goal on ${directions}: ‖a‖ = ${slope}.`, 'a = [W]ᵀ(g − q) (31)'],
    ];
    if (last) steps.push([history.converged ? 'No direction comes nearer any more: stop.' : 'Stop: out of iterations, and not at a minimum.', '']);
    else if (history.iteration[at + 1] === history.iteration[at] + 1) {
      const share = history.share[at + 1];
      const part = share < 1 ? `Take ${scientific(share)} of the step` : 'Take the step';
      const times = plural(history.corrections[at + 1], 'correction');
      steps.push([`${part}. The loops open by ${scientific(history.opening[at + 1])}.`, 'r ← r + [W]a']);
      steps.push([`Close them again: ${times}, ‖Δr‖ = ${scientific(history.correction[at + 1])} together.`, 'r ← r − [A]⁺E (28)']);
    } else steps.push([`Step and correct in the same way; the next iterate shown is number ${history.iteration[at + 1]}.`, '(31), (28)']);
    return { heading, steps };
  }
  /** @type {[string, string][]} */
  const steps = [
    [`Each chain’s constraint wrenches leave the free twists of the workpiece. The loops are open by ${open}.`, 'Nᵢᵀ ξ = −Nᵢᵀ eᵢ'],
    [`Projected gradient, the slope of f along the free directions: ${slope}.`, '∇f on ξ'],
  ];
  if (last) steps.push([history.converged ? 'Flat, and f curves upwards in every free direction: a certified minimum.' : 'Stop: not certified.', '']);
  else if (history.guarded[at + 1] && !history.guarded[at]) {
    steps.push(['The full step is not to be trusted: begin again from the start with guarded steps, each closed and each nearer.', 'trust region']);
  } else if (history.guarded[at]) steps.push(['Step to the minimum of the quadratic model within the trusted radius, then close the loops.', 'trust region']);
  else steps.push(['Step to where slope and opening would both vanish, by the second derivative of f and of the constraints.', 'H Δ = −∇f']);
  return { heading, steps };
}

/**
 * By which factor f − f* shrinks in one iteration, over the latter half of the iterates; NaN where that cannot be told.
 * @param {History} history @param {number} minimum
 */
export function contraction(history, minimum) {
  const rest = above(history, minimum);
  // Above what rounding leaves.
  const usable = rest.reduce((last, value, i) => (value > 1e-12 ? i : last), -1);
  const half = usable >> 1;
  if (usable - half < 2) return NaN;
  return (rest[usable] / rest[half]) ** (1 / (history.iteration[usable] - history.iteration[half]));
}

/** Why one method needs few iterations and the other many. @param {Trace} trace */
export function comparison(trace) {
  const { gradient, newton } = trace;
  const rate = contraction(gradient, leastMetric(trace));
  const factor = rate < 1 ? ` (here to ${scientific(rate)} of it)` : '';
  const end = gradient.converged ? '' : ', and did not arrive';
  return (
    `Newton’s method took ${plural(newton.last, 'step')}, the gradient ${plural(gradient.last, 'step')}${end}. ` +
    `The gradient knows only the slope: each step takes away a fixed share of the distance left${factor}. ` +
    'Newton’s method also knows how the slope changes, so near the end the error of one step is about the square of the one before.'
  );
}

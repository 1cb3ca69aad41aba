/**
 * What was found by the searches for the best motion and for ways to assemble, in words.
 *
 * @typedef {import('../../core/types.js').Best} Best
 * @typedef {import('../../core/types.js').Motion} Motion
 */
import { angle, degrees, plural, scientific, short } from '../../core/format.js';

/** By how much a pose must be closer to be told as a better one: absolutely, and as a share of the other's distance. */
const CLOSER = { least: 1e-6, share: 1e-3 };

/** Whether a distance is less than another by more than what may be rounding. @param {number} one @param {number} other */
export const isCloser = (one, other) => one < other - CLOSER.least - CLOSER.share * other;

/** Below this a distance is told in powers of ten. */
const SMALL = 1e-4;

/** A distance below is one of rounding. */
const ROUNDING = 1e-12;

/** Whether a distance is none but for rounding. @param {number} value */
export const isNothing = (value) => Math.abs(value) < ROUNDING;

/** With three digits; what is above 1000 or very small in powers of ten. @param {number} value */
const threeDigits = (value) => (isNothing(value) ? '0' : value >= SMALL && value < 1000 ? String(Number(value.toPrecision(3))) : scientific(value));

/** A distance ½‖q − g‖² with three digits, so that two that are close are told apart. @param {number} value */
export const distance = threeDigits;

/** Above this share a part of a hundred reads better than one in so many. */
const OFTEN = 0.3;

/** A share in words: "1 in 200", "45 in 100". @param {number} share */
export function oneIn(share) {
  if (share > OFTEN) return `${Math.min(100, Math.round(100 * share))} in 100`;
  const many = 1 / share;
  // Two digits: it is an estimate.
  const step = 10 ** Math.max(0, Math.floor(Math.log10(many)) - 1);
  return `1 in ${Math.round(many / step) * step}`;
}

/**
 * What may not have been found yet, by Good and Turing.
 * @param {{starts: number, unseen: number, unseen_bound: number}} estimate @param {string} thing that a start leads to: "branch"
 */
export function unseenSentence({ starts, unseen, unseen_bound }, thing) {
  if (starts === 0) return '';
  if (!(unseen_bound < 1)) return `Too few starts have been made to say how many would find another ${thing}.`;
  if (unseen > 0) return `About ${oneIn(unseen)} further starts would find another ${thing} (95 %: at most ${oneIn(unseen_bound)}).`;
  return `Every ${thing} was found more than once: at most ${oneIn(unseen_bound)} further starts would find another one (95 %).`;
}

/**
 * How the branches that are known relate to the ways to assemble at a key frame, which are counted by another search; empty where
 * the numbers are the same.
 * @param {Pick<Best, 'branches'>} best @param {number} frame of the key frame @param {number} ways
 */
export function branchesSentence({ branches }, frame, ways) {
  const here = branches.filter(({ first, metric }) => first <= frame && frame < first + metric.length).length;
  if (branches.length === ways && here === ways) return '';
  return `The search for the best motion knows ${plural(branches.length, 'branch', 'branches')}, ${here} of them at this key frame: it makes its own starts, over all frames.`;
}

/** How close the best motion is to what no motion can be better than. @param {Best} best */
export function boundSentence({ best, lower_bound: bound, switches }) {
  const above = best.mean - bound;
  const least = `No motion over the branches known is closer on average than ${distance(bound)}`;
  return above > ROUNDING + 1e-6 * bound ? `${least}; this one is ${distance(above)} above it${switches.length ? ', the price of switching' : ''}.` : `${least}, and this one is as close.`;
}

/** Where nothing can be gained. */
const ALL_REACHED = 'Every frame reaches its goal: nothing can be closer.';

/** Whether nothing can be gained by a search. @param {Pick<Motion, 'status' | 'report'>} motion */
export const reachesAll = ({ status, report }) => status.every((code) => /** @type {readonly string[]} */ (report.statuses)[code] === 'reached');

/**
 * What the search has come to, in words: before it, while it goes on, where it was stopped, and at its end.
 * @param {{best: Best | null, running: boolean}} state @param {Motion | null} motion that the planner follows
 */
export function searchWords({ best, running }, motion) {
  if (!best && running) return 'Searching …';
  if (!best) return motion && reachesAll(motion) ? ALL_REACHED : 'The planner follows one branch of the linkage from frame to frame. Another branch may be closer to the goal.';
  const found = verdict(best) || 'Nothing closer has been found so far.';
  return running || best.progress === 1 ? found : `${found} The search was stopped at ${Math.floor(100 * best.progress)} %.`;
}

/** What the best motion is where its mean says no more: on other branches than the followed one, hardly closer or as close. @param {Best} best */
function otherSentence({ followed, best, switches }) {
  const how = switches.length ? `it has ${plural(switches.length, 'switch', 'switches')} to another branch` : 'it is on another branch';
  return `The best motion is not the one that the planner follows: ${how}, and on average it is ${best.mean < followed.mean ? 'hardly closer' : 'as close'}.`;
}

/** The result of the search in a sentence. @param {Best} found */
export function verdict(found) {
  const { followed, best, branches, lane, switches, progress, starts } = found;
  if (progress < 1 && !isCloser(best.mean, followed.mean)) return '';
  if (!isCloser(best.mean, followed.mean)) {
    // No other branch is looked for where there is nothing to gain.
    if (starts === 0 && branches.length > 0) return ALL_REACHED;
    if (switches.length || lane.some((branch) => branch > 0)) return otherSentence(found);
    return branches.length > 1
      ? `The motion that the planner follows is the best one over the ${branches.length} branches found.`
      : 'No other branch was found: the motion that the planner follows is the best one known.';
  }
  const by = followed.mean > 0 ? Math.round(100 * (1 - best.mean / followed.mean)) : 0;
  const changes = switches.length ? `${plural(switches.length, 'switch', 'switches')} to another branch` : 'no switch';
  return `A motion with ${changes} is closer on average by ${by < 1 ? 'less than 1' : by} %.`;
}

/** How joints move is measured in rad, or in sizes of the mechanism. @param {Motion | null} motion */
const isByAngles = (motion) => motion?.report.chains.every(({ variables }) => variables.every(({ unit }) => unit === 'rad')) ?? false;

/** A joint motion: degrees where all joints turn. @param {number} value rad or sizes @param {Motion | null} motion */
export const jointMotion = (value, motion) => (isByAngles(motion) ? angle(value) : short(value, 3));

/** The largest joint motion from frame to frame: a small one with three digits, so that two are told apart. @param {number} value rad or sizes @param {Motion | null} motion */
export const jointStep = (value, motion) => (isByAngles(motion) ? `${threeDigits(degrees(value))}°` : threeDigits(value));

/** What such a number means. @param {Motion | null} motion */
export const jointUnit = (motion) => (isByAngles(motion) ? '' : 'rad or sizes');

/** The largest joint step with its unit. @param {number} value rad or sizes @param {Motion | null} motion */
const stepWords = (value, motion) => `largest joint step ${jointStep(value, motion)}${jointUnit(motion) && ` ${jointUnit(motion)}`}`;

/** What a branch is called. @param {number} branch */
export const branchName = (branch) => (branch === 0 ? 'followed' : `branch ${branch + 1}`);

/**
 * A switch in words.
 * @param {import('../../core/types.js').Switch} one @param {Motion | null} motion
 */
export function switchSentence({ frame, from, to, length, largest }, motion) {
  const when = frame === 0 ? 'At the start' : `Before frame ${frame + 1}`;
  return `${when}: from ${from === 0 ? 'the followed branch' : `branch ${from + 1}`} to ${to === 0 ? 'the followed one' : `branch ${to + 1}`}, joint motion ${jointMotion(length, motion)}${jointUnit(motion) && ` ${jointUnit(motion)}`}, at most ${distance(largest)} from the goal on the way.`;
}

/** A point of the curve from closer to calmer. @param {{mean: number, largest_step: number}} point @param {Motion | null} motion */
export const calmWords = ({ mean, largest_step }, motion) => `mean distance ${distance(mean)}, ${stepWords(largest_step, motion)}`;

/**
 * That a motion is shown in place of the followed one; of a calmer one beside what the best one costs.
 * @param {import('../../core/types.js').MotionCost | null} calmer null for the best one itself @param {import('../../core/types.js').MotionCost} best @param {Motion | null} motion
 */
export const shownWords = (calmer, best, motion) =>
  calmer
    ? `A calmer motion is shown: mean ${distance(calmer.mean)} (best ${distance(best.mean)}), ${stepWords(calmer.largest_step, motion)} (best ${jointStep(best.largest_step, motion)})`
    : 'The best motion is shown';

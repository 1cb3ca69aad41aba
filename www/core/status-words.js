/**
 * The planner's findings in words.
 *
 * @typedef {import('./types.js').Motion} Motion
 */
import { angle, length, plural, short } from './format.js';
import { drivesJoints, told } from './driven.js';
import { groupAt, hasNoGoal, isDriven, shown } from './shown.js';

/**
 * How a frame or a posture ended: a sign that is told apart without colour, a word, and what it means.
 * @type {Record<string, {sign: string, word: string, meaning: string}>}
 */
const STATUS = {
  reached: { sign: '●', word: 'Reached', meaning: 'The workpiece is at the goal.' },
  closest: { sign: '◐', word: 'Closest', meaning: 'The closest pose found on this branch of the linkage: no pose nearby comes closer to the goal.' },
  at_limit: { sign: '◧', word: 'At a limit', meaning: 'The closest pose found on this branch: a joint limit keeps the workpiece from coming closer.' },
  stalled: { sign: '△', word: 'Stalled', meaning: 'The planner stopped before it could show that this is the closest pose.' },
  passing: { sign: '◌', word: 'Passing', meaning: 'On the way of a calmer motion or of a switch: loops closed, a pose nearby would be closer.' },
  iterate: { sign: '◇', word: 'On the way', meaning: 'A step of the planner: loops closed, the closest pose not reached yet.' },
  driven: { sign: '◆', word: 'Driven', meaning: 'One joint is driven by hand; the others follow, and every loop stays closed.' },
  closure_lost: { sign: '✕', word: 'Closure lost', meaning: 'The loops could not be closed here; the last closed position is shown instead. Do not trust this frame.' },
};

/** What the same ends mean where a hand pulls at the workpiece. @type {Record<string, string>} */
export const PULLED = {
  reached: 'The workpiece is where the hand has it.',
  closest: 'The closest pose found on this branch of the linkage: no pose nearby comes closer to where the hand pulls.',
  closure_lost: 'The loops could not be closed where the hand pulls; the linkage stays at its last closed position.',
};

/** @param {Motion} motion @param {number} frame */
export const statusName = (motion, frame) => motion.report.statuses[motion.status[frame]] ?? '';

/** @param {string} name */
export const statusWords = (name) => STATUS[name] ?? { sign: '?', word: name, meaning: '' };

/** How many frames ended in which way: "2 reached, 31 closest". @param {Motion} motion */
export function countStatuses(motion) {
  /** @type {Map<string, number>} */
  const counts = new Map();
  for (let frame = 0; frame < motion.frames; frame++) {
    const name = statusName(motion, frame);
    counts.set(name, (counts.get(name) ?? 0) + 1);
  }
  return [...counts].map(([name, count]) => `${count} ${statusWords(name).word.toLowerCase()}`).join(', ');
}

/** Of a motion that was stopped, how far it goes; else empty. @param {Motion | null} motion */
export const partSentence = (motion) => (motion?.partial ? `Planned to frame ${motion.frames} of ${motion.goal_frames}: the rest is not planned.` : '');

/** @param {ArrayLike<number>} column @returns {number} the frame of its largest value, the first of several */
export function worstFrame(column) {
  let worst = 0;
  for (let frame = 1; frame < column.length; frame++) if (column[frame] > column[worst]) worst = frame;
  return worst;
}

/**
 * The two largest gaps of a motion and their frames; they need not fall in the same one.
 * @param {Pick<Motion, 'translation_gap' | 'rotation_gap'>} motion
 */
export function largestGaps({ translation_gap, rotation_gap }) {
  const [shift, turn] = [worstFrame(translation_gap), worstFrame(rotation_gap)];
  return { shift: { frame: shift, value: translation_gap[shift] }, turn: { frame: turn, value: rotation_gap[turn] } };
}

/**
 * Up to which size a gap is rounding, and shown as none: what a goal that counts as reached may leave, in the report's
 * metric. Half the angle turns a quaternion, and half the shift over the length moves a dual one, so both count double.
 * @param {Pick<Motion, 'report'>} motion
 */
export function roundingGaps({ report: { bounds, metric } }) {
  const difference = Math.sqrt(2 * bounds.reached);
  return { shift: 2 * difference * metric.length, turn: 2 * difference };
}

/** What the metrics are called. @type {Record<string, string>} */
export const METRICS = { pose: 'pose', 'dual-quaternion': 'dual quaternion' };

/** Where a metric's length comes from. @type {Record<Motion['report']['metric']['length_source'], string>} */
export const LENGTH_SOURCES = {
  given: 'as the document says',
  mechanism: 'the mechanism’s size',
  motion: 'the extent of the motion',
  none: 'mechanism and motion have no other length',
};

/** How distances from the goal are measured. @param {Motion['report']['metric']} metric @param {string | undefined} unit */
export function metricSentence({ kind, length: of, length_source, origin }, unit) {
  const about = origin ? ` about (${origin.map((x) => short(x, 3)).join(', ')})${unit ? ` ${unit}` : ''}` : '';
  return `Metric: ${METRICS[kind]}${about}; a shift by ${length(of, unit)} (${LENGTH_SOURCES[length_source]}) weighs as much as a turn by 1 rad.`;
}

/** Mobility in a sentence. @param {number} count by Eq. 10 @param {number} rank n − rank [A] at the start */
export function mobilitySentence(count, rank) {
  const free = rank === 0 ? 'The workpiece cannot move' : `The workpiece moves with ${plural(rank, 'freedom')}`;
  if (count === rank) return `${free}, as the count says.`;
  const counted = `counting gives ${short(count)}`;
  if (rank < count) return `${free}, though ${counted}: some of the counted freedoms do not move it.`;
  if (rank === 0) return `${free}: ${counted}, more constraints than it takes to hold it.`;
  return `${free}, though ${counted}: some of the chains’ constraints repeat each other (parallel or meeting axes, or a singular position).`;
}

/**
 * What the rank at the shown posture says beside that at the start; empty if it says the same.
 * @param {number} here n − rank [A] there @param {number} start n − rank [A] at the start
 */
export function singularSentence(here, start) {
  if (here === start) return '';
  const word = here > start ? 'gains' : 'loses';
  return `Here the rank gives ${here}, not ${start}: at a singular position the linkage ${word} freedoms for the instant.`;
}

/** The frame at the playhead in one sentence. @param {import('./store.js').Store} store */
export function frameSentence(store) {
  const { motion, doc } = store.result;
  if (!motion) return '';
  const { frame, posture } = store.view;
  if (posture) return postureSentence(posture, doc?.length_unit);
  const name = statusName(motion, frame);
  const head = `Frame ${frame + 1} of ${motion.goal_frames}: `;
  if (drivesJoints(motion)) return `${head}${[statusWords(name).word.toLowerCase(), told.words.drivenWords(motion, doc, frame)].filter(Boolean).join(', ')}.`;
  return `${head}${endWords(name, motion.translation_gap[frame], motion.rotation_gap[frame], 'the goal', doc?.length_unit)}.`;
}

/**
 * How a pose ended and how far it is from what was asked for. Where the loops are open, being near means nothing.
 * @param {string} name of the status @param {number} shift @param {number} turn in radians
 * @param {'the goal' | 'the hand'} from @param {string | undefined} unit
 */
export function endWords(name, shift, turn, from, unit) {
  if (name === 'closure_lost') return 'closure lost: the loops could not be closed here, and the last closed position is shown';
  return `${statusWords(name).word.toLowerCase()}, ${length(shift, unit)} and ${angle(turn)} from ${from}`;
}

/**
 * Where the linkage stands in place of a frame, in one sentence.
 * @param {NonNullable<import('./types.js').View['posture']>} posture @param {string | undefined} unit
 */
function postureSentence(posture, unit) {
  const { note, obstacle, status, translation_gap, rotation_gap } = posture;
  if (isDriven(posture)) return obstacle ?? 'A joint is driven by hand; the others follow.';
  if (note) return `${note} ${length(translation_gap, unit)} and ${angle(rotation_gap)} from the goal.`;
  return `Pulled by hand: ${endWords(status, translation_gap, rotation_gap, 'the hand', unit)}.`;
}

/** What the 3D view shows, as text. @param {import('./store.js').Store} store */
export function describeScene(store) {
  const { motion } = store.result;
  const now = shown(store);
  if (!motion || !now) return '';
  const { doc } = now;
  const unit = doc.length_unit ? ` ${doc.length_unit}` : '';
  const at = (/** @type {Float64Array} */ column) => `(${Array.from(groupAt(column, now).subarray(0, 3), (value) => short(value, 3)).join(', ')})${unit}`;
  const types = motion.report.chains.map((chain) => chain.type).join(', ');
  return (
    `${doc.name || 'A linkage'}: ${plural(motion.report.chains.length, 'chain')} (${types}) ${motion.report.chains.length === 1 ? 'carries' : 'carry'} one workpiece. ` +
    `${frameSentence(store)} Workpiece at ${at(now.pose)}${hasNoGoal(store) ? '' : `; goal at ${at(now.goal)}`}.`
  );
}

/**
 * The joints as a hand can move them: each variable's range, and the drive that keeps the loops closed. No DOM.
 *
 * @typedef {import('../../core/types.js').Motion} Motion
 * @typedef {import('../../core/types.js').MechanismDocument} MechanismDocument
 * @typedef {object} Variable one joint variable; values in degrees or lengths
 * @property {number} index in the columns of all joint variables
 * @property {number} chain
 * @property {number} joint of the chain
 * @property {number} freedom of the joint
 * @property {string} name θ₁ or d₂
 * @property {boolean} turns
 * @property {number | null} min its limits
 * @property {number | null} max
 * @property {[number, number]} range of its slider
 */
import { ask } from '../../core/ask.js';
import { textOf } from '../../core/document-text.js';
import { degrees } from '../../core/format.js';
import { chainVariables, variableName } from '../../core/joint-types.js';
import { groupAt, shown } from '../../core/shown.js';

/** A slider without limits may go this far beyond the motion, as a share of the motion's largest length. */
const ROOM = 0.5;

/** @param {Motion} motion @param {MechanismDocument} doc @returns {Variable[]} */
export function variablesOf(motion, doc) {
  const width = motion.joints.length / motion.frames;
  const column = (/** @type {number} */ index) => Array.from({ length: motion.frames }, (_, frame) => motion.joints[frame * width + index]);
  let reach = 0;
  for (let i = 0; i < motion.pose.length; i++) if (i % 7 < 3) reach = Math.max(reach, Math.abs(motion.pose[i]));
  let index = 0;
  return doc.chains.flatMap((chain, number) =>
    chainVariables(chain).map(({ variable, joint, freedom, row }) => {
      const turns = variable === 'theta';
      const limit = chain.joints[joint].limits?.[freedom];
      const bound = (/** @type {'min' | 'max'} */ key) => (typeof limit?.[key] === 'number' ? limit[key] : null);
      const [min, max] = [bound('min'), bound('max')];
      const values = column(index).map((value) => (turns ? degrees(value) : value));
      const [low, high] = [Math.min(...values), Math.max(...values)];
      const room = ROOM * Math.max(reach, high - low);
      const free = turns ? [Math.min(-180, low), Math.max(180, high)] : [low - room, high + room];
      return {
        index: index++,
        chain: number,
        joint,
        freedom,
        name: variableName(variable, row),
        turns,
        min,
        max,
        range: /** @type {[number, number]} */ ([min ?? free[0], max ?? free[1]]),
      };
    }),
  );
}

/** A joint value as a person reads it: degrees or a length. @param {Variable} variable @param {number} value */
export const readable = ({ turns }, value) => (turns ? degrees(value) : value);

/**
 * Drives a joint from what is shown and shows where that led.
 * @param {Pick<import('../../element/workbench.js').App, 'store' | 'planner'>} app
 * @param {Variable} variable
 * @param {number} value degrees or length
 * @returns {Promise<string | null>} why it did not get there, empty if it did; null if the answer came too late
 */
export async function driveShown({ store, planner }, { index, turns }, value) {
  const now = shown(store);
  if (!now) return null;
  const wanted = turns ? (value * Math.PI) / 180 : value;
  const driven = await ask(() => planner.drive(textOf(now.doc), groupAt(now.joints, now).slice(), index, wanted), 'drive the joint');
  if (driven.is === 'late') return null;
  if (driven.is !== 'answer') return driven.message;
  const posture = driven.value;
  if (store.result.doc !== now.doc) return null;
  store.setView({ posture, playing: false });
  return posture.obstacle ?? '';
}

/**
 * Things of the scene by their places in the document: which there are, what each is called, which belong together.
 * Beside the document's own places there are `workpiece`, `goal`, `closest` (the two motions), `gap` (at the playhead)
 * and `gap[40]` (at frame 40, from 0), and `ghost[40]`. A link is the table row that holds its dimensions.
 *
 * @typedef {import('./types.js').MechanismDocument} MechanismDocument
 * @typedef {Pick<import('./store.js').Store, 'result' | 'view'>} Shown
 */
import { closestName } from './best-motions.js';
import { keyFramesOf } from './key-frames.js';
import { drivesJoints } from './driven.js';
import { chainName } from './chain-name.js';
import { angle, length } from './format.js';
import { chainType, jointOf } from './joint-types.js';
import { covers, parsePath } from './path.js';

/** Every thing that can be chosen, in the order in which the keyboard goes through them. @param {MechanismDocument} doc */
export function thingsOf(doc) {
  const chains = doc.chains.flatMap(({ joints }, chain) => {
    const place = `chains[${chain}]`;
    return [`${place}.base`, ...joints.map((_, joint) => `${place}.joints[${joint}]`), `${place}.gripper`];
  });
  return ['workpiece', ...chains, ...keyFramesOf(doc).map((_, key) => `motion.key_frames[${key}]`), 'goal', 'closest', 'gap'];
}

/**
 * Whether a thing is shown as chosen when `chosen` is: all of a chain with the chain, a joint with its rows and limits.
 * @param {string} thing
 * @param {string} chosen
 */
export function belongs(thing, chosen) {
  if (!chosen) return false;
  if (thing === chosen) return true;
  const link = thing.includes('.rows[');
  // A joint's first row has the dimensions of the link before it, which is no part of the joint.
  if (link && chosen.includes('.joints[') && !chosen.includes('.rows[')) return false;
  if (covers(chosen, thing) >= 0) return true;
  const parts = /^chains\[\d+\]\.(joints\[\d+\]|base|gripper)|^motion\.key_frames\[\d+\]/;
  return parts.test(thing) && !(chosen.includes('.rows[') && !link) && covers(thing, chosen) >= 0;
}

/**
 * What a thing is, in words: "chain 2, joint 3: S, spherical".
 * @param {string} place
 * @param {Shown} shown
 * @returns {string} empty if there is no such thing
 */
export function nameOf(place, { result, view }) {
  // The types of joints by the planner's letters.
  const doc = result.plain ?? result.doc;
  const [head, first, part, second, inner] = parsePath(place);
  if (!doc) return '';
  if (place === 'workpiece') return 'workpiece';
  if (place === 'goal') return 'goal motion';
  if (place === 'closest') return drivesJoints(result.motion) ? 'path of the workpiece' : closestName(result.motion);
  if (head === 'gap') return gapName(typeof first === 'number' ? first : null, { result, view });
  if (head === 'ghost') return `ghost of the workpiece at frame ${Number(first) + 1}`;
  if (head === 'motion' && first === 'key_frames' && typeof part === 'number') {
    const key = keyFramesOf(doc)[part];
    return key ? `key frame ${key.name ? `“${key.name}”` : part + 1}` : '';
  }
  if (head === 'motion' && first === 'drivers') return `driver ${Number(part) + 1}`;
  const chain = head === 'chains' && typeof first === 'number' ? doc.chains[first] : undefined;
  if (!chain) return '';
  const name = chainName(chain, Number(first));
  if (part === 'wrench') return `what ${name} withstands`;
  if (part === 'base' || part === 'gripper') return `${part} of ${name}`;
  if (part !== 'joints' || typeof second !== 'number') return `${name}: ${chainType(chain)}`;
  const joint = chain.joints[second];
  if (!joint) return '';
  if (inner === 'rows') return second === 0 ? `link from the base of ${name} to its first joint` : `link ${second} of ${name}`;
  return `${name}, joint ${second + 1}: ${joint.type}, ${jointOf(joint.type)?.name ?? 'no joint'}`;
}

/** @param {number | null} frame null for what is shown now @param {Shown} shown */
function gapName(frame, { result: { motion, doc }, view }) {
  if (!motion) return '';
  const unit = doc?.length_unit;
  const size = (/** @type {number} */ shift, /** @type {number} */ turn) => `${length(shift, unit)}, ${angle(turn)}`;
  if (frame === null && view.posture) return `gap: ${size(view.posture.translation_gap, view.posture.rotation_gap)}`;
  const at = Math.min(frame ?? view.frame, motion.frames - 1);
  return `gap at frame ${at + 1}: ${size(motion.translation_gap[at], motion.rotation_gap[at])}`;
}

/**
 * The same document with its angles in the other unit: degrees or radians.
 *
 * @typedef {import('./types.js').MechanismDocument} MechanismDocument
 * @typedef {'degrees' | 'radians'} AngleUnit
 */
import { JOINT_TYPES } from './joint-types.js';

/** What depends on the unit of angles within an expression. */
const DEPENDS = /\b(a?sin|a?cos|a?tan|atan2|deg|rad)\b/i;

/** Only the name changes: the same numbers are other angles. @param {MechanismDocument} doc @param {AngleUnit} unit @returns {MechanismDocument} */
export function reread(doc, unit) {
  const { angles: _, ...rest } = doc;
  if (unit === 'degrees') return rest;
  const { chains, motion, planner, ...head } = rest;
  return { ...head, angles: unit, chains, motion, ...(planner && { planner }) };
}

/**
 * The document in the other unit with the same angles.
 * @param {MechanismDocument} doc
 * @param {AngleUnit} unit
 * @returns {{doc: MechanismDocument} | {fault: string}} a fault where an expression would mean something else
 */
export function convertAngles(doc, unit) {
  const factor = unit === 'radians' ? Math.PI / 180 : 180 / Math.PI;
  let expression = '';
  /** @param {any} value @returns {any} */
  const times = (value) => {
    if (typeof value === 'string' && value.trim() !== '') expression ||= value;
    return typeof value === 'number' ? Number((value * factor).toPrecision(15)) : Array.isArray(value) ? value.map(times) : value;
  };
  /** @template {object} T @param {T} part @param {string[]} keys @returns {T} */
  const turned = (part, keys) => /** @type {T} */ (Object.fromEntries(Object.entries(part).map(([key, value]) => [key, keys.includes(key) ? times(value) : value])));
  const frame = (/** @type {any} */ part) => turned(part, ['longitude', 'latitude', 'roll', 'roll_pitch_yaw']);
  const kinds = doc.chains.map((chain) => chain.joints.map(({ type }) => (JOINT_TYPES[type]?.rows ?? []).flat().map((variable) => variable === 'theta')));
  const chains = doc.chains.map((chain, c) => {
    const joints = chain.joints.map((joint, j) => ({
      ...joint,
      ...(joint.rows && { rows: joint.rows.map((row) => turned(row, ['alpha', 'theta'])) }),
      ...(joint.limits && { limits: joint.limits.map((limit, i) => (limit && kinds[c][j][i] ? turned(limit, ['min', 'max']) : limit)) }),
    }));
    const turns = kinds[c].flat();
    return {
      ...chain,
      joints,
      ...(chain.base && { base: frame(chain.base) }),
      ...(chain.gripper && { gripper: frame(chain.gripper) }),
      ...(chain.start && { start: chain.start.map((value, i) => (turns[i] ? times(value) : value)) }),
    };
  });
  const drivers = /** @type {any[] | undefined} */ (/** @type {any} */ (doc.motion).drivers)?.map((driver) => {
    const turns = kinds[driver.chain - 1]?.[driver.joint - 1]?.[(driver.freedom ?? 1) - 1];
    return turns ? { ...driver, values: driver.values?.map((/** @type {object} */ value) => turned(value, ['value'])) } : driver;
  });
  const motion = { ...doc.motion, ...(doc.motion.key_frames && { key_frames: doc.motion.key_frames.map(frame) }), ...(drivers && { drivers }) };
  const fresh = { ...reread(doc, unit), ...(doc.home && { home: frame(doc.home) }), chains, motion };
  const depends = JSON.stringify(doc).match(/"(?:[^"\\]|\\.)*"/g)?.map((text) => text.slice(1, -1)).find((text) => text !== doc.name && text !== doc.about && /[()\d]/.test(text) && DEPENDS.test(text));
  const culprit = expression || depends;
  if (culprit) return { fault: `The expression “${culprit}” would mean another angle: write it as a number first, or only read the numbers anew.` };
  return { doc: fresh };
}

/**
 * The same mechanism written in another unit of length.
 *
 * @typedef {import('./types.js').MechanismDocument} MechanismDocument
 */
import { jointOf } from './joint-types.js';

/** Units of length by their usual names, in metres. */
const METRES = new Map(Object.entries({ nm: 1e-9, 'µm': 1e-6, um: 1e-6, mm: 1e-3, cm: 0.01, dm: 0.1, m: 1, km: 1000, in: 0.0254, ft: 0.3048, yd: 0.9144 }));

/**
 * How many of one unit are one of another: 1000 from m to mm; null where a name is not known.
 * @param {string | undefined} from @param {string} to
 */
export function factorBetween(from, to) {
  const [old, fresh] = [from, to].map((unit) => METRES.get((unit ?? '').trim()));
  return old && fresh ? Number((old / fresh).toPrecision(12)) : null;
}

/** What an earlier conversion has made of an expression: a factor and, in parentheses, the rest. */
const SCALED = /^([\d.e+-]+)\*\((.*)\)$/;

/** Whether every parenthesis of a text is closed in it. @param {string} text */
function isBalanced(text) {
  let depth = 0;
  for (const letter of text) {
    if (letter === '(') depth++;
    if (letter === ')' && --depth < 0) return false;
  }
  return depth === 0;
}

/** An expression times a factor; a factor that is there already takes it up. @param {string} text @param {number} factor */
function timesText(text, factor) {
  const [, before, inner] = SCALED.exec(text) ?? [];
  const isScaled = inner !== undefined && Number.isFinite(Number(before)) && isBalanced(inner);
  const whole = Number((isScaled ? Number(before) * factor : factor).toPrecision(12));
  const rest = isScaled ? inner : text;
  return whole === 1 ? rest : `${whole}*(${rest})`;
}

/**
 * Multiplies every length by a factor. An expression of a length is multiplied as a whole, and parameters stay as they are:
 * what one of them measures depends on its uses. The metric length too, where the document gives one, so that shifts weigh as much
 * against turns as before; the dimension tolerance is a share of the size, and stays.
 * @param {MechanismDocument} doc
 * @param {number} factor
 * @param {string} unit
 * @returns {MechanismDocument}
 */
export function convertLengths(doc, factor, unit) {
  const times = (/** @type {any} */ value) =>
    typeof value === 'number' ? Number((value * factor).toPrecision(12)) : typeof value === 'string' && value.trim() ? timesText(value, factor) : value;
  /** @template {object} T @param {T} from @param {string[]} keys @returns {T} */
  const scaled = (from, keys) => /** @type {T} */ (Object.fromEntries(Object.entries(from).map(([key, value]) => [key, keys.includes(key) ? times(value) : value])));
  const place = (/** @type {any} */ frame) => frame && scaled(frame, ['x', 'y', 'z']);

  const chains = doc.chains.map((chain) => {
    const slides = chain.joints.flatMap(({ type }) => jointOf(type)?.rows.flat() ?? []).map((variable) => variable === 'd');
    let variable = 0;
    const joints = chain.joints.map((joint) => {
      const first = variable;
      variable += jointOf(joint.type)?.rows.flat().length ?? 0;
      const limits = joint.limits?.map((limit, i) => (limit && slides[first + i] ? scaled(limit, ['min', 'max']) : limit));
      const point = joint.point?.map(times);
      return { ...joint, ...(point && { point }), ...(joint.rows && { rows: joint.rows.map((row) => scaled(row, ['a', 'd'])) }), ...(limits && { limits }) };
    });
    const start = chain.start?.map((value, i) => (slides[i] ? times(value) : value));
    return { ...chain, joints, ...(chain.base && { base: place(chain.base) }), ...(chain.gripper && { gripper: place(chain.gripper) }), ...(start && { start }) };
  });
  const { reference } = doc.motion;
  const motion = {
    ...scaled(doc.motion, ['radius']),
    ...(Array.isArray(reference) && { reference: reference.map(times) }),
    ...(doc.motion.key_frames && { key_frames: doc.motion.key_frames.map(place) }),
    ...(doc.motion.drivers && { drivers: doc.motion.drivers.map((driver) => (slidesWith(doc, driver) ? { ...driver, values: driver.values.map((one) => scaled(one, ['value'])) } : driver)) }),
  };
  const { planner } = doc;
  const origin = planner?.metric_origin;
  return {
    ...doc,
    length_unit: unit,
    ...(doc.home && { home: place(doc.home) }),
    chains,
    motion,
    ...(planner && { planner: { ...scaled(planner, ['metric_length']), ...(Array.isArray(origin) && { metric_origin: origin.map(times) }) } }),
  };
}

/** Whether a driver moves a joint along its axis. @param {MechanismDocument} doc @param {import('./types.js').Driver} driver */
function slidesWith(doc, { chain, joint, freedom = 1 }) {
  const type = doc.chains[Number(chain) - 1]?.joints[Number(joint) - 1]?.type;
  return type !== undefined && jointOf(type)?.rows.flat()[Number(freedom) - 1] === 'd';
}

/**
 * Frames of a document that may be given by expressions or in another form, as numbers.
 *
 * @typedef {import('./types.js').Frame} Frame
 */
import { inDegrees } from './document-angles.js';
import { valueAt } from './path.js';

const COORDINATES = /** @type {const} */ (['x', 'y', 'z', 'longitude', 'latitude', 'roll']);

/** Other forms of a frame's turn, in place of the three angles. */
const FORMS = /** @type {const} */ (['quaternion_wxyz', 'quaternion_xyzw', 'matrix', 'roll_pitch_yaw', 'order']);

/** A frame without the other forms of its turn, so that the three angles hold. @template {Frame} F @param {F} frame @returns {F} */
export function withoutForms(frame) {
  if (FORMS.every((form) => frame[form] === undefined)) return frame;
  return /** @type {F} */ (Object.fromEntries(Object.entries(frame).filter(([name]) => !FORMS.some((form) => form === name))));
}

/**
 * The numbers of a frame of the document: lengths, and angles in degrees. What is given by an expression or in another form is
 * taken from the plain document of the last motion, if it was the same there.
 * @param {Pick<import('./store.js').Store, 'doc' | 'result'>} store @param {string} path
 * @returns {Record<'x' | 'y' | 'z' | 'longitude' | 'latitude' | 'roll', number> | null} null where a number is not known
 */
export function frameNumbers({ doc, result }, path) {
  const frame = valueAt(doc, path);
  if (!frame) return null;
  const [before, plain] = [valueAt(result.doc, path), valueAt(result.plain, path)];
  const isForm = FORMS.some((form) => frame[form] !== undefined);
  const sameForm = isForm && FORMS.every((form) => JSON.stringify(frame[form]) === JSON.stringify(before?.[form]));
  const numbers = COORDINATES.map((name) => {
    const own = frame[name] ?? 0;
    const isAngle = name.length > 1;
    if (typeof own === 'number' && !(isAngle && isForm)) return isAngle ? inDegrees(doc, own) : own;
    const known = isAngle && isForm ? sameForm : before?.[name] === own;
    return known ? plain?.[name] : undefined;
  });
  if (numbers.some((value) => typeof value !== 'number')) return null;
  return /** @type {any} */ (Object.fromEntries(COORDINATES.map((name, at) => [name, numbers[at]])));
}

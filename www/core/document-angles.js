/**
 * Angles of a document, which may be in radians.
 *
 * @typedef {import('./types.js').MechanismDocument} MechanismDocument
 * @typedef {import('./types.js').Frame} Frame
 */
const ANGLES = /** @type {const} */ (['longitude', 'latitude', 'roll']);

/** Degrees as the document writes them. @param {MechanismDocument} doc @param {number} degrees */
export const asWritten = (doc, degrees) => (doc.angles === 'radians' ? (degrees * Math.PI) / 180 : degrees);

/** The document's angle in degrees. @param {MechanismDocument} doc @param {number} angle */
export const inDegrees = (doc, angle) => (doc.angles === 'radians' ? (angle * 180) / Math.PI : angle);

/** A frame with angles in degrees as the document writes it. @template {Frame} F @param {MechanismDocument} doc @param {F} frame @returns {F} */
export function frameAsWritten(doc, frame) {
  if (doc.angles !== 'radians') return frame;
  const turn = ANGLES.flatMap((name) => (typeof frame[name] === 'number' ? [[name, asWritten(doc, /** @type {number} */ (frame[name]))]] : []));
  return { ...frame, ...Object.fromEntries(turn) };
}

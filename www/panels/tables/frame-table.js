/**
 * The paper's table of frames: x, y, z, longitude, latitude, roll, one frame a row.
 */
import { angleUnit, lengthUnit } from '../../core/format.js';
import { valueAt } from '../../core/path.js';
import { html, nothing } from '../../ui/render.js';

/** @type {[import('../../core/types.js').Frame extends infer F ? keyof F : never, string, 'length' | 'angle', string][]} */
const COORDINATES = [
  ['x', 'x', 'length', 'x'],
  ['y', 'y', 'length', 'y'],
  ['z', 'z', 'length', 'z'],
  ['longitude', 'lon', 'angle', 'longitude'],
  ['latitude', 'lat', 'angle', 'latitude'],
  ['roll', 'roll', 'angle', 'roll'],
];

/** The six column heads with their units. @param {import('../../core/types.js').MechanismDocument} doc */
export const coordinateHeads = (doc) =>
  COORDINATES.map(([, short, kind, long]) => html`<th scope="col"><abbr title=${long}>${short}</abbr><small>${kind === 'length' ? lengthUnit(doc.length_unit) : angleUnit(doc).sign}</small></th>`);

/** The forms of a rotation beside longitude, latitude, roll, whose cells are loaded when a document has one. */
const OTHER = /** @type {const} */ (['quaternion_wxyz', 'quaternion_xyzw', 'matrix', 'roll_pitch_yaw']);

/** Whether a frame's rotation is not longitude, latitude, roll. @param {any} frame */
export const hasOtherTurn = (frame) => OTHER.some((key) => frame?.[key] != null);

/**
 * The six cells of one frame; in place of the last three one with its rotation, where that has another form.
 * @param {ReturnType<typeof import('./cells.js').createCells>} cells
 * @param {string} path
 * @param {string} name for screen readers
 * @param {import('../../core/types.js').MechanismDocument} doc
 * @param {ReturnType<typeof import('./typed-parts.js').createTypedParts>} typed
 */
export function coordinateCells(cells, path, name, doc, typed) {
  const form = OTHER.find((key) => valueAt(doc, path)?.[key] != null);
  const { sign, name: angles, decimals } = angleUnit(doc);
  const plain = (form ? COORDINATES.slice(0, 3) : COORDINATES).map(([key, short, kind, long]) => {
    const label = `${name}, ${long} in ${kind === 'length' ? lengthUnit(doc.length_unit) : angles}`;
    // Home may be left out, as a whole or in part.
    const home = path === 'home' && { optional: true, fallback: () => 0 };
    const cell = cells.input({ path: `${path}.${key}`, column: key, label, decimals: kind === 'angle' ? decimals : undefined, ...home });
    return html`<td data-head="${short} ${kind === 'length' ? lengthUnit(doc.length_unit) : sign}">${cell}</td>`;
  });
  return html`${plain}${form ? (typed.get()?.rotationCell(cells, `${path}.${form}`, form, name, doc) ?? html`<td colspan="3">…</td>`) : nothing}`;
}

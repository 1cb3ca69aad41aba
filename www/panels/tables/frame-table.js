/**
 * The paper's table of frames: x, y, z, longitude, latitude, roll, one frame a row.
 */
import { ANGLE_DECIMALS, lengthUnit } from '../../core/format.js';
import { html } from '../../ui/render.js';

/** @type {[import('../../core/types.js').Frame extends infer F ? keyof F : never, string, 'length' | 'angle', string][]} */
const COORDINATES = [
  ['x', 'x', 'length', 'x'],
  ['y', 'y', 'length', 'y'],
  ['z', 'z', 'length', 'z'],
  ['longitude', 'lon', 'angle', 'longitude'],
  ['latitude', 'lat', 'angle', 'latitude'],
  ['roll', 'roll', 'angle', 'roll'],
];

/** The six column heads with their units. @param {string | undefined} unit */
export const coordinateHeads = (unit) =>
  COORDINATES.map(([, short, kind, long]) => html`<th scope="col"><abbr title=${long}>${short}</abbr><small>${kind === 'length' ? lengthUnit(unit) : '°'}</small></th>`);

/**
 * The six cells of one frame.
 * @param {ReturnType<typeof import('./cells.js').createCells>} cells
 * @param {string} path
 * @param {string} name for screen readers
 * @param {string | undefined} unit
 */
export const coordinateCells = (cells, path, name, unit) =>
  COORDINATES.map(([key, short, kind, long]) => {
    const label = `${name}, ${long} in ${kind === 'length' ? lengthUnit(unit) : 'degrees'}`;
    const cell = cells.input({ path: `${path}.${key}`, column: key, label, decimals: kind === 'angle' ? ANGLE_DECIMALS : undefined });
    return html`<td data-head="${short} ${kind === 'length' ? lengthUnit(unit) : '°'}">${cell}</td>`;
  });

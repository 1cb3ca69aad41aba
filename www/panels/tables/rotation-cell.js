/**
 * A frame's rotation as quaternion, matrix or three angles, in one cell of its table.
 */
import { angleUnit } from '../../core/format.js';
import { ORDERS, frameWith, turnOfFrame } from '../../core/rotation-forms.js';
import { setValue } from '../../core/edits.js';
import { valueAt } from '../../core/path.js';
import { html, nothing } from '../../ui/render.js';

/** @type {Record<string, string[]>} */
const NAMES = {
  quaternion_wxyz: ['w', 'x', 'y', 'z'],
  quaternion_xyzw: ['x', 'y', 'z', 'w'],
  roll_pitch_yaw: ['roll', 'pitch', 'yaw'],
};
const ROWS = [0, 1, 2];
const WORDS = /** @type {Record<string, string>} */ ({ quaternion_wxyz: 'w x y z', quaternion_xyzw: 'x y z w', matrix: 'matrix', roll_pitch_yaw: 'angles' });

/**
 * @param {ReturnType<typeof import('./cells.js').createCells>} cells
 * @param {string} path of the rotation: the frame's, and the form
 * @param {string} form
 * @param {string} name of the frame, for screen readers
 * @param {import('../../core/types.js').MechanismDocument} doc
 */
export function rotationCell(cells, path, form, name, doc) {
  const { sign, name: unit, decimals } = angleUnit(doc);
  const input = (/** @type {string} */ at, /** @type {string} */ what) =>
    cells.input({ path: `${path}${at}`, column: `${form}${at}`, label: `${name}, ${what}`, decimals: form === 'roll_pitch_yaw' ? decimals : undefined });
  const fields =
    form === 'matrix'
      ? ROWS.flatMap((row) => ROWS.map((column) => input(`[${row}][${column}]`, `matrix, row ${row + 1}, column ${column + 1}`)))
      : NAMES[form].map((part, index) => input(`[${index}]`, form === 'roll_pitch_yaw' ? `${part} in ${unit}` : `${part} of the quaternion`));
  return html`<td colspan="3" class="rotation" data-head="${WORDS[form]} ${form === 'roll_pitch_yaw' ? sign : ''}">
    <div class=${form === 'matrix' ? 'matrix' : 'point'} data-path=${path} role="group" aria-label="${name}, ${form.replaceAll('_', ' ')}">
      ${form === 'matrix' ? nothing : html`<small>${WORDS[form]}</small>`}${fields}${form === 'roll_pitch_yaw' ? orderChoice(cells, path, name, doc) : nothing}
    </div>
  </td>`;
}

/** Another order keeps the rotation, where its angles are numbers. @param {ReturnType<typeof import('./cells.js').createCells>} cells @param {string} path @param {string} name @param {import('../../core/types.js').MechanismDocument} doc */
function orderChoice(cells, path, name, doc) {
  const frame = path.replace(/\.roll_pitch_yaw$/, '');
  return cells.select({
    path: `${frame}.order`,
    label: `${name}, order of the angles; capitals: about moving axes`,
    options: [...(valueAt(doc, frame)?.order == null ? [/** @type {[string, string]} */ (['', 'xyz'])] : []), ...ORDERS.map((order) => /** @type {[string, string]} */ ([order, order]))],
    write(present, order) {
      const old = valueAt(present, frame);
      const turn = turnOfFrame(old, present);
      return setValue(present, frame, turn ? frameWith(old, turn, present, { order }) : { ...old, order });
    },
  });
}

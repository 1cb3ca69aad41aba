/**
 * A setting with its name, what it means, and its control; and a point of three lengths as one control.
 */
import * as edits from '../../core/edits.js';
import { html, nothing } from '../../ui/render.js';

/**
 * @param {{label: string, title?: string, note?: string, control: unknown, group?: boolean, hidden?: boolean}} setting `group`: the
 *   control is a group of cells, which has a name of its own; a label names one cell only
 */
export function setting({ label, title, note, control, group, hidden = false }) {
  const parts = html`<span title=${title ?? nothing}>${label}</span>${control}${note ? html`<small>${note}</small>` : nothing}`;
  return group ? html`<div class="field" ?hidden=${hidden}>${parts}</div>` : html`<label class="field" ?hidden=${hidden}>${parts}</label>`;
}

/**
 * @param {ReturnType<typeof import('./cells.js').createCells>} cells
 * @param {{path: string, label: string, fallback: () => number[]}} spec `fallback` is what holds where the document gives nothing
 */
export function pointCells(cells, { path, label, fallback }) {
  const coordinates = ['x', 'y', 'z'].map((name, axis) =>
    cells.input({
      path: `${path}[${axis}]`,
      label: `${name} of the ${label}`,
      optional: true,
      fallback: () => fallback()[axis],
      write: (doc, value) => edits.setCoordinate(doc, path, axis, value, fallback()),
    }),
  );
  return html`<div class="point" role="group" aria-label=${label} data-path=${path}>${coordinates}</div>`;
}

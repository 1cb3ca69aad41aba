/**
 * A setting with its name, what it means, and its control; and a point of three lengths as one control.
 */
import * as edits from '../../core/edits.js';
import { element } from '../../ui/dom.js';

/** @param {{label: string, title?: string, note?: string | HTMLElement, control: HTMLElement}} setting */
export function setting({ label, title, note = '', control }) {
  const small = typeof note === 'string' && note ? element('small', {}, note) : note;
  // A group of cells has a name of its own; a label names one cell only.
  const kind = control.matches('input, select') ? 'label' : 'div';
  return element(kind, { class: 'field' }, element('span', { title }, label), control, small);
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
  return element('div', { class: 'point', role: 'group', 'aria-label': label, 'data-path': path }, ...coordinates);
}

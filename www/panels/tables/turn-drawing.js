/**
 * How the three angles turn a frame, drawn beside the cells where they are typed: the order, the axes and the ways round.
 *
 * The points of the drawing come from the convention itself, R = Y(longitude) · X(−latitude) · Z(roll), at angles that show
 * it well.
 */
import look from '../../style/turn-drawing.css?inline';
import { turnOf } from '../../core/orientation.js';
import { element } from '../../ui/dom.js';
import { onKeys } from '../../ui/keys.js';
import { wear } from '../../ui/style-sheets.js';
import { TURN_CELLS } from './cell-tools.js';
import { floating } from './floating.js';

/** The drawn frame, in degrees. */
const DRAWN = { longitude: 60, latitude: 42, roll: 60 };

/** The text alternative: all that the drawing says. */
const IN_WORDS =
  'The frame’s z axis points like a place on a globe whose poles are on the fixed y axis: longitude turns it about y, from z towards x; latitude lifts it from there towards y. Roll turns the frame about its own z axis. As a product: Y(longitude) · X(−latitude) · Z(roll).';

/** @typedef {readonly [number, number, number]} Point */

/** Where the eye is: from the fixed z axis towards x, and above. */
const EYE = { longitude: 10, latitude: 25 };

/** Pixels to one. */
const SCALE = 88;

/** Onto the paper. @param {Point} point */
function onPaper([x, y, z]) {
  const [right, up] = [axisOf(EYE, 0), axisOf(EYE, 1)];
  return [right, up].map((axis, i) => (i ? -SCALE : SCALE) * (x * axis[0] + y * axis[1] + z * axis[2]));
}

/** @param {Point[]} points */
const line = (points) => points.map((point, i) => `${i ? 'L' : 'M'}${onPaper(point).map((value) => value.toFixed(1)).join(' ')}`).join('');

/** The frame's axis 0, 1 or 2 at angles. @param {import('../../core/types.js').Frame} frame @param {number} axis @returns {Point} */
function axisOf(frame, axis) {
  const turn = turnOf(frame);
  return [turn[axis], turn[axis + 3], turn[axis + 6]];
}

/** Points of a path, from 0 to 1. @param {(share: number) => Point} at @returns {Point[]} */
const along = (at) => Array.from({ length: 25 }, (_, i) => at(i / 24));

/** @param {Point} a @param {number} size @returns {Point} */
const times = ([x, y, z], size) => [x * size, y * size, z * size];

/** @param {Point} point @param {string} text @param {string} [kind] */
const label = (point, text, kind = '') => {
  const [x, y] = onPaper(point);
  return `<text x="${x.toFixed(1)}" y="${(y + 4).toFixed(1)}" class="${kind}">${text}</text>`;
};

/** The drawing, in the page's colours. */
export function drawing() {
  const { longitude, latitude, roll } = DRAWN;
  /** @type {Point} */
  const origin = [0, 0, 0];
  const equator = along((s) => axisOf({ longitude: 105 * s - 5 }, 2));
  const meridian = along((s) => axisOf({ longitude, latitude: 90 * s }, 2));
  const first = along((s) => times(axisOf({ longitude: longitude * s }, 2), 0.55));
  const second = along((s) => times(axisOf({ longitude, latitude: latitude * s }, 2), 0.75));
  const tip = axisOf(DRAWN, 2);
  // About the tip, from where x was to where it is.
  const third = along((s) => {
    const x = axisOf({ longitude, latitude, roll: roll * 4.5 * s }, 0);
    const point = times(x, 0.2);
    return [point[0] + tip[0], point[1] + tip[1], point[2] + tip[2]];
  });
  const arrow = (/** @type {Point[]} */ points, /** @type {string} */ kind) => `<path d="${line(points)}" class="${kind}" marker-end="url(#turn-arrow)"/>`;
  return `<svg viewBox="-48 -124 190 182" role="img" aria-label="${IN_WORDS}">
    <defs><marker id="turn-arrow" viewBox="0 0 8 8" refX="6" refY="4" markerWidth="7" markerHeight="7" markerUnits="userSpaceOnUse" orient="auto"><path d="M0 0L8 4L0 8Z" fill="currentColor" stroke="none"/></marker></defs>
    <g class="globe"><path d="${line(equator)}"/><path d="${line(meridian)}"/><path d="${line([origin, axisOf({ longitude }, 2)])}"/></g>
    ${[[1.2, 0, 0], [0, 1.2, 0], [0, 0, 1.2]].map((end, i) => arrow([origin, /** @type {any} */ (end)], 'fixed') + label(/** @type {any} */ (end.map((value) => value * 1.12)), 'xyz'[i])).join('')}
    ${arrow([origin, times(tip, 1.25)], 'own')}${label(times(tip, 1.34), 'frame’s z', 'start')}
    <g data-angle="longitude">${arrow(first, 'turn')}${label(times(axisOf({ longitude: longitude / 2 }, 2), 0.7), 'lon')}</g>
    <g data-angle="latitude">${arrow(second, 'turn')}${label(times(axisOf({ longitude: longitude + 13, latitude: latitude / 2 }, 2), 0.88), 'lat')}</g>
    <g data-angle="roll">${arrow(third, 'turn')}${label([tip[0] - 0.12, tip[1] + 0.3, tip[2]], 'roll')}</g>
  </svg>`;
}

/**
 * @param {HTMLElement} root holds the tables
 * @returns {(cell: Element) => void} shows the drawing for a cell that has the focus
 */
export function createTurnDrawing(root) {
  const tree = /** @type {Document | ShadowRoot} */ (root.getRootNode());
  wear(tree, look);
  const caption = element('figcaption', { id: 'turn-drawing-text' });
  caption.innerHTML = 'R = Y(<b data-angle="longitude">lon</b>) · X(−<b data-angle="latitude">lat</b>) · Z(<b data-angle="roll">roll</b>): lon about y, from there lat towards y, then roll about the frame’s z. Other forms: menu ⋯.';
  const figure = element('figure', { class: 'turn-drawing', popover: 'manual' });
  figure.innerHTML = drawing();
  figure.append(caption);
  root.append(figure);
  /** @type {HTMLInputElement | null} */
  let field = null;

  /** Beside the panel, over the 3D view; where there is no room beside it, above or below the cell. */
  function place() {
    if (!field) return;
    const [cell, panel] = [field, root].map((part) => part.getBoundingClientRect());
    // Scrolled out of its panel, the cell needs no drawing.
    if (tree.elementFromPoint(cell.left + cell.width / 2, cell.top + cell.height / 3) !== field) return figure.hidePopover();
    figure.showPopover();
    const { offsetWidth: width, offsetHeight: height } = figure;
    const beside = panel.right + width + 8 <= innerWidth;
    const above = cell.top - height - 12;
    const top = beside ? cell.top - height / 2 : above >= 0 ? above : cell.bottom + 34;
    figure.style.left = `${beside ? panel.right + 8 : Math.max(4, Math.min(cell.left, innerWidth - width - 4))}px`;
    figure.style.top = `${Math.max(4, Math.min(top, innerHeight - height - 4))}px`;
  }

  const float = floating(figure, place);

  function hide() {
    float.end();
    if (field?.getAttribute('aria-describedby') === caption.id) field.removeAttribute('aria-describedby');
    field = null;
    figure.hidePopover();
  }

  /** @param {EventTarget | null} target */
  function show(target) {
    hide();
    if (!(target instanceof HTMLInputElement) || !target.matches(TURN_CELLS)) return;
    field = target;
    const name = (field.dataset.path ?? '').replace(/^.*\./, '');
    for (const part of figure.querySelectorAll('[data-angle]')) part.classList.toggle('now', part.getAttribute('data-angle') === name);
    // A fault is told first, and the value of an expression.
    if (!field.hasAttribute('aria-describedby') && !field.matches('.expression')) field.setAttribute('aria-describedby', caption.id);
    float.begin();
    place();
  }
  root.addEventListener('focusin', ({ target }) => show(target));
  root.addEventListener('focusout', hide);
  onKeys(root, {
    oldValue() {
      hide();
      return false;
    },
  });
  return (cell) => {
    if (cell.matches(':focus')) show(cell);
  };
}

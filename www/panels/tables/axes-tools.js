/**
 * What helps to give a joint's point and direction: buttons for the coordinate axes, picking in the view, and the axes drawn
 * there while one is in their table.
 */
import { setValue } from '../../core/edits.js';
import { valueAt } from '../../core/path.js';
import { html, nothing } from '../../ui/render.js';

const AXES = /** @type {const} */ ({ x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] });
const JOINT = /^chains\[(\d+)\]\.joints\[(\d+)\]/;

/** @param {import('./typed-parts.js').View} view @param {() => void} draw the tables */
export function createAxesTools(view, draw) {
  const { store, say, scene } = view;
  /** The joint whose row was entered last, and its second direction where that was. */
  let active = '';
  let field = 'axis';
  /** @type {AbortController | null} */
  let picking = null;
  /** @type {Promise<ReturnType<typeof import('../../view3d/axes-view.js').createAxesView>> | null} */
  let drawn = null;

  const axesView = () => {
    if (!scene) return null;
    drawn ??= import('../../view3d/axes-view.js').then(({ createAxesView }) => createAxesView(/** @type {any} */ (view)));
    drawn.catch((error) => {
      drawn = null;
      say(`The axes cannot be drawn: a part of the page could not be loaded (${error instanceof Error ? error.message : error}).`);
    });
    return drawn;
  };
  const show = (/** @type {boolean} */ on) => axesView()?.then((axes) => axes.show(on, active)).catch(() => {});

  /** @param {(doc: import('../../core/types.js').MechanismDocument) => import('../../core/types.js').MechanismDocument} change */
  function edit(change) {
    const focused = active;
    store.edit(change);
    active = focused;
    show(true);
  }

  /** @param {'point' | 'direction'} what @param {number} chain */
  async function pick(what, chain) {
    picking?.abort();
    const mine = (picking = new AbortController());
    draw();
    try {
      const axes = await axesView();
      const place = active;
      const [, , joint] = JOINT.exec(place) ?? [];
      const prompt = what === 'point' ? `Click where joint ${Number(joint) + 1} is: an axis, a key frame, or the ground (z = 0).` : 'Click a second point: the direction goes there from the joint’s point.';
      say(`${prompt} Escape ends.`);
      const point = await axes?.pick(mine.signal);
      if (point && what === 'point') edit((doc) => setValue(doc, `${place}.point`, point));
      if (point && what === 'direction') {
        const from = /** @type {number[]} */ (axes?.pointOf(place) ?? [0, 0, 0]);
        const direction = point.map((value, i) => Number((value - from[i]).toPrecision(12)));
        if (direction.every((value) => value === 0)) say('The direction was not written: the second point is the first one.');
        else edit((doc) => setValue(doc, `${place}.${field}`, direction));
      }
    } finally {
      if (picking === mine) picking = null;
      draw();
      void chain;
    }
  }

  return {
    /** @param {FocusEvent} event */
    entered({ target }) {
      const path = /** @type {HTMLElement} */ (target).dataset?.path ?? /** @type {HTMLElement} */ (target).dataset?.menu ?? '';
      const place = JOINT.exec(path)?.[0];
      if (place) {
        field = path.includes('.second') ? 'second' : 'axis';
        if (place !== active) {
          active = place;
          draw();
        }
      }
      show(true);
    },
    left() {
      if (!picking) show(false);
    },
    /** The buttons, for the joint that was entered last. @param {number} chain */
    bar(chain) {
      const [, own, joint] = JOINT.exec(active) ?? [];
      if (own !== String(chain) || !valueAt(store.doc, active)) return nothing;
      const name = `joint ${Number(joint) + 1}`;
      // The pointer does not take the focus from the row.
      const stay = (/** @type {Event} */ event) => event.preventDefault();
      const button = (/** @type {string} */ text, /** @type {string} */ label, /** @type {() => void} */ act) =>
        html`<button class="quiet" aria-label=${`${label}, ${name}`} title=${label} @pointerdown=${stay} @click=${act}>${text}</button>`;
      return html`<div class="axes-tools" role="group" aria-label=${`Point and direction of ${name}`}>
        <span>${name}:</span>
        ${scene ? button(picking ? 'stop picking' : 'pick point', picking ? 'Stop picking in the view' : 'Pick point in the view', () => (picking ? picking.abort() : pick('point', chain))) : nothing}
        <span>${field === 'second' ? 'second' : 'direction'} along</span>
        ${Object.entries(AXES).map(([axis, direction]) => button(axis, `Direction along ${axis}`, () => edit((doc) => setValue(doc, `${active}.${field}`, [...direction]))))}
        ${scene ? button('line to…', 'Direction along the line to a second point, picked in the view', () => pick('direction', chain)) : nothing}
      </div>`;
    },
  };
}

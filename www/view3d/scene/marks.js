/**
 * The marks of what is chosen and of what is pointed at: outlines, and names among those that always stand in the scene.
 *
 * @typedef {{place: string, text: string}} Mark `text` is its name; empty for none
 */
import { Sphere, Vector3 } from 'three';
import { createHighlight } from './highlight.js';
import { createLabels } from './labels.js';

/** @param {HTMLCanvasElement} canvas @param {import('three').Object3D[]} things @param {HTMLElement} layer for the names @param {import('./packed.js').DrawAsOne} drawAsOne */
export function createMarks(canvas, things, layer, drawAsOne) {
  const highlight = createHighlight(things, drawAsOne);
  const labels = createLabels(layer);
  const marks = [
    { place: '', text: '', at: new Vector3(), reach: 0 },
    { place: '', text: '', at: new Vector3(), reach: 0 },
  ];
  const [chosen, pointed] = marks;
  const outline = () => highlight.set(chosen.place, pointed.place);

  return {
    labels,
    boxOf: highlight.boxOf,
    paint: highlight.paint,
    resize: highlight.resize,
    /** Outlines what there is now. */
    outline,
    /** @param {Mark} select @param {Mark} point @returns {boolean} whether anything is different */
    set(select, point) {
      if (chosen.place === select.place && chosen.text === select.text && pointed.place === point.place && pointed.text === point.text) return false;
      Object.assign(chosen, select);
      Object.assign(pointed, point);
      for (const mark of marks) if (mark.text) mark.reach = highlight.boxOf(mark.place).getBoundingSphere(new Sphere()).radius;
      outline();
      canvas.dataset.selected = select.place;
      canvas.dataset.hovered = point.place;
      return true;
    },
    /** Writes the names. @param {import('./labels.js').Label[]} standing those of the scene, in whose place a mark's own comes */
    name(standing) {
      const named = marks.filter(({ place, text, at }, index) => text && !(index && place === chosen.place) && highlight.anchorOf(place, at));
      labels.set([...standing.filter(({ place }) => !named.some((mark) => mark.place === place)), ...named], chosen.place, pointed.place);
    },
    /** Puts the names to where their things are now. */
    follow() {
      for (const { place, text, at } of marks) if (text) highlight.anchorOf(place, at);
    },
  };
}

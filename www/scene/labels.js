/**
 * Names in the scene, as text over the canvas; each says by `data-place` which thing it names.
 */
import { Vector3 } from 'three';
import { element, setText } from '../dom.js';

/** @typedef {{at: Vector3, text: string, place: string}} Label */

/** @param {HTMLElement} layer covers the canvas */
export function createLabels(layer) {
  /** @type {{at: Vector3, tag: HTMLElement}[]} */
  let labels = [];
  const seen = new Vector3();
  return {
    /** @param {Label[]} items @param {string} chosen @param {string} pointed places */
    set(items, chosen, pointed) {
      while (labels.length > items.length) labels.pop()?.tag.remove();
      items.forEach(({ at, text, place }, index) => {
        labels[index] ??= { at, tag: layer.appendChild(element('span', {})) };
        const { tag } = labels[index];
        labels[index].at = at;
        if (tag.dataset.place !== place) tag.dataset.place = place;
        tag.className = place === chosen ? 'chosen' : place === pointed ? 'pointed' : '';
        setText(tag, text);
      });
    },
    /** @param {import('three').Camera} camera @param {number} width @param {number} height */
    place(camera, width, height) {
      for (const { at, tag } of labels) {
        seen.copy(at).project(camera);
        tag.hidden = seen.z > 1 || Math.abs(seen.x) > 1 || Math.abs(seen.y) > 1;
        const x = ((seen.x + 1) / 2) * width;
        const y = ((1 - seen.y) / 2) * height;
        tag.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
      }
    },
  };
}

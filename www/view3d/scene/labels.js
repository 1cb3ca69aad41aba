/**
 * Names in the scene, as text over the canvas; each says by `data-place` which thing it names.
 */
import { Vector3 } from 'three';
import { element, setText } from '../../ui/dom.js';

/** @typedef {{at: Vector3, text: string, place: string}} Label */

/** Height of a name in pixels. */
const LINE = 18;

/** @param {HTMLElement} layer covers the canvas */
export function createLabels(layer) {
  /** @type {{at: Vector3, tag: HTMLElement, width: number}[]} */
  let labels = [];
  const seen = new Vector3();
  return {
    /** @param {Label[]} items @param {string} chosen @param {string} pointed places */
    set(items, chosen, pointed) {
      while (labels.length > items.length) labels.pop()?.tag.remove();
      items.forEach(({ at, text, place }, index) => {
        labels[index] ??= { at, tag: layer.appendChild(element('span', {})), width: 0 };
        const { tag } = labels[index];
        labels[index].at = at;
        if (tag.dataset.place !== place) tag.dataset.place = place;
        tag.className = place === chosen ? 'chosen' : place === pointed ? 'pointed' : '';
        if (tag.textContent !== text) labels[index].width = 0;
        setText(tag, text);
      });
    },
    /** @param {import('three').Camera} camera @param {number} width @param {number} height */
    place(camera, width, height) {
      /** @type {{x: number, y: number, width: number}[]} */
      const taken = [];
      for (const label of labels) {
        const { at, tag } = label;
        seen.copy(at).project(camera);
        tag.hidden = seen.z > 1 || Math.abs(seen.x) > 1 || Math.abs(seen.y) > 1;
        if (tag.hidden) continue;
        label.width ||= tag.offsetWidth;
        const { width: own } = label;
        const x = ((seen.x + 1) / 2) * width;
        const y = ((1 - seen.y) / 2) * height;
        // A name that would cover another one stands below it.
        let down = 0;
        while (taken.some((other) => Math.abs(other.y - y - down) < LINE && x < other.x + other.width && other.x < x + own)) down += LINE / 2;
        taken.push({ x, y: y + down, width: own });
        tag.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
        tag.style.marginTop = `${down}px`;
      }
    },
  };
}

/**
 * Names in the scene, as text over the canvas.
 */
import { Vector3 } from 'three';
import { element, setText } from '../dom.js';

/** @param {HTMLElement} layer covers the canvas */
export function createLabels(layer) {
  /** @type {{at: Vector3, tag: HTMLElement}[]} */
  let labels = [];
  return {
    /** @param {{at: Vector3, text: string}[]} items */
    set(items) {
      while (labels.length > items.length) labels.pop()?.tag.remove();
      items.forEach(({ at, text }, index) => {
        labels[index] ??= { at, tag: layer.appendChild(element('span', {})) };
        labels[index].at = at;
        setText(labels[index].tag, text);
      });
    },
    /** @param {import('three').Camera} camera @param {number} width @param {number} height */
    place(camera, width, height) {
      for (const { at, tag } of labels) {
        const seen = at.clone().project(camera);
        tag.hidden = seen.z > 1 || Math.abs(seen.x) > 1 || Math.abs(seen.y) > 1;
        const x = ((seen.x + 1) / 2) * width;
        const y = ((1 - seen.y) / 2) * height;
        tag.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
      }
    },
  };
}

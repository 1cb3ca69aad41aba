/**
 * Names in the scene, as text over the canvas; each says by `data-place` which thing it names.
 *
 * @typedef {{at: Vector3, text: string, place: string}} Label
 */
import { Vector3 } from 'three';
import { element, setText } from '../../ui/dom.js';
import { layOut, offsetOn } from './label-layout.js';

/** Classes by their rank in the choice of a side. */
const RANKED = ['', 'pointed', 'chosen'];

/** @param {HTMLElement} layer covers the canvas, and is a container of its size */
export function createLabels(layer) {
  /** @type {(import('./label-layout.js').Name & {at: Vector3, tag: HTMLElement, side: number})[]} */
  let labels = [];
  const seen = new Vector3();

  /** @param {(typeof labels)[number]} label */
  function measure(label) {
    const { tag } = label;
    tag.style.left = tag.style.top = '';
    label.width = tag.offsetWidth;
    label.height = tag.offsetHeight;
    label.left = tag.offsetLeft;
    label.top = tag.offsetTop;
  }

  return {
    /** @param {Label[]} items @param {string} chosen @param {string} pointed places */
    set(items, chosen, pointed) {
      while (labels.length > items.length) labels.pop()?.tag.remove();
      items.forEach(({ at, text, place }, index) => {
        labels[index] ??= { at, tag: layer.appendChild(element('span', {})), x: 0, y: 0, width: 0, height: 0, left: 0, top: 0, rank: 0, kept: false, side: 0 };
        const label = labels[index];
        const { tag } = label;
        label.at = at;
        if (tag.dataset.place !== place) tag.dataset.place = place;
        label.rank = place === chosen ? 2 : place === pointed ? 1 : 0;
        label.kept = label.rank > 0;
        // Another text or other letters have another width.
        if (tag.textContent !== text || tag.className !== RANKED[label.rank]) label.width = 0;
        tag.className = RANKED[label.rank];
        setText(tag, text);
      });
    },
    /**
     * @param {import('three').Camera} camera @param {number} width @param {number} height
     * @param {import('./label-layout.js').Box[]} [others] what the names must not cover
     */
    place(camera, width, height, others = []) {
      const within = labels.filter((label) => {
        seen.copy(label.at).project(camera);
        const out = seen.z > 1 || Math.abs(seen.x) > 1 || Math.abs(seen.y) > 1;
        if (out) label.tag.hidden = true;
        label.x = ((seen.x + 1) / 2) * width;
        label.y = ((1 - seen.y) / 2) * height;
        return !out;
      });
      const fresh = within.filter((label) => !label.width);
      for (const { tag } of fresh) tag.hidden = false;
      fresh.forEach(measure);
      layOut(within, others, { width, height }).forEach((side, index) => {
        const label = within[index];
        const { tag, x, y } = label;
        tag.hidden = side < 0;
        if (side < 0) return;
        label.side = side;
        const [right, down] = offsetOn(label, side);
        tag.style.left = `${right}px`;
        tag.style.top = `${down}px`;
        // In shares of the layer, so that they stay in their places where the picture is scaled, as on paper.
        tag.style.transform = `translate(${((100 * x) / width).toFixed(3)}cqw, ${((100 * y) / height).toFixed(3)}cqh)`;
      });
    },
    /** Where they stand now. @returns {import('./label-layout.js').Box[]} */
    boxes() {
      return labels.filter(({ tag }) => !tag.hidden).map((label) => {
        const [right, down] = offsetOn(label, label.side);
        return { x: label.x + right, y: label.y + down, width: label.width, height: label.height };
      });
    },
  };
}

/**
 * Names in the scene, as flags over the canvas, with leaders to what they name; each says by `data-place` which thing that is.
 *
 * @typedef {{at: Vector3, text: string, place: string, reach?: number}} Label `reach` is half the thing's size, if it is known
 */
import { Vector3 } from 'three';
import { element } from '../../ui/dom.js';
import { boxOn, layOut, leaderOf, offsetOn, wayOf } from './label-layout.js';

/** Classes by their rank in the choice of a side. */
const RANKED = ['', 'pointed', 'chosen'];

/** Half the size of a base and of a key frame, in link radii. */
const THING = 5;

/** At most so much of a thing is kept clear, in shares of the view's lesser side: nearer, it fills the view. */
const MOST = 1 / 5;

const seen = new Vector3();

/**
 * Where a point is in a view, in pixels, and how large the thing at it is; `out` of the view.
 * @param {Vector3} at @param {import('three').Camera} camera @param {number} width @param {number} height @param {number} link radius of a link
 * @param {number} [reach] half its size
 */
export function placeOf(at, { matrixWorldInverse, projectionMatrix }, width, height, link, reach = THING * link) {
  const { elements } = projectionMatrix;
  const depth = elements[15] + elements[11] * seen.copy(at).applyMatrix4(matrixWorldInverse).z;
  seen.applyMatrix4(projectionMatrix);
  const clear = Math.min((reach * elements[5] * height) / 2 / depth, MOST * Math.min(width, height));
  const out = seen.z > 1 || Math.abs(seen.x) > 1 || Math.abs(seen.y) > 1;
  return { x: ((seen.x + 1) / 2) * width, y: ((1 - seen.y) / 2) * height, clear, out };
}

/** @param {HTMLElement} layer covers the canvas, and is a container of its size @param {boolean} [bare] without leaders, in their places */
export function createLabels(layer, bare = false) {
  /** @type {(import('./label-layout.js').Name & {at: Vector3, reach?: number, tag: HTMLElement, text: string, place: string, leader: string, moved: string})[]} */
  let labels = [];

  /** Writes only what is different. @param {(typeof labels)[number]} label @param {number} width @param {number} height */
  function write(label, width, height) {
    const { tag, x, y, spot } = label;
    const [right, down] = offsetOn(label, spot);
    const leader = `${right.toFixed(1)}px ${down.toFixed(1)}px`;
    if (label.leader !== leader) {
      label.leader = tag.style.translate = leader;
      const [across, below] = wayOf(spot);
      // For style/view.css, which draws the leader from the flag back to the point.
      tag.style.setProperty('--across', `${across}`);
      tag.style.setProperty('--below', `${below}`);
      tag.style.setProperty('--back', `${Math.atan2(-below, -across)}rad`);
      tag.style.setProperty('--leader', `${leaderOf(label, spot)}px`);
    }
    // In shares of the layer, so that they stay in their places where the picture is scaled, as on paper.
    const moved = `translate(${((100 * x) / width).toFixed(3)}cqw, ${((100 * y) / height).toFixed(3)}cqh)`;
    if (label.moved !== moved) label.moved = tag.style.transform = moved;
  }

  return {
    /** @param {Label[]} items @param {string} chosen @param {string} pointed places */
    set(items, chosen, pointed) {
      while (labels.length > items.length) labels.pop()?.tag.remove();
      items.forEach(({ at, text, place, reach }, index) => {
        labels[index] ??= { at, tag: layer.appendChild(element('span', {})), x: 0, y: 0, width: 0, height: 0, clear: 0, rank: 0, kept: false, spot: -1, text: '', place: '', leader: '', moved: '' };
        const label = labels[index];
        const { tag } = label;
        label.at = at;
        label.reach = reach;
        if (label.place !== place) {
          label.place = tag.dataset.place = place;
          label.spot = -1;
        }
        const rank = place === chosen ? 2 : place === pointed ? 1 : 0;
        if (label.text === text && label.rank === rank) return;
        // Another text or other letters have another width.
        label.width = 0;
        label.rank = rank;
        label.kept = rank > 0;
        tag.className = RANKED[rank];
        label.text = tag.textContent = text;
      });
    },
    /**
     * @param {import('three').Camera} camera @param {number} width @param {number} height
     * @param {{link: number, centre: Vector3}} size radius of a link, middle of the scene
     * @param {import('./label-layout.js').Box[]} [others] what the names must not cover
     */
    place(camera, width, height, { link, centre }, others = []) {
      const within = labels.filter((label) => {
        const found = placeOf(label.at, camera, width, height, link, label.reach);
        Object.assign(label, found, bare && { clear: -1 });
        if (found.out && !label.tag.hidden) label.tag.hidden = true;
        return !found.out;
      });
      const fresh = within.filter((label) => !label.width);
      for (const { tag } of fresh) tag.hidden = false;
      for (const label of fresh) Object.assign(label, { width: label.tag.offsetWidth, height: label.tag.offsetHeight });
      layOut(within, others, { x: 0, y: 0, width, height }, placeOf(centre, camera, width, height, link)).forEach((spot, index) => {
        const label = within[index];
        label.spot = spot;
        if (label.tag.hidden !== spot < 0) label.tag.hidden = spot < 0;
        if (spot >= 0) write(label, width, height);
      });
    },
    /** Where they stand now. @returns {import('./label-layout.js').Box[]} */
    boxes: () => labels.filter(({ tag }) => !tag.hidden).map((label) => boxOn(label, label.spot)),
  };
}

/**
 * The view as a picture for programs.
 */
import { describeScene } from '../core/status-words.js';
import { drawPicture } from './picture.js';
import { drawing } from './svg.js';
import { Refusal } from '../core/refusal.js';

/** What stands in for a view that has no size, in CSS pixels. */
const SIZE = { width: 640, height: 480 };

/**
 * @param {import('../element/workbench.js').App} app
 * @param {{type?: 'png' | 'svg', width?: number, height?: number, scale?: number}} wish
 * @returns {Promise<Blob>}
 */
export async function imageOf({ scene, store }, { type = 'png', width, height, scale = 2 }) {
  if (!scene) throw new Refusal('This browser shows no 3D graphics (WebGL 2), so there is no picture.');
  if (type === 'svg') return new Blob([drawing(scene, store.doc.name || 'Linkage', describeScene(store))], { type: 'image/svg+xml' });
  if (type !== 'png') throw new Refusal(`There are no pictures of type “${type}”. Accepted: png, svg.`);
  const { clientWidth, clientHeight } = scene.canvas;
  const size = { width: width ?? (clientWidth || SIZE.width), height: height ?? (clientHeight || SIZE.height), ratio: scale };
  const canvas = drawPicture(scene, { ...size, shadows: true });
  const content = await new Promise((resolve) => canvas.toBlob(resolve, 'image/png'));
  if (!content) throw new Refusal('The browser has no room for a picture of this size.');
  return content;
}

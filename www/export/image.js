/**
 * The view as a picture for programs, also of an element that is in no page.
 *
 * @typedef {{type?: 'png' | 'svg', width?: number, height?: number, scale?: number}} Wish
 */
import look from '../style/linkage.css?inline';
import { describeScene } from '../core/status-words.js';
import { shown } from '../core/shown.js';
import { element as make } from '../ui/dom.js';
import { wear } from '../ui/style-sheets.js';
import { createScene } from '../view3d/scene/scene.js';
import { drawPicture } from './picture.js';
import { drawing } from './svg.js';
import { Refusal } from '../core/refusal.js';

/** What stands in for a view that has no size, in CSS pixels. */
const SIZE = { width: 640, height: 480 };

/**
 * @param {Pick<import('../element/workbench.js').App, 'scene' | 'store'>} app
 * @param {Wish} wish
 * @returns {Promise<Blob>}
 */
export async function imageOf({ scene, store }, { type = 'png', width, height, scale = 2 }) {
  for (const [name, value] of Object.entries({ width, height, scale })) {
    if (value !== undefined && !(Number(value) > 0 && Number(value) < Infinity)) throw new Refusal(`The ${name} of a picture is “${value}”. Accepted: a number above zero.`);
  }
  if (!scene) throw new Refusal('This browser shows no 3D graphics (WebGL 2), so there is no picture.');
  const { clientWidth, clientHeight } = scene.canvas;
  const size = { width: width ?? (clientWidth || SIZE.width), height: height ?? (clientHeight || SIZE.height) };
  // Out of sight nothing has been put where it is.
  const what = shown(store);
  if (what) scene.pose(what);
  if (type === 'svg') return new Blob([drawing(scene, store.doc.name || 'Linkage', describeScene(store), size)], { type: 'image/svg+xml' });
  if (type !== 'png') throw new Refusal(`There are no pictures of type “${type}”. Accepted: png, svg.`);
  const canvas = drawPicture(scene, { ...size, ratio: scale, shadows: true });
  const content = await new Promise((resolve) => canvas.toBlob(resolve, 'image/png'));
  if (!content) throw new Refusal('The browser has no room for a picture of this size.');
  return content;
}

/**
 * Of an element that is in no page, where nothing has a size or a colour: a view of its own is put there for it, out of sight.
 * @param {import('../element/element.js').SyntheticaLinkage} element
 * @param {Wish} wish
 */
export async function imageApart({ theme, parts: { store } }, wish) {
  const host = make('div', { inert: true, 'aria-hidden': 'true', theme: theme || undefined });
  const labels = make('div', { id: 'labels' });
  const canvas = make('canvas');
  const view = make('div', { class: 'scene' }, canvas, labels);
  const { width = SIZE.width, height = SIZE.height } = wish;
  Object.assign(host.style, { position: 'fixed', left: '-100000px', width: `${width}px`, height: `${height}px` });
  for (const box of [canvas, view]) Object.assign(box.style, { display: 'block', width: '100%', height: '100%' });
  const root = host.attachShadow({ mode: 'open' });
  wear(root, look);
  root.append(view);
  document.body.append(host);
  const over = new AbortController();
  try {
    const scene = createScene({ canvas, labels, signal: over.signal }, () => {});
    if (scene) {
      scene.choose(store.view);
      scene.setParallel(store.view.projection === 'orthographic');
      scene.show({ ...store.result, doc: store.result.plain }, true);
      if (store.view.side) scene.turnTo(store.view.side, false);
    }
    return await imageOf({ scene, store }, wish);
  } finally {
    over.abort('drawn');
    host.remove();
  }
}

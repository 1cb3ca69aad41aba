/**
 * The dialog for a picture of the linkage: what is in it, its size and its background, with a preview; then the file.
 *
 * @typedef {'png' | 'svg'} Kind
 */
import '../style/export.css';
import { describeScene } from '../core/status-words.js';
import { openDialog } from '../ui/dialog.js';
import { element } from '../ui/dom.js';
import { legendLines } from './legend.js';
import { dressed, drawPicture } from './picture.js';
import { saveFile } from './save.js';
import { shownName } from './shown-name.js';

/** Room for the preview, in CSS pixels. */
const PREVIEW = { width: 440, height: 280 };

/** @type {Record<Kind, {title: string, save: string}>} */
const WORDS = { png: { title: 'Picture', save: 'Save picture' }, svg: { title: 'Drawing', save: 'Save drawing' } };

/** Sizes in CSS pixels, as the names are sized, and pixels of the picture to one of those. @param {Kind} kind @param {{width: number, height: number}} view @returns {[string, {width: number, height: number, ratio: number}][]} */
const sizesOf = (kind, { width, height }) =>
  kind === 'svg'
    ? [
        [`As the view: ${width} × ${height}`, { width, height, ratio: 1 }],
        ['Slide: 960 × 540', { width: 960, height: 540, ratio: 1 }],
        ['Square: 640 × 640', { width: 640, height: 640, ratio: 1 }],
      ]
    : [
        [`As the view, twice as fine: ${2 * width} × ${2 * height}`, { width, height, ratio: 2 }],
        [`As the view, four times as fine: ${4 * width} × ${4 * height}`, { width, height, ratio: 4 }],
        ['Slide: 1920 × 1080', { width: 960, height: 540, ratio: 2 }],
        ['Large: 3840 × 2160', { width: 960, height: 540, ratio: 4 }],
        ['Square: 2000 × 2000', { width: 640, height: 640, ratio: 3.125 }],
      ];

/** @param {import('../element/workbench.js').App} app @param {Kind} kind */
export async function openPicture({ store, scene, say }, kind) {
  if (!scene) return;
  const sizes = sizesOf(kind, { width: scene.canvas.clientWidth, height: scene.canvas.clientHeight });
  const choice = (/** @type {string} */ label, /** @type {[string, string][]} */ options) => {
    const select = element('select', { id: `picture-${label.split(' ')[0].toLowerCase()}`, change: show }, ...options.map(([value, text]) => element('option', { value }, text)));
    return { select, field: element('p', { class: 'field' }, element('label', { for: select.id }, label), select) };
  };
  const box = (/** @type {string} */ label, checked = true) => {
    const input = element('input', { type: 'checkbox', checked, change: show });
    return { input, field: element('p', {}, element('label', {}, input, ` ${label}`)) };
  };
  const size = choice('Size in pixels', sizes.map(([text], index) => [String(index), text]));
  const background = choice('Background', [['view', 'As in the view'], ['white', 'White'], ['clear', 'Clear']]);
  const whole = box('The whole linkage with its motions fills the picture');
  const names = box('Names of key frames and bases');
  const legend = box('Legend');
  const preview = element('canvas', { class: 'preview', role: 'img', 'aria-label': `Preview. ${describeScene(store)}` });

  /** @returns {import('./picture.js').Wish} */
  const wish = () => {
    const ground = /** @type {import('./picture.js').Background} */ (background.select.value);
    return {
      ...sizes[Number(size.select.value)][1],
      background: ground,
      whole: whole.input.checked,
      names: names.input.checked,
      // Its lines have the colours that the picture has.
      legend: legend.input.checked ? dressed(scene, ground, () => legendLines({ store, scene })) : [],
      shadows: true,
    };
  };

  function show() {
    if (!scene) return;
    const asked = wish();
    const shrunk = Math.min(PREVIEW.width / asked.width, PREVIEW.height / asked.height);
    drawPicture(scene, { ...asked, ratio: shrunk * Math.min(2, devicePixelRatio) }, preview);
    Object.assign(preview.style, { width: `${asked.width * shrunk}px`, height: `${asked.height * shrunk}px` });
    preview.dataset.background = asked.background;
  }

  async function save() {
    if (!scene) return;
    const content = await (kind === 'svg' ? drawn() : painted());
    const name = shownName(store.result, kind);
    if (content) saveFile(name, content);
    dialog.close();
    say(content ? `Saved ${name}.` : 'The browser has no room for a picture of this size. Choose a smaller one.');
  }
  async function drawn() {
    const { drawing } = await import('./svg.js');
    return scene && new Blob([drawing(scene, store.result.doc?.name || 'Linkage', describeScene(store), wish())], { type: 'image/svg+xml' });
  }
  /** @returns {Promise<Blob | null>} null where there is no room for it */
  const painted = () => new Promise((resolve) => (scene ? drawPicture(scene, wish()).toBlob(resolve, 'image/png') : resolve(null)));

  const dialog = openDialog(
    WORDS[kind].title,
    element('div', { class: 'preview-room' }, preview),
    size.field, background.field, whole.field, names.field, legend.field,
    element('p', {}, element('button', { click: save }, WORDS[kind].save)),
  );
  dialog.classList.add('picture');
  show();
}

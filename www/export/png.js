/**
 * The view as a PNG: the dialog that asks for size and background, and the file.
 */
import '../style/export.css';
import { element } from '../ui/dom.js';
import { fileName, saveFile } from './save.js';
import { openDialog } from '../ui/dialog.js';
import { drawPicture } from './picture.js';

/** @param {import('../element/workbench.js').App} app */
export async function exportPng({ store, scene, say }) {
  if (!scene) return;
  const { clientWidth: width, clientHeight: height } = scene.canvas;
  /** @type {[string, {width: number, height: number, ratio: number}][]} */
  const sizes = [
    [`As the view, twice as fine: ${2 * width} × ${2 * height}`, { width, height, ratio: 2 }],
    [`As the view, four times as fine: ${4 * width} × ${4 * height}`, { width, height, ratio: 4 }],
    ['Slide: 1920 × 1080', { width: 960, height: 540, ratio: 2 }],
    ['Large: 3840 × 2160', { width: 960, height: 540, ratio: 4 }],
    ['Square: 2000 × 2000', { width: 640, height: 640, ratio: 3.125 }],
  ];
  const size = element('select', { id: 'png-size' }, ...sizes.map(([text], index) => element('option', { value: index }, text)));
  const transparent = element('input', { type: 'checkbox' });
  const names = element('input', { type: 'checkbox', checked: true });
  const save = element('button', {}, 'Save picture');
  const dialog = openDialog(
    'Picture of the view',
    element('p', { class: 'field' }, element('label', { for: size.id }, 'Size in pixels'), size),
    element('p', {}, element('label', {}, transparent, ' Transparent background')),
    element('p', {}, element('label', {}, names, ' Names of key frames and bases')),
    element('p', {}, save),
  );
  save.addEventListener('click', async () => {
    const picture = drawPicture(scene, { ...sizes[Number(size.value)][1], transparent: transparent.checked, names: names.checked, shadows: true });
    const content = await new Promise((resolve) => picture.toBlob(resolve, 'image/png'));
    const name = fileName(store.result.doc, 'png');
    if (content) saveFile(name, content);
    dialog.close();
    say(content ? `Saved ${name}.` : 'The browser has no room for a picture of this size. Choose a smaller one.');
  });
}

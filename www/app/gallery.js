/**
 * The examples, each with its picture. Arrow keys go through them, Enter opens one.
 */
import { sampleText, samples } from '../core/samples.js';
import { plural } from '../core/format.js';
import { element } from '../ui/dom.js';
import { withPart } from '../ui/lazy.js';
import { openDialog } from '../ui/dialog.js';
import '../style/gallery.css';

/** Made by scripts/thumbnails.mjs. @type {Record<string, string>} */
const pictures = import.meta.glob('../thumbnails/*.webp', { query: '?url&no-inline', import: 'default', eager: true });

/** @param {import('../element/workbench.js').App} app */
export function openGallery({ store, open, say }) {
  const cards = samples.map((sample) => {
    const { file, title, line, mobility } = sample;
    const choose = () =>
      withPart({ say }, 'The example', () => sampleText(sample), async (text) => {
        if (await open(text, file)) dialog.close();
      });
    const picture = element('img', { src: pictures[`../thumbnails/${file.replace('.json', '.webp')}`], alt: '', loading: 'lazy', width: 240, height: 160 });
    return element(
      'button',
      { class: 'card', 'data-sample': file, 'aria-current': store.origin.title === file && 'true', click: choose },
      picture,
      element('strong', {}, title),
      element('span', {}, line),
      element('small', {}, plural(mobility, 'freedom')),
    );
  });
  const grid = element('div', { class: 'cards', role: 'group', 'aria-label': 'Examples' }, ...cards);
  grid.addEventListener('keydown', (event) => {
    const at = cards.indexOf(/** @type {HTMLButtonElement} */ (document.activeElement));
    const columns = cards.filter((card) => card.offsetTop === cards[0].offsetTop).length;
    const next = { ArrowRight: at + 1, ArrowLeft: at - 1, ArrowDown: at + columns, ArrowUp: at - columns, Home: 0, End: cards.length - 1 }[event.key];
    if (at < 0 || next === undefined) return;
    event.preventDefault();
    cards[next]?.focus();
  });
  const dialog = openDialog('Examples', grid);
  dialog.classList.add('gallery');
  (cards.find((card) => card.ariaCurrent) ?? cards[0]).focus();
}

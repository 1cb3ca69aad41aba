/**
 * The examples in their groups, each with its picture. Arrow keys go through them, Enter opens one.
 */
import index from '../mechanisms/index.json';
import { sampleText } from '../core/sample-list.js';
import { inGroups } from '../core/mechanism-groups.js';
import { plural } from '../core/format.js';
import { element } from '../ui/dom.js';
import { withPart } from '../ui/lazy.js';
import { openDialog } from '../ui/dialog.js';
import '../style/gallery.css';

/** Made by scripts/thumbnails.mjs. @type {Record<string, string>} */
const pictures = import.meta.glob('../thumbnails/*.webp', { query: '?url&no-inline', import: 'default', eager: true });

/** @param {Pick<import('../element/workbench.js').App, 'store' | 'open' | 'say'>} app */
export function openGallery({ store, open, say }) {
  const groups = inGroups(index).map(({ heading, members }, index) => {
    const title = element('h3', { id: `examples-${index}` }, heading);
    return element('section', {}, title, element('div', { class: 'cards', role: 'group', 'aria-labelledby': title.id }, ...members.map(cardOf)));
  });
  const body = element('div', {}, ...groups);
  const cards = /** @type {HTMLButtonElement[]} */ ([...body.querySelectorAll('.card')]);

  /** @param {import('../core/sample-list.js').Sample} sample */
  function cardOf(sample) {
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
  }

  /** The nearest card in the row above or below, also of another group. @param {HTMLElement} from @param {1 | -1} way */
  function beyond(from, way) {
    const rows = cards.filter(({ offsetTop }) => way * (offsetTop - from.offsetTop) > 0);
    const next = rows.at(way === 1 ? 0 : -1)?.offsetTop;
    const far = (/** @type {HTMLElement} */ card) => Math.abs(card.offsetLeft - from.offsetLeft);
    return rows.filter(({ offsetTop }) => offsetTop === next).sort((a, b) => far(a) - far(b))[0];
  }
  body.addEventListener('keydown', (event) => {
    const at = cards.indexOf(/** @type {HTMLButtonElement} */ (document.activeElement));
    if (at < 0) return;
    const steps = { ArrowRight: () => cards[at + 1], ArrowLeft: () => cards[at - 1], ArrowDown: () => beyond(cards[at], 1), ArrowUp: () => beyond(cards[at], -1), Home: () => cards[0], End: () => cards.at(-1) };
    const step = steps[/** @type {keyof typeof steps} */ (event.key)];
    if (!step) return;
    event.preventDefault();
    step()?.focus();
  });
  const dialog = openDialog('Examples', body);
  dialog.classList.add('gallery');
  (cards.find((card) => card.ariaCurrent) ?? cards[0]).focus();
}

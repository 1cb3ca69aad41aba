/**
 * The drawing of what a maker's numbers are. It is part of the page, so that its lines have the page's colour.
 *
 * @typedef {import('../../core/types.js').Maker} Maker
 */
import { element } from '../../ui/dom.js';

const drawings = /** @type {Record<string, () => Promise<string>>} */ (import.meta.glob('./drawings/*.svg', { query: '?raw', import: 'default' }));

/** A figure that fills itself; empty where there is no drawing. What it shows is said by the fields beside it. @param {Maker} maker */
export function makerDrawing({ name, title, inputs }) {
  const figure = element('figure', { class: 'maker-drawing', hidden: true });
  const load = drawings[`./drawings/${name}.svg`];
  load?.().then(
    (text) => {
      const svg = new DOMParser().parseFromString(text, 'image/svg+xml').documentElement;
      const shown = inputs.filter(({ is }) => is !== 'list').map(({ name: input, parts, meaning }) => `${parts.length ? parts.join(', ') : input}: ${meaning}`);
      svg.setAttribute('role', 'img');
      svg.setAttribute('aria-label', `Drawing of the numbers of ${title}. ${shown.join('. ')}.`);
      figure.replaceChildren(document.importNode(svg, true));
      figure.hidden = false;
    },
    // The fields say the same in words.
    () => figure.remove(),
  );
  return figure;
}

/**
 * What a printed lesson has beside its text: a picture of the linkage as it stands, the link to the lesson, and the answers.
 *
 * @typedef {import('../../element/workbench.js').App} App
 */
import { describeScene } from '../../core/status-words.js';
import { element } from '../../ui/dom.js';
import { drawPicture } from '../../export/picture.js';

/** The picture's size in CSS pixels, and how much finer than a screen a printer draws. */
const SIZE = { width: 560, height: 320, ratio: 2 };

/**
 * @param {Pick<App, 'scene' | 'store'>} app
 * @param {HTMLElement} body the lesson's text; what is printed beside it comes before it and after it
 * @param {string} address of the lesson
 * @returns {() => void} ends it
 */
export function preparePrint({ scene, store }, body, address) {
  const figure = element('figure', { class: 'print-only' });
  body.before(figure);
  body.after(element('p', { class: 'print-only' }, 'This lesson with its linkage: ', element('a', { href: address }, address)));
  /** Answers that were opened for the print. @type {HTMLDetailsElement[]} */
  let opened = [];

  function prepare() {
    opened = [...body.querySelectorAll('details')].filter((details) => !details.open);
    for (const details of opened) details.open = true;
    const words = element('figcaption', {}, describeScene(store));
    figure.replaceChildren(...(scene ? [drawPicture(scene, { ...SIZE, background: 'clear', shadows: true })] : []), words);
  }
  function restore() {
    for (const details of opened) details.open = false;
    figure.replaceChildren();
  }
  addEventListener('beforeprint', prepare);
  addEventListener('afterprint', restore);
  return () => {
    removeEventListener('beforeprint', prepare);
    removeEventListener('afterprint', restore);
  };
}

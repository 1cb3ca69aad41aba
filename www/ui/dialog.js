/**
 * Dialogs: a title, a body, a button to close. Focus goes in and comes back, Escape closes; the browser sees to both.
 */
import { element } from './dom.js';

let made = 0;

/**
 * Opens a dialog; it is removed when it is closed.
 * @param {string} title
 * @param {...(Node | string)} body
 * @returns {HTMLDialogElement}
 */
export const openDialog = (title, ...body) => openDialogIn(document.body, title, ...body);

/**
 * The same in another tree, such as that of an element.
 * @param {Element} place
 * @param {string} title
 * @param {...(Node | string)} body
 * @returns {HTMLDialogElement}
 */
export function openDialogIn(place, title, ...body) {
  const heading = element('h2', { id: `dialog-${++made}` }, title);
  const dialog = element(
    'dialog',
    { 'aria-labelledby': heading.id, close: () => dialog.remove() },
    element('header', {}, heading, element('button', { class: 'quiet', 'aria-label': 'Close', click: () => dialog.close() }, '×')),
    element('div', {}, ...body),
  );
  dialog.addEventListener('click', (event) => {
    // Not the second click of the double click that opened it.
    if (event.target === dialog && event.detail < 2) dialog.close();
  });
  place.append(dialog);
  dialog.showModal();
  return dialog;
}

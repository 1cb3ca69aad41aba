/**
 * Short notices over the page, spoken by screen readers too: what was done, and the way back from it.
 */
import { element } from './dom.js';

/** How long a notice stays, in milliseconds; one with something to click stays longer. */
const STAY = 5000;
const STAY_WITH_ACTION = 12000;

/**
 * @typedef {object} NoticeAction
 * @property {string} [label] the button's
 * @property {() => void} [act]
 * @property {(end: () => void) => void} [until] is given what takes the button away, for when it would do something else
 * @property {boolean} [stays] until it is closed or clicked
 * @typedef {(text: string, action?: NoticeAction) => void} Say
 */

/** @param {HTMLElement} place a live region @returns {Say} */
export function createNotices(place) {
  return (text, { label, act, until, stays } = {}) => {
    const notice = element('p', {}, element('span', {}, text));
    const remove = () => notice.remove();
    if (label) {
      const click = () => {
        remove();
        act?.();
      };
      const button = element('button', { class: 'link', click }, label);
      notice.append(button);
      until?.(() => button.remove());
    }
    // The newest replaces what stands there, but for what must be read: a pile would cover the view.
    for (const other of [...place.children]) if (!other.matches('.stays') || other.textContent?.startsWith(text)) other.remove();
    if (stays) {
      notice.className = 'stays';
      notice.append(element('button', { class: 'link', 'aria-label': 'Close this notice', click: remove }, '×'));
    } else setTimeout(remove, label ? STAY_WITH_ACTION : STAY);
    place.append(notice);
  };
}

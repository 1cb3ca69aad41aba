/**
 * Short notices over the page, spoken by screen readers too: what was done, and the way back from it.
 */
import { element } from '../dom.js';

/** How long a notice stays, in milliseconds; one with something to click stays longer. */
const STAY = 5000;
const STAY_WITH_ACTION = 12000;

/** @typedef {(text: string, action?: {label: string, act: () => void}) => void} Say */

/** @param {HTMLElement} place a live region @returns {Say} */
export function createNotices(place) {
  return (text, action) => {
    const notice = element('p', {}, text);
    const remove = () => notice.remove();
    if (action) {
      const act = () => {
        remove();
        action.act();
      };
      notice.append(element('button', { class: 'link', click: act }, action.label));
    }
    // The newest replaces what stands there: a pile would cover the view.
    place.replaceChildren(notice);
    setTimeout(remove, action ? STAY_WITH_ACTION : STAY);
  };
}

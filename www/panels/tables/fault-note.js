/**
 * The fault of the document, written beside the cell that caused it.
 *
 * @typedef {import('../../core/types.js').Fault} Fault
 */
import { covers } from '../../core/path.js';
import { element } from '../../ui/dom.js';
import { sentence } from '../../core/format.js';

const ID = 'fault-note';

/**
 * @param {HTMLElement} root holds the elements with a `data-path`
 * @returns {{show: (fault: Fault | null) => HTMLElement | null}} `show` gives the element at fault
 */
export function createFaultNote(root) {
  /** @type {Element | null} */
  let note = null;
  /** @type {Element | null} */
  let marked = null;

  const clear = () => {
    note?.remove();
    note = null;
    marked?.removeAttribute('aria-invalid');
    marked?.removeAttribute('aria-describedby');
    marked = null;
  };

  return {
    show(fault) {
      clear();
      if (!fault) return null;
      const { what, remedy } = parts(fault);
      const text = element('div', { id: ID, class: 'fault' }, element('strong', {}, what), ` ${remedy}`);
      const place = closest(root, fault.where);
      if (!place) {
        note = text;
        root.prepend(text);
        return null;
      }
      const row = place.closest('tr');
      if (row) {
        note = element('tr', { class: 'fault-row' }, element('td', { colspan: row.cells.length }, text));
        row.after(note);
      } else {
        note = text;
        const container = place.closest('.field');
        if (container) container.append(text);
        else place.prepend(text);
      }
      if (place.matches('input, select')) place.setAttribute('aria-invalid', 'true');
      place.setAttribute('aria-describedby', ID);
      marked = place;
      return place;
    },
  };
}

/**
 * The cell of that place, or the smallest thing around it.
 * @param {HTMLElement} root
 * @param {string} where
 */
function closest(root, where) {
  /** @type {HTMLElement | null} */
  let best = null;
  for (const candidate of root.querySelectorAll('[data-path]')) {
    if (!(candidate instanceof HTMLElement)) continue;
    const path = candidate.dataset.path ?? '';
    if (covers(path, where) > (best ? covers(best.dataset.path ?? '', where) : 0)) best = candidate;
  }
  return best;
}

/**
 * What is wrong, and what would be accepted: the two parts of a fault's message. Where the place is known, line and
 * column of a text that the person never sees are left out.
 * @param {Fault} fault
 */
export function parts({ message, accepted, where }) {
  const remedy = `Accepted: ${accepted}.`;
  const parted = message.endsWith(remedy);
  const what = parted ? message.slice(0, -remedy.length).trim() : message;
  return { what: sentence(where ? what.replace(/^Line \d+, column \d+\. /, '') : what), remedy: parted ? remedy : '' };
}

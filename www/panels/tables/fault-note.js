/**
 * The faults of the document, each written beside the cell that caused it.
 *
 * @typedef {import('../../core/types.js').Fault} Fault
 */
import { faultParts } from '../../core/fault-text.js';
import { covers, valueAt } from '../../core/path.js';
import { element } from '../../ui/dom.js';
import { numberHint } from './number-hint.js';

const ID = 'fault-note';

/** @param {HTMLElement} root holds the elements with a `data-path` */
export function createFaultNote(root) {
  /** @type {Element[]} */
  let notes = [];
  /** @type {Element[]} */
  let marked = [];

  const clear = () => {
    for (const note of notes) note.remove();
    for (const place of marked) {
      place.removeAttribute('aria-invalid');
      place.removeAttribute('aria-describedby');
    }
    [notes, marked] = [[], []];
  };

  /** @param {Fault} fault @param {string} id @param {import('../../core/types.js').MechanismDocument} doc */
  function mark(fault, id, doc) {
    const text = noteOf(fault, id, doc);
    const place = closest(root, fault.where);
    if (!place) {
      notes.push(text);
      root.prepend(text);
      return null;
    }
    // Of a vector or a matrix all cells are meant.
    const fields = place.matches('input, select') ? [place] : [...place.querySelectorAll(':scope:is(.point, .matrix) > input')];
    for (const field of new Set([place, ...fields])) {
      if (marked.includes(field)) continue;
      if (fields.includes(field)) field.setAttribute('aria-invalid', 'true');
      field.setAttribute('aria-describedby', id);
      marked.push(field);
    }
    const row = place.closest('tr');
    if (row) {
      const columns = [...row.cells].reduce((sum, { colSpan }) => sum + colSpan, 0);
      const note = element('tr', { class: 'fault-row' }, element('td', { colspan: columns }, text));
      // Below the notes of the row's other cells.
      let last = row;
      while (last.nextElementSibling?.matches('.fault-row')) last = /** @type {HTMLTableRowElement} */ (last.nextElementSibling);
      last.after(note);
      notes.push(note);
    } else {
      const container = place.closest('.field');
      if (container) container.append(text);
      else place.prepend(text);
      notes.push(text);
    }
    return place;
  }

  return {
    /**
     * @param {Fault[]} faults
     * @param {import('../../core/types.js').MechanismDocument} doc that they are of
     * @returns {HTMLElement | null} the element at the first fault
     */
    show(faults, doc) {
      clear();
      const places = faults.map((fault, index) => mark(fault, index ? `${ID}-${index + 1}` : ID, doc));
      return places[0] ?? null;
    },
  };
}

/** @param {Fault} fault @param {string} id @param {import('../../core/types.js').MechanismDocument} doc */
function noteOf(fault, id, doc) {
  const { what, remedy } = faultParts(fault);
  const typed = valueAt(doc, fault.where);
  const hint = fault.code === 'wrong-type' && typeof typed === 'string' ? numberHint(typed) : '';
  return element('div', { id, class: 'fault' }, element('strong', {}, what), ` ${hint || remedy}`);
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

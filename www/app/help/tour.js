/**
 * The guided first minute: a few notes, each beside what it speaks of. It never blocks the page, can be left at any
 * note, and does not come again unless asked for.
 */
import { element, targetOf } from '../../ui/dom.js';
import { SEEN } from './help.js';

/** Distance from a note to what it speaks of, and to the window's edge, in pixels. */
const GAP = 12;

/** @type {{at: string, text: string}[]} */
const NOTES = [
  { at: '#canvas', text: 'The linkage tries to follow the dark motion. The light one is the closest that it can come. Drag to look around, scroll or pinch to zoom.' },
  { at: '.transport', text: 'Play, or scrub through the frames. The strip shows how large the gap is at each frame, and whether the goal is reached.' },
  { at: '#info, #tab-info, #fold-info', text: 'How far this frame is from its goal, and why it comes no closer: which chain holds the workpiece back.' },
  { at: '#tables, #fold-tables', text: 'Change any number: the motion is planned anew as you type. Ctrl+Z takes it back.' },
  { at: '#canvas', text: 'Or move things by hand: click a key frame or the workpiece in the view, and drag.' },
  { at: '#menus', text: 'Examples, files, links to share, pictures and films are up here. Help has lessons, and this first minute again.' },
];

function keepSeen() {
  try {
    localStorage.setItem(SEEN, new Date().toISOString().slice(0, 10));
  } catch {
    // It will come again on the next visit: a small price.
  }
}

/** @type {(() => void) | null} */
let leave = null;

/**
 * @param {Pick<import('../../element/workbench.js').App, 'root'>} app
 * @param {{focus: boolean}} how whether the first note takes the focus: not when it comes unasked
 */
export function startTour({ root }, { focus }) {
  leave?.();
  let at = 0;
  const text = element('p', { id: 'tour-text' });
  const count = element('span', { class: 'count' });
  const next = element('button', { class: 'primary-text', click: () => go(at + 1) }, 'Next');
  const back = element('button', { class: 'quiet', click: () => go(at - 1) }, 'Back');
  const skip = element('button', { class: 'quiet', click: end }, 'Skip');
  const note = element(
    'section',
    { class: 'tour', role: 'region', 'aria-label': 'First minute', tabindex: -1 },
    text,
    element('footer', {}, count, skip, back, next),
  );
  /** @type {Element | null} */
  let marked = null;

  const target = () => {
    const all = /** @type {HTMLElement[]} */ ([...root.querySelectorAll(NOTES[at].at), ...document.querySelectorAll(NOTES[at].at)]);
    return all.find((candidate) => candidate.getClientRects().length > 0) ?? null;
  };

  function place() {
    marked?.classList.remove('tour-here');
    marked = target();
    if (!marked) return;
    marked.classList.add('tour-here');
    const there = marked.getBoundingClientRect();
    const { offsetWidth: width, offsetHeight: height } = note;
    const fit = (/** @type {number} */ value, /** @type {number} */ size, /** @type {number} */ room) => Math.max(GAP, Math.min(value, room - size - GAP));
    // Beside it where there is room, else at its lower edge.
    const right = there.right + GAP + width < innerWidth;
    const left = there.left - GAP - width > 0;
    const x = right ? there.right + GAP : left ? there.left - GAP - width : there.left + (there.width - width) / 2;
    const above = there.top - GAP - height > 0;
    const y = right || left ? there.top + GAP : above && there.height < innerHeight / 3 ? there.top - GAP - height : there.bottom - height - GAP;
    note.style.left = `${fit(x, width, innerWidth)}px`;
    note.style.top = `${fit(y, height, innerHeight)}px`;
  }

  /** @param {number} to */
  function go(to) {
    if (to >= NOTES.length) return end();
    at = to;
    text.textContent = NOTES[at].text;
    count.textContent = `${at + 1} of ${NOTES.length}`;
    back.hidden = at === 0;
    next.textContent = at === NOTES.length - 1 ? 'Done' : 'Next';
    place();
  }

  function end() {
    const within = note.contains(document.activeElement);
    leave?.();
    keepSeen();
    if (within) root.getElementById('canvas')?.focus();
  }

  const key = (/** @type {KeyboardEvent} */ event) => {
    // What an Escape was for in a field, a menu or the view it is not for here.
    const taken = event.defaultPrevented || targetOf(event)?.closest('input:not([type=range]), select, textarea') || document.querySelector('dialog[open], :popover-open');
    if (event.key === 'Escape' && !taken) end();
  };
  leave = () => {
    marked?.classList.remove('tour-here');
    note.remove();
    removeEventListener('resize', place);
    document.removeEventListener('keydown', key);
    leave = null;
  };
  addEventListener('resize', place);
  document.addEventListener('keydown', key);
  document.body.append(note);
  note.setAttribute('aria-live', 'polite');
  go(0);
  if (focus) next.focus();
}

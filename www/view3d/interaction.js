/**
 * How much of a pointer, a wheel and fingers the view takes from the page around it: nothing (`none`), what the page does not
 * need to scroll (`ctrl`), or everything (`full`).
 */
import { element, setText } from '../ui/dom.js';

/** How long the note stays after the last try, in milliseconds. */
const STAY = 1500;

/** A Mac's key is Command, where Ctrl and the wheel may be the system's own lens. */
const WHEEL = `${/Mac|iP(hone|ad)/.test(globalThis.navigator?.platform ?? '') ? '⌘' : 'Ctrl'} and wheel zooms`;
const FINGERS = 'Two fingers turn and zoom';

/** @param {Pick<import('../element/workbench.js').App, 'scene' | 'interaction' | 'signal'>} app */
export function createInteraction({ scene, interaction, signal }) {
  if (!scene || interaction === 'full') return;
  const { canvas, controls } = scene;
  if (interaction === 'none') {
    // It takes no pointer either, by style/view.css.
    canvas.removeAttribute('tabindex');
    canvas.setAttribute('role', 'img');
    canvas.setAttribute('aria-label', '3D view of the linkage');
    return;
  }

  const note = element('p', { class: 'take-note', 'aria-hidden': 'true' });
  canvas.after(note);
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let hiding;
  /** Says for a moment what would have turned or zoomed the view. @param {string} text */
  function tell(text) {
    setText(note, text);
    note.classList.add('shown');
    clearTimeout(hiding);
    hiding = setTimeout(() => note.classList.remove('shown'), STAY);
  }
  signal.addEventListener('abort', () => clearTimeout(hiding));

  // The page gets the event too: a script may be what scrolls it.
  canvas.addEventListener(
    'wheel',
    ({ ctrlKey, metaKey }) => {
      controls.zooms = ctrlKey || metaKey;
      if (!controls.zooms) tell(WHEEL);
    },
    { capture: true, passive: true },
  );
  canvas.addEventListener('wheel', () => {
    controls.zooms = true;
  }, { passive: true });

  canvas.style.touchAction = 'pan-x pan-y';
  controls.leavesOneFinger = true;
  for (const type of /** @type {const} */ (['touchstart', 'touchmove'])) {
    canvas.addEventListener(
      type,
      (event) => {
        // Two fingers, or one that has taken hold of something, are meant for the view: the page does not scroll by them.
        if (event.cancelable && (event.targetTouches.length > 1 || canvas.classList.contains('dragging'))) event.preventDefault();
      },
      { passive: false },
    );
  }
  canvas.addEventListener('pointercancel', ({ pointerType, isPrimary }) => {
    if (pointerType === 'touch' && isPrimary) tell(FINGERS);
  });
}

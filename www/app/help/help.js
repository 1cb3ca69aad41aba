/**
 * The Help menu, the key of the keys, and the lesson or the first minute that a page begins with.
 */
import { byId, targetOf } from '../../ui/dom.js';
import { loaded, withPart } from '../../ui/lazy.js';
import { onKeys } from '../../ui/keys.js';
import { menuButton } from '../../ui/menu.js';

/** Where it is kept that the first minute was seen. */
export const SEEN = 'synthetica.first-minute';

/** @param {import('../../element/workbench.js').AppWithPanels} app */
export function createHelp(app) {
  /** @param {(reference: typeof import('./reference.js')) => void} show */
  const reference = (show) => () => withPart(app, 'This part of the help', () => import('./reference.js'), show);
  const showKeys = reference(({ showKeys: show }) => show());
  const showNumbers = reference(({ showNumbers: show }) => show());
  const lesson = (/** @type {string} */ id) => withPart(app, 'The lesson', async () => (await import('./open-lesson.js')).openLesson(app, id), () => {});

  /** @param {boolean} focus whether the first note takes the focus: not when it comes unasked */
  const start = (focus) => withPart(app, 'The first minute', () => import('./tour.js'), ({ startTour }) => startTour(app, { focus }));
  const tour = () => start(true);
  const items = async () => (await loaded(app, 'The help', () => import('./items.js'))).helpItems({ tour, showKeys, showNumbers, lesson });
  byId('menus').append(menuButton('Help', items));
  onKeys(document, {
    keys(event) {
      if (targetOf(event)?.closest('input:not([type=range]), select, textarea') || document.querySelector('dialog[open]')) return false;
      showKeys();
    },
  });

  // The lesson of the address, or the first minute of a first visit.
  const asked = new URLSearchParams(location.search).get('lesson');
  if (asked !== null) lesson(asked);
  // The motion first.
  else if (!wasSeen()) requestAnimationFrame(() => requestAnimationFrame(() => start(false)));
}

/** Whether the first minute was seen in this browser; where nothing can be kept, it counts as seen, or it would come every time. */
function wasSeen() {
  try {
    return localStorage.getItem(SEEN) !== null;
  } catch {
    return true;
  }
}

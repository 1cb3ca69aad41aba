/**
 * The Help menu, the key of the keys, and the lesson or the first minute that a page begins with.
 */
import { byId, targetOf } from '../../ui/dom.js';
import { loaded, withPart } from '../../ui/lazy.js';
import { onKeys } from '../../ui/keys.js';
import { menuButton } from '../../ui/menu.js';
import { startTour, wasSeen } from './tour.js';

/** @param {import('../../element/workbench.js').AppWithPanels} app */
export function createHelp(app) {
  /** @param {(reference: typeof import('./reference.js')) => void} show */
  const reference = (show) => () => withPart(app, 'This part of the help', () => import('./reference.js'), show);
  const showKeys = reference(({ showKeys: show }) => show());
  const showNumbers = reference(({ showNumbers: show }) => show());
  const lesson = (/** @type {string} */ id) => withPart(app, 'The lesson', async () => (await import('./open-lesson.js')).openLesson(app, id), () => {});

  const tour = () => startTour(app, { focus: true });
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
  else if (!wasSeen()) startTour(app, { focus: false });
}

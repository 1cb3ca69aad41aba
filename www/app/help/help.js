/**
 * The Help menu: the first minute, the keys, what the numbers mean, the lessons, the pages beside the applet.
 */
import { byId, targetOf } from '../../ui/dom.js';
import { withPart } from '../../ui/lazy.js';
import { onKeys } from '../../ui/keys.js';
import { menuButton } from '../../ui/menu.js';
import lessons from '../../lessons/index.json';
import { startTour, wasSeen } from './tour.js';

/** @param {import('../../element/workbench.js').AppWithPanels} app */
export function createHelp(app) {
  /** @param {(reference: typeof import('./reference.js')) => void} show */
  const reference = (show) => () => withPart(app, 'This part of the help', () => import('./reference.js'), show);
  const showKeys = reference(({ showKeys: show }) => show());
  const showNumbers = reference(({ showNumbers: show }) => show());
  const lesson = (/** @type {string} */ id) => withPart(app, 'The lesson', async () => (await import('./lessons.js')).openLesson(app, id), () => {});

  /** A page of the site, beside the applet. @param {string} address */
  const page = (address) => () => window.open(address, '_blank', 'noopener');

  byId('menus').append(
    menuButton('Help', () => [
      { label: 'First minute', hint: 'A short tour of the page', act: () => startTour(app, { focus: true }) },
      { label: 'Keys', hint: 'Everything from the keyboard: ?', act: showKeys },
      { label: 'What the numbers mean', hint: 'Each with its equation', act: showNumbers },
      'line',
      ...lessons.map(({ id, title, line }) => ({ label: `Lesson: ${title}`, hint: line, act: () => lesson(id) })),
      'line',
      { label: 'Gallery', hint: 'The examples, described', act: page('./gallery.html') },
      { label: 'Course', hint: 'A lecture with live linkages', act: page('./course.html') },
      { label: 'Method', hint: 'The derivation, and the paper’s misprints', act: page('./method.html') },
      { label: 'Reference', hint: 'Documents and programs', act: page('./reference.html') },
    ]),
  );
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

/**
 * What the Help menu offers, loaded when it is opened: the first minute, the keys, what the numbers mean, the lessons, the pages
 * beside the applet.
 */
import lessons from '../../lessons/index.json';

/** A page of the site, beside the applet. @param {string} address */
const page = (address) => () => window.open(address, '_blank', 'noopener');

/**
 * @param {{tour: () => void, showKeys: () => void, showNumbers: () => void, lesson: (id: string) => void}} acts
 * @returns {import('../../ui/menu.js').MenuItem[]}
 */
export const helpItems = ({ tour, showKeys, showNumbers, lesson }) => [
  { label: 'First minute', hint: 'A short tour of the page', act: tour },
  { label: 'Keys', hint: 'Everything from the keyboard: ?', act: showKeys },
  { label: 'What the numbers mean', hint: 'Each with its equation', act: showNumbers },
  'line',
  ...lessons.map(({ id, title, line }) => ({ label: `Lesson: ${title}`, hint: line, act: () => lesson(id) })),
  'line',
  { label: 'Gallery', hint: 'The examples, described', act: page('./gallery.html') },
  { label: 'Course', hint: 'A lecture with live linkages', act: page('./course.html') },
  { label: 'Method', hint: 'The derivation, and the paper’s misprints', act: page('./method.html') },
  { label: 'Reference', hint: 'Documents and programs', act: page('./reference.html') },
  { label: 'How to get it', hint: 'For a site or a program of your own', act: page('./get.html') },
  { label: 'Licences', hint: 'This program’s, and those of others in it', act: page('./licences.txt') },
];

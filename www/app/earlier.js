/**
 * Documents that this browser kept when others took their place.
 */
import { element } from '../ui/dom.js';
import { openDialog } from '../ui/dialog.js';

/** @param {import('../element/workbench.js').App} app @param {import('./files/browser-storage.js').Earlier[]} list newest first */
export function openEarlier({ open }, list) {
  const entries = list.map(({ when, title, doc }) => {
    const choose = async () => {
      if (await open(JSON.stringify(doc))) dialog.close();
    };
    const words = [title, new Date(when).toLocaleString('en-GB', { dateStyle: 'medium', timeStyle: 'short' })].filter(Boolean).join(', ');
    return element('li', {}, element('button', { class: 'wide', click: choose }, doc.name || 'Linkage', ' ', element('small', {}, words)));
  });
  const dialog = openDialog('Earlier documents', element('p', {}, 'Kept in this browser when another document took their place. Opening one can be undone.'), element('ul', {}, ...entries));
}

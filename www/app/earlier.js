/**
 * Documents that this browser kept when others took their place, and what it kept and could not show.
 */
import { element } from '../ui/dom.js';
import { openDialog } from '../ui/dialog.js';
import { MAX_EARLIER } from './files/browser-storage.js';
import { saveFile } from '../export/save.js';

/** @param {import('../element/workbench.js').App} app @param {import('./files/browser-storage.js').Earlier[]} list newest first */
export function openEarlier({ say, show, whole }, list) {
  /** Opened with its fault too, which the tables mark. @param {import('../core/types.js').MechanismDocument} doc */
  async function choose(doc) {
    const read = await whole(JSON.stringify(doc));
    if (read.is === 'trouble') return say(`${doc.name || 'The linkage'} was not opened. ${read.message}`, { label: 'Try again', act: () => choose(doc), stays: true });
    show(read.is === 'answer' ? read.value : doc);
    dialog.close();
  }

  /** @param {string} text */
  const download = (text) => saveFile('kept-document.txt', new Blob([text], { type: 'text/plain' }));

  const entries = list.map(({ when, title, doc, text = '' }) => {
    const date = when ? new Date(when).toLocaleString('en-GB', { dateStyle: 'medium', timeStyle: 'short' }) : '';
    const words = [title, date].filter(Boolean).join(', ');
    const name = doc ? doc.name || 'Linkage' : 'A text that cannot be read: download it';
    return element('li', {}, element('button', { class: 'wide', click: () => (doc ? choose(doc) : download(text)) }, name, ' ', element('small', {}, words)));
  });
  const about = `Kept in this browser when another document took their place, or when they could not be shown: the last ${MAX_EARLIER}. Opening one can be undone.`;
  const dialog = openDialog('Earlier documents', element('p', {}, about), element('ul', {}, ...entries));
}

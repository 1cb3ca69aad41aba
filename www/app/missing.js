/**
 * What stands in the view where the address asks for a document that there is not: why, and ways on from there.
 */
import { byId, element } from '../ui/dom.js';
import { withPart } from '../ui/lazy.js';

/** @param {import('../core/linkage.js').Linkage} linkage @param {string} why a sentence */
export function showMissing({ store, open, say }, why) {
  const examples = element('button', { class: 'link', click: () => withPart({ say }, 'The examples', () => import('./gallery.js'), ({ openGallery }) => openGallery({ store, open, say })) }, 'See all examples');
  // Where the element shows what stands in it until there is a motion.
  const note = element('p', { role: 'alert' }, why, ' ', examples);
  byId('linkage').append(note);
  const leave = store.subscribe('document', () => {
    leave();
    note.remove();
  });
}

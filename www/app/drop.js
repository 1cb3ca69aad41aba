/**
 * Documents by drag and drop onto the page, and by pasting their text.
 */
import { byId, targetOf } from '../ui/dom.js';

/**
 * @param {{take: (file: File) => void}} documents
 * @param {(text: string) => void} open
 */
export function createDrop(documents, open) {
  const hint = byId('drop-hint');
  const holdsFiles = (/** @type {DragEvent} */ event) => event.dataTransfer?.types.includes('Files') ?? false;

  addEventListener('dragover', (event) => {
    if (!holdsFiles(event)) return;
    event.preventDefault();
    hint.hidden = false;
  });
  addEventListener('dragleave', (event) => {
    // Without a related target the pointer has left the window.
    if (!event.relatedTarget) hint.hidden = true;
  });
  addEventListener('drop', (event) => {
    if (!holdsFiles(event)) return;
    event.preventDefault();
    hint.hidden = true;
    const [file] = event.dataTransfer?.files ?? [];
    if (file) documents.take(file);
  });
  addEventListener('paste', (event) => {
    if (targetOf(event)?.closest('input, textarea, [contenteditable]')) return;
    const text = event.clipboardData?.getData('text/plain') ?? '';
    if (/^\s*\{/.test(text)) open(text);
  });
}

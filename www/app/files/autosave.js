/**
 * Keeps the work in the browser while it is edited, and says when that cannot be done.
 */

import { textOf } from '../../core/document-text.js';

/** Characters beyond which the size is the reason: what the storage of most browsers holds. */
const LARGE = 5_000_000;

/** Milliseconds without an edit after which the work is kept: while one types or drags it would be kept needlessly often. */
const PAUSE = 400;

/**
 * @param {Pick<import('../../element/workbench.js').App, 'store' | 'say'>} app
 * @param {ReturnType<typeof import('./browser-storage.js').createKeeper>} keeper
 */
export function createAutosave({ store, say }, keeper) {
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let waiting;
  let kept = true;
  let told = false;

  function save() {
    clearTimeout(waiting);
    waiting = undefined;
    const { result, unsaved, origin } = store;
    const good = result.fault && result.doc !== store.doc ? result.doc : null;
    kept = keeper.save({ ...store.history, good, title: origin.title, unsaved });
    if (kept || told) return;
    told = true;
    const size = textOf(store.doc).length;
    const why = size > LARGE ? `it has ${(size / 1e6).toFixed(1)} MB, more than browsers keep` : 'its storage is full or switched off';
    say(`This document cannot be kept in this browser: ${why}. Save it to a file before you leave the page.`, { stays: true });
  }

  const soon = () => {
    clearTimeout(waiting);
    // A hand that moves something goes on to do so.
    waiting = setTimeout(() => (store.view.moving ? soon() : save()), PAUSE);
  };
  store.subscribe('document', soon);
  store.subscribe('origin', soon);
  // The last moment that a page is sure to get.
  document.addEventListener('visibilitychange', () => document.hidden && waiting && save());
  addEventListener('pagehide', () => waiting && save());

  addEventListener('beforeunload', (event) => {
    if (waiting) save();
    if (!kept && store.unsaved) event.preventDefault();
  });

  let warned = false;
  addEventListener('storage', (event) => {
    if (warned || !keeper.isOthers(event)) return;
    warned = true;
    say('Synthetica is being used in another tab too. Each tab keeps its own document; after a reload you see the one edited last, and find the other in the File menu (▾ beside Save), Earlier documents.', { stays: true });
  });
}

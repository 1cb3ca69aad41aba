/**
 * The header: what is done with documents, the document's name, its description in full, the colour scheme.
 *
 * @typedef {import('../element/workbench.js').App} App
 */
import { atRest } from '../core/at-rest.js';
import { setValue } from '../core/edits.js';
import { byId, setText } from '../ui/dom.js';
import { KEYS, keyTip, onKeys } from '../ui/keys.js';
import { withPart } from '../ui/lazy.js';
import { menuButton } from '../ui/menu.js';
import { createTheme } from './theme.js';

/**
 * @param {import('../element/workbench.js').AppWithPanels} app
 * @param {ReturnType<typeof import('./files/documents.js').createDocuments>} documents
 * @param {{earlier: () => import('./files/browser-storage.js').Earlier[]}} keeper
 */
export function createHeader(app, documents, keeper) {
  const { store } = app;
  createTheme();
  createAbout(store);
  store.select(({ view }) => view.only, (only) => (/** @type {HTMLElement} */ (byId('menus').parentElement).hidden = only));

  const examples = () => withPart(app, 'The examples', () => import('./gallery.js'), ({ openGallery }) => openGallery(app));
  const earlier = () => withPart(app, 'The list of earlier documents', () => import('./earlier.js'), ({ openEarlier }) => openEarlier(app, keeper.earlier()));

  byId('skip').addEventListener('click', (event) => {
    // Its target is inside the element, where no address reaches.
    event.preventDefault();
    const shown = app.root.querySelector('.tables > .shown, .info.shown');
    app.unfold(shown ?? app.find('tables'));
    const [first] = /** @type {HTMLElement[]} */ ([...(shown?.querySelectorAll('input, select, textarea, button') ?? [])]).filter((field) => field.checkVisibility() && !field.matches(':disabled'));
    (first ?? app.find('tabs').querySelector('[aria-selected=true]'))?.focus();
  });
  byId('examples').addEventListener('click', examples);
  byId('new').addEventListener('click', documents.fresh);
  byId('open').addEventListener('click', documents.pick);
  byId('save').addEventListener('click', () => documents.save());
  byId('share').addEventListener('click', documents.share);

  const file = menuButton('File', () => [
    { label: 'Examples', act: examples },
    { label: 'New…', hint: 'A mechanism by its name, or a type and a few sizes', act: documents.fresh },
    { label: 'Open…', key: KEYS.open.keys[0], hint: 'Or drop a file onto the page', act: documents.pick },
    { label: 'Save', key: KEYS.save.keys[0], act: () => documents.save() },
    { label: 'Save as…', act: () => documents.save(true) },
    'line',
    { label: 'Share', hint: 'A link that holds the whole document', act: documents.share },
    { label: 'Earlier documents', hint: 'Kept in this browser', disabled: keeper.earlier().length === 0 ? 'None is kept in this browser yet' : '', act: earlier },
    'line',
    { label: 'Colours', hint: byId('theme').getAttribute('aria-label')?.replace('Colours: ', 'Now '), act: () => byId('theme').click() },
  ]);
  file.classList.add('plain-button');
  file.id = 'file-menu';
  file.title = 'More: save as, earlier documents';
  byId('save').after(file);

  onKeys(document, { save: () => documents.save(), open: documents.pick });
  keyTip(byId('open'), 'Open a document, or drop it onto the page', 'open');
  keyTip(byId('save'), 'Save the document', 'save');
}

/** The name in the header, and what opens below it: name and description to read and to edit. @param {App['store']} store */
function createAbout(store) {
  const button = byId('about-button');
  const panel = byId('about-panel');
  const fields = /** @type {const} */ ([
    ['name', /** @type {HTMLInputElement} */ (byId('about-name'))],
    ['about', /** @type {HTMLTextAreaElement} */ (/** @type {unknown} */ (byId('about-text')))],
  ]);
  let visits = 0;
  for (const [path, field] of fields) {
    let visit = '';
    field.addEventListener('focus', () => {
      visit = `about ${++visits}`;
    });
    field.addEventListener('input', () => store.edit((doc) => setValue(doc, path, field.value), visit));
  }

  // The button opens it by its attribute; what is left to do is to place it below the button.
  panel.addEventListener('beforetoggle', () => {
    const { left, bottom } = button.getBoundingClientRect();
    panel.style.top = `${bottom + 4}px`;
    panel.style.left = `max(4px, min(${left}px, 100vw - var(--width) - 4px))`;
  });

  function show() {
    const { doc: shown, origin, unsaved } = store;
    setText(byId('document-name'), shown.name || 'Linkage');
    // The first sentence; the panel has the whole.
    setText(byId('about'), (shown.about ?? '').split(/(?<=[.!?])\s/)[0]);
    for (const [path, field] of fields) if (field.value !== (shown[path] ?? '')) field.value = shown[path] ?? '';
    byId('unsaved').hidden = !unsaved;
    setText(byId('about-file'), origin.title ? `${unsaved ? 'Changed since it was opened or saved as' : 'As in'} ${origin.title}.` : unsaved ? 'In no file yet.' : '');
    document.title = `${unsaved ? '● ' : ''}${shown.name || 'Linkage'} – Synthetica`;
  }
  atRest(store, ['document'], show);
  store.subscribe('origin', show);
  show();
}

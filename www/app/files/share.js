/**
 * The share dialog: a link, and code for other pages: a frame, an element, one file with everything in it.
 *
 * @typedef {import('./codes.js').Wish} Wish
 */
import '../../style/share.css';
import { copyText, NOT_COPIED } from '../../ui/copy.js';
import { element } from '../../ui/dom.js';
import { openDialog } from '../../ui/dialog.js';
import { shareAddress } from '../../core/address.js';
import { elementCode, fileCode, frameCode } from './codes.js';
import { withPart } from '../../ui/lazy.js';
import { fileName } from '../../export/file-name.js';
import { saveFile } from '../../export/save.js';

/** What may stand beside the view in another page. */
const PANELS = /** @type {const} */ ([['info', 'Info'], ['mechanism', 'Mechanism'], ['motion', 'Motion'], ['teach', 'Teach'], ['charts', 'Charts']]);
const HEIGHT = 420;
const LEAST_HEIGHT = 160;

/**
 * @param {import('../../element/workbench.js').App} app
 * @param {string} text the document
 * @param {string} payload the same, packed
 */
export function openShare({ store, say }, text, payload) {
  const home = location.href.replace(/[?#].*$/s, '');
  const name = store.doc.name || 'Linkage';
  const link = shareAddress(location.href, payload);

  const box = (/** @type {string} */ label, checked = false) => {
    const input = element('input', { type: 'checkbox', checked, change: write });
    return { input, label: element('label', {}, input, ` ${label}`) };
  };
  const [controls, autoplay, readonly] = [box('Controls', true), box('Plays by itself'), box('Read only')];
  const panels = PANELS.map(([panel, label]) => ({ panel, ...box(label) }));
  const height = element('input', { class: 'cell', type: 'number', min: LEAST_HEIGHT, max: 2000, step: 20, value: HEIGHT, input: write });

  /** @returns {Wish} */
  const wish = () => ({
    controls: controls.input.checked,
    autoplay: autoplay.input.checked,
    readonly: readonly.input.checked,
    panels: panels.filter(({ input }) => input.checked).map(({ panel }) => panel),
    height: Math.max(LEAST_HEIGHT, Math.round(Number(height.value)) || HEIGHT),
  });

  /** @param {string} label @param {string} value @param {number} rows */
  const code = (label, value, rows) => {
    const field = element('textarea', { class: 'cell text code', readonly: true, rows, 'aria-label': label, spellcheck: 'false', focus: () => field.select() });
    field.value = value;
    const copy = async () => {
      const copied = await copyText(field.value);
      if (!copied) field.focus();
      said.textContent = copied ? `${label} copied.` : NOT_COPIED;
    };
    return { field, parts: [field, element('p', {}, element('button', { click: copy, 'aria-label': `Copy ${label.toLowerCase()}` }, 'Copy'))] };
  };
  const said = element('p', { class: 'said', role: 'status' });
  const address = code('Link', link, 2);
  const frame = code('Frame', '', 4);
  const tag = code('Element', '', 4);
  const file = element('button', { click: save }, 'Save the file');

  function write() {
    frame.field.value = frameCode(name, home, payload, wish());
    tag.field.value = elementCode(text, home, wish());
  }

  async function save() {
    try {
      const answer = await fetch(new URL('inline.js', home));
      if (!answer.ok) throw new Error(`${answer.status} ${answer.statusText}`);
      saveFile(fileName(store.doc, 'html'), new Blob([fileCode(name, text, await answer.text(), wish())], { type: 'text/html' }));
      said.textContent = 'The file is saved.';
    } catch (error) {
      said.textContent = `The file could not be made (${/** @type {Error} */ (error).message}). Try again with a network.`;
    }
  }

  const grouped = (/** @type {number} */ count) => count.toLocaleString('en').replaceAll(',', ' ');
  const picture = element('div', { class: 'link-code' });
  withPart({ say }, 'The QR code', () => import('./qr.js'), ({ MOST, qrPicture }) => {
    const fits = link.length <= MOST;
    picture.append(fits ? qrPicture(link, 'QR code of the link') : element('p', { class: 'muted' }, `The link is too long for a QR code, which holds ${grouped(MOST)} characters.`));
  });

  const section = (/** @type {string} */ title, /** @type {string} */ words, /** @type {Node[]} */ ...parts) =>
    element('section', {}, element('h3', {}, title), element('p', { class: 'muted' }, words), ...parts);
  const dialog = openDialog(
    'Share',
    section('Link', `It holds the whole document, in ${grouped(link.length)} characters, and is sent nowhere.`, ...address.parts, picture),
    element('h3', {}, 'In another page'),
    element('p', { class: 'wishes', role: 'group', 'aria-label': 'What it has' }, controls.label, autoplay.label, readonly.label, element('label', {}, 'Height ', height, ' px')),
    element('p', { class: 'wishes', role: 'group', 'aria-label': 'Panels' }, element('span', { class: 'muted' }, 'Panels'), ...panels.map(({ label }) => label)),
    section('Frame', 'For course systems: paste it where they take HTML. It works from any site and in a sandbox, and needs nothing of a server.', ...frame.parts),
    section('Element', `For pages of your own: the tag and its script, which needs nothing of a server. Many on a page share one planner. A module in its place, ${new URL('element.js', home).href}, loads less at first, but from another site only where this one answers with the header Access-Control-Allow-Origin.`, ...tag.parts),
    section('One file', 'The linkage with all that it needs in one HTML file, which works without a network.', element('p', {}, file)),
    said,
  );
  dialog.classList.add('share');
  write();
  address.field.focus();
}

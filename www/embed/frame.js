/**
 * The page for frames: nothing but one linkage, told by the address what it is and how it is shown.
 */
import '../element/define.js';
import { element as make } from '../ui/dom.js';
import { readAddress } from '../core/address.js';
import { LATE, untilAnswered } from '../core/ask.js';
import { fetchText } from '../core/fetch-text.js';
import { answerTo } from '../core/from-address.js';
import { wear } from '../ui/style-sheets.js';
import look from '../style/embed.css?inline';
import { attributesOf, ownFile, parentOrigin, withoutContent } from './address.js';
import { speak } from './protocol.js';

/** Width below which panels are under the view, in pixels; style/embed.css has it too. */
const PHONE = 760;

/** Height over width of a view that shows a linkage well. */
const SHAPE = 0.6;

export function startFrame() {
  wear(document, look);
  const element = /** @type {import('../element/element.js').SyntheticaLinkage} */ (document.createElement('synthetica-linkage'));
  element.setAttribute('keys', 'page');
  // The browser decides when a frame is loaded: see the page around it.
  element.setAttribute('loading', 'eager');
  // The element waits for its document.
  element.document = null;
  const origin = parentOrigin(location.search, document.referrer);

  /** What the frame would fill: with panels on a phone all of it, else a view of a good shape with its controls. */
  function height() {
    if (innerWidth < PHONE && element.panels) return document.body.offsetHeight;
    const controls = element.shadowRoot?.querySelector('.transport');
    return Math.round(innerWidth * SHAPE) + (controls instanceof HTMLElement ? controls.offsetHeight : 0);
  }

  /** Whether the parent has given a document: what the address asks for comes too late. */
  let given = false;
  /** What is wrong with the file of `src`, in words that tell of it. */
  let unreadable = '';
  if (parent !== window) {
    const tellable = (/** @type {import('../element/element.js').LinkageError} */ error) => (error.message === unreadable && origin !== self.origin ? withoutContent(error) : error);
    speak(element, { window, parent, origin, height, tellable, sent: () => (given = true) });
  }
  // Only now, so that the parent hears of those that are refused.
  for (const [name, value] of attributesOf(location.search)) element.setAttribute(name, value);

  const { parts: linkage } = element;
  const complain = (/** @type {string} */ message) => {
    linkage.say(message, { stays: true });
    element.dispatchEvent(new CustomEvent('error', { detail: { message, where: '', code: 'address' } }));
  };
  const ownText = async (/** @type {string} */ src) => {
    const url = ownFile(src, location.href);
    // Its own server could send it on to where it may not go.
    return { text: await fetchText(url, { redirect: 'error' }), from: url.href };
  };
  untilAnswered(linkage.store, async () => (given ? LATE : answerTo(readAddress(location), linkage, ownText))).then((outcome) => {
    if (given || outcome.is !== 'answer') return;
    const { doc, broken, missing, fault, problems } = outcome.value;
    if (doc) element.document = doc;
    unreadable = fault?.message ?? '';
    if (!doc) linkage.store.setResult(fault ? { fault, trouble: '' } : { trouble: missing });
    if (broken) complain(`This link cannot be opened${doc ? ': a sample is shown in its place' : ''}. ${broken}`);
    for (const problem of problems) complain(problem);
  });
  // For screen readers; a person sees the linkage.
  const heading = make('h1', {}, 'Linkage');
  element.addEventListener('ready', () => {
    const name = element.document?.name || 'Linkage';
    heading.textContent = name;
    document.title = `${name} – Synthetica`;
  });
  document.body.append(make('main', {}, heading, element));
}

/**
 * The page for frames: nothing but one linkage, told by the address what it is and how it is shown.
 */
import '../element/define.js';
import { element as make } from '../ui/dom.js';
import { readAddress } from '../core/address.js';
import { untilAnswered } from '../core/ask.js';
import { answerTo } from '../core/from-address.js';
import { wear } from '../ui/style-sheets.js';
import look from '../style/embed.css?inline';
import { attributesOf, parentOrigin } from './address.js';
import { speak } from './protocol.js';

/** Width below which panels are under the view, in pixels; style/embed.css has it too. */
const PHONE = 760;

/** Height over width of a view that shows a linkage well. */
const SHAPE = 0.6;

export function startFrame() {
  wear(document, look);
  const element = /** @type {import('../element/element.js').SyntheticaLinkage} */ (document.createElement('synthetica-linkage'));
  for (const [name, value] of attributesOf(location.search)) element.setAttribute(name, value);
  element.setAttribute('keys', 'page');
  // Whether it is loaded late is the choice of the page around it: <iframe loading="lazy">.
  element.setAttribute('loading', 'eager');

  /** What the frame would fill: with panels on a phone all of it, else a view of a good shape with its controls. */
  function height() {
    if (innerWidth < PHONE && element.panels) return document.body.offsetHeight;
    const controls = element.shadowRoot?.querySelector('.transport');
    return Math.round(innerWidth * SHAPE) + (controls instanceof HTMLElement ? controls.offsetHeight : 0);
  }

  if (parent !== window) speak(element, { window, parent, origin: parentOrigin(location.search, document.referrer), height });

  const { parts: linkage } = element;
  const asked = readAddress(location);
  const src = new URLSearchParams(location.search).get('src');
  if (src) element.src = src;
  else {
    // The element waits for its document.
    element.document = null;
    untilAnswered(linkage.store, () => answerTo(asked, linkage)).then(({ value: { doc: shown, broken, problems } }) => {
      element.document = shown;
      if (broken) linkage.say(`This link cannot be opened: a sample is shown in its place. ${broken}`, { stays: true });
      for (const problem of problems) linkage.say(problem, { stays: true });
    });
  }
  // For screen readers; a person sees the linkage.
  const heading = make('h1', {}, 'Linkage');
  element.addEventListener('ready', () => {
    const name = element.document?.name || 'Linkage';
    heading.textContent = name;
    document.title = `${name} – Synthetica`;
  });
  document.body.append(make('main', {}, heading, element));
}

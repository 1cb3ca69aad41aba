/**
 * Keys that are typed into a field of the element, or that one of its parts handles, do not reach the page around it; all
 * others do.
 */
import { targetOf } from '../ui/dom.js';

const TEXT = 'textarea, input:not([type=range], [type=checkbox], [type=radio], [type=button], [type=file])';

/** The other controls, and the keys that a browser handles in each. @type {[string, RegExp][]} */
const CONTROLS = [
  ['select', /^(.|Enter|Arrow.*|Home|End|Page.*)$/u],
  ['input[type=range]', /^(Arrow.*|Home|End|Page.*)$/],
  ['input[type=radio]', /^( |Arrow.*)$/],
  ['button, summary, input', /^( |Enter)$/],
  ['a', /^Enter$/],
];

/** Keys that write or move in a text; and those that do so with Ctrl or Command. */
const WRITES = /^(.|Enter|Backspace|Delete|Insert|Arrow.*|Home|End|Page.*|Dead|Process|Unidentified)$/u;
const WRITES_HELD = /^([acvxyz]|Backspace|Delete|Insert|Arrow.*|Home|End)$/i;

/** @param {KeyboardEvent} event @param {ShadowRoot} root */
function isUsed(event, root) {
  if (event.defaultPrevented || event.isComposing) return true;
  const { key, ctrlKey, metaKey, altKey } = event;
  if (key === 'Escape') return root.querySelector(':popover-open, dialog[open]') !== null;
  const target = targetOf(event);
  // What stands in the slot is the page's own.
  if (!target || target.getRootNode() !== root) return false;
  // Ctrl and Alt together are AltGr, with which some keyboards type signs.
  const held = metaKey || (ctrlKey && !altKey);
  if (target.matches(TEXT)) return (held ? WRITES_HELD : WRITES).test(key);
  if (held || altKey) return false;
  const control = CONTROLS.find(([selector]) => target.matches(selector));
  return control !== undefined && control[1].test(key);
}

/** @param {ShadowRoot} root of the element @param {AbortSignal} signal ends it */
export function guardKeys(root, signal) {
  const { host } = root;
  /** Keys that are down and were used inside; what follows of them stays inside too. @type {Set<string>} */
  const used = new Set();
  /** @param {'keydown' | 'keypress' | 'keyup'} type @param {(event: KeyboardEvent) => unknown} act @param {boolean} [capture] */
  const listen = (type, act, capture) => host.addEventListener(type, /** @type {EventListener} */ (act), { capture, signal });
  // Used until it comes out again: an open menu keeps its keys to itself.
  listen('keydown', ({ code }) => used.add(code), true);
  listen('keydown', (event) => {
    if (isUsed(event, root)) event.stopPropagation();
    else used.delete(event.code);
  });
  listen('keypress', (event) => used.has(event.code) && event.stopPropagation());
  listen('keyup', (event) => used.delete(event.code) && event.stopPropagation());
}

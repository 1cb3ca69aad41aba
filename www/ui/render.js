/**
 * Renders a panel's HTML so that nodes, and with them focus, selection and scroll position, stay where they were: lit-html,
 * of which the page uses templates, lists with keys, and attributes that depend on state.
 */
import { noChange, render } from 'lit-html';
import { directive, Directive } from 'lit-html/directive.js';
import { getCommittedValue, getDirectiveClass } from 'lit-html/directive-helpers.js';
import { repeat as plainRepeat } from 'lit-html/directives/repeat.js';
import { focusBeside } from './dom.js';

export { html, nothing, render, svg } from 'lit-html';
export { ifDefined } from 'lit-html/directives/if-defined.js';
export { live } from 'lit-html/directives/live.js';

const Repeat = /** @type {any} */ (getDirectiveClass(plainRepeat([], () => '')));

/** A list with keys. lit-html 3.3 leaves an empty comment in the page for each row that goes: it goes too. @type {typeof plainRepeat} */
export const repeat = /** @type {any} */ (directive(/** @type {any} */ (
  class extends Repeat {
    /** @param {import('lit-html').ChildPart} part @param {unknown[]} what */
    update(part, what) {
      const shown = super.update(part, what);
      if (shown === noChange) sweep(part);
      return shown;
    }
  }
)));

/** Takes out the comments beside the rows of a list. @param {import('lit-html').ChildPart} list */
function sweep(list) {
  let at = list.startNode?.nextSibling ?? null;
  /** @param {Node | null} end */
  const sweepTo = (end) => {
    while (at && at !== end) {
      const next = at.nextSibling;
      if (at instanceof Comment && !at.data) at.remove();
      at = next;
    }
  };
  for (const { startNode, endNode } of /** @type {import('lit-html').ChildPart[]} */ (getCommittedValue(list))) {
    sweepTo(startNode);
    at = endNode?.nextSibling ?? null;
  }
  sweepTo(list.endNode);
}

class Attached extends Directive {
  /** @type {((state: any) => void) | null} */
  follow = null;

  /** @param {(node: any) => (state: any) => void} _make @param {unknown} _state */
  render(_make, _state) {
    return noChange;
  }

  /** @override @param {import('lit-html').ElementPart} part @param {[make: (node: any) => (state: any) => void, state: unknown]} what */
  update({ element }, [make, state]) {
    this.follow ??= make(element);
    this.follow(state);
    return noChange;
  }
}

/**
 * Behaviour of an element in a template, `<input ${attach(make, state)}>`: `make(element)` is called once, and what it
 * returns with the present state at every rendering.
 */
export const attach = directive(Attached);

/** The events of a focus that is lost and given back, which no listener is to get. */
const FOCUS_EVENTS = ['blur', 'change', 'focus', 'focusin', 'focusout'];

/**
 * Renders rows that may change places. To move a node a browser takes it out, which takes the focus from it: the focus and the
 * chosen text are given back, and no listener gets an event of it.
 * @param {unknown} template @param {HTMLElement} place
 */
export function renderRows(template, place) {
  const focused = /** @type {HTMLInputElement | null} */ (focusBeside(place));
  if (!place.contains(focused)) return render(template, place);
  const { selectionStart, selectionEnd, selectionDirection } = /** @type {HTMLInputElement} */ (focused);
  const life = new AbortController();
  for (const name of FOCUS_EVENTS) place.getRootNode().addEventListener(name, (event) => event.stopImmediatePropagation(), { capture: true, signal: life.signal });
  try {
    const part = render(template, place);
    if (focused?.isConnected && focusBeside(place) !== focused) {
      focused.focus({ preventScroll: true });
      if (typeof selectionStart === 'number') focused.setSelectionRange(selectionStart, selectionEnd, selectionDirection ?? undefined);
    }
    return part;
  } finally {
    life.abort();
  }
}

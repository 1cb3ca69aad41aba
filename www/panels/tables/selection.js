/**
 * Selection in the tables: what is focused or clicked there is selected everywhere, what is selected elsewhere is
 * marked and brought into sight there, without taking the focus.
 */
import { atRest } from '../../core/at-rest.js';

/** The things that can be selected: chains, joints, base and gripper frames, key frames, drivers. */
const THING = /^(?:chains\[\d+\](?:\.joints\[\d+\]|\.base|\.gripper)?|motion\.(?:key_frames|drivers)\[\d+\])/;

/** The thing that a place of the document belongs to, '' if it is none. @param {string} path */
const thingOf = (path) => THING.exec(path)?.[0] ?? '';

/**
 * @param {HTMLElement} root holds the panels
 * @param {HTMLElement[]} panels with tables
 * @param {Pick<import('../../element/workbench.js').AppWithPanels, 'store' | 'tabs' | 'narrow'>} app
 * @param {(place: string) => Promise<unknown> | null} ready loads the tables that show a place; null where they are there
 */
export function createSelection(root, panels, { store, tabs, narrow }, ready) {
  /** What was selected by the tables themselves: it is in sight already. */
  let own = '';

  const thingAt = (/** @type {EventTarget | null} */ target) =>
    thingOf(/** @type {HTMLElement | null} */ (/** @type {Element} */ (target).closest('[data-path]'))?.dataset.path ?? '');

  /** @param {string} place @returns {HTMLElement | null} the smallest part of the tables that shows it */
  function find(place) {
    const thing = thingOf(place);
    if (!thing) return null;
    // Itself, or the chain that it is part of.
    for (const path of [thing, /^chains\[\d+\]/.exec(thing)?.[0] ?? thing]) {
      for (const panel of panels) {
        const part = /** @type {HTMLElement | null} */ (panel.querySelector(`[data-path="${path}"]:not(input, select)`));
        if (part) return part;
      }
    }
    return null;
  }

  /** @param {string} name of the class @param {HTMLElement | null} part */
  function mark(name, part) {
    for (const old of root.querySelectorAll(`.${name}`)) {
      if (old === part) continue;
      old.classList.remove(name);
      if (name === 'chosen') old.removeAttribute('aria-current');
    }
    part?.classList.add(name);
    if (name === 'chosen') part?.setAttribute('aria-current', 'true');
  }

  /** @param {HTMLElement} part */
  function bring(part) {
    const panel = panels.find((candidate) => candidate.contains(part));
    // A lesson or the sliders of the joints do not give way to a click in the view.
    if (panel && panels.some((candidate) => candidate.classList.contains('shown'))) tabs.choosePanel(panel);
    // On a phone the page itself scrolls, and must stay at the view that was tapped.
    if (!narrow()) part.scrollIntoView({ block: 'nearest' });
  }

  function show() {
    const { selected, hovered } = store.view;
    mark('chosen', find(selected));
    mark('pointed', hovered === selected ? null : find(hovered));
  }

  const take = (/** @type {Event} */ { target }) => {
    const thing = thingAt(target);
    if (!thing) return;
    own = thing;
    store.setView({ selected: thing });
    own = '';
  };
  for (const panel of panels) {
    panel.addEventListener('focusin', take);
    panel.addEventListener('click', take);
    panel.addEventListener('pointerover', ({ target, pointerType }) => {
      if (pointerType === 'mouse') store.setView({ hovered: thingAt(target) });
    });
    panel.addEventListener('pointerleave', ({ pointerType }) => {
      if (pointerType === 'mouse') store.setView({ hovered: '' });
    });
  }
  store.select(({ view }) => view.hovered, show);
  store.select(({ view }) => view.selected, (selected) => {
    const meet = () => {
      show();
      const part = find(selected);
      if (part && thingOf(selected) !== own) bring(part);
    };
    meet();
    ready(thingOf(selected))?.then(() => {
      if (store.view.selected === selected) meet();
    });
  });
  // A thing may be in another row now, or in a new one.
  atRest(store, ['document'], show);

  return {
    /** Goes into the table at a thing. @param {string} place */
    async enter(place) {
      // Without a wait where there is no need: the focus stays with the key that brought it.
      const coming = ready(thingOf(place));
      if (coming) await coming;
      const part = find(place);
      if (!part) return;
      bring(part);
      /** @type {HTMLElement | null} */ (part.querySelector('input, select'))?.focus();
    },
  };
}

/**
 * What is seen of an element: the tree in its shadow root, and in it the workbench, made when the element first comes into
 * view. It lives while the element is in a page.
 *
 * @typedef {import('./workbench.js').AppWithPanels} AppWithPanels
 * @typedef {{keys: 'element' | 'page', panels: import('./workbench.js').Panel[]}} Wishes what the attributes ask for
 */
import markup from './canvas-area.html?raw';
import look from '../style/linkage.css?inline';
import { whileSeen } from '../ui/lazy.js';
import { wear } from '../ui/style-sheets.js';
import { createWorkbench } from './workbench.js';

/**
 * @param {HTMLElement & {parts: import('../core/linkage.js').Linkage}} element
 * @param {{root: ShadowRoot, wishes: () => Wishes, complain: (error: unknown) => void}} inside
 */
export function createSeen(element, { root, wishes, complain }) {
  const { parts: linkage } = element;
  /** Ends what is seen. @type {AbortController | null} */
  let life = null;
  let bench = withResolvers();
  let begun = false;
  linkage.player.seen = false;

  function build() {
    life = new AbortController();
    const { signal } = life;
    wear(root, look);
    root.innerHTML = markup;
    // A field's own event would leave the tree; the element tells of edits in its place.
    root.firstElementChild?.addEventListener('input', (event) => event.stopPropagation());
    whileSeen(element, signal, async (seen) => {
      linkage.player.seen = seen;
      if (seen) show();
      if (!begun) return;
      // That it could not be made has been told.
      const app = await bench.promise.catch(() => null);
      if (!signal.aborted) app?.scene?.setSeen(seen);
    });
  }

  function show() {
    if (begun || !life) return;
    begun = true;
    const { resolve, reject } = bench;
    const { keys, panels } = wishes();
    createWorkbench(linkage, { root, keys: keys === 'page' ? document : element, panels, signal: life.signal }).then(resolve, (error) => {
      complain(error);
      reject(error);
    });
  }

  function dismantle() {
    // With a reason of its own: the default one is an error, whose stack would hold on to the element.
    life?.abort('taken out');
    life = null;
    linkage.player.seen = false;
    linkage.player.draw = () => {};
    root.replaceChildren();
    if (begun) bench = withResolvers();
    begun = false;
  }

  return {
    /** Whether the element is in a page. */
    get isThere() {
      return life !== null;
    },
    /** The workbench, once it is made. @returns {Promise<AppWithPanels>} */
    get workbench() {
      return bench.promise;
    },
    build,
    show,
    dismantle,
    /** Makes it anew, by what the attributes ask for now. */
    rebuild() {
      if (!life) return;
      dismantle();
      build();
    },
  };
}

function withResolvers() {
  /** @type {{promise: Promise<AppWithPanels>, resolve: (app: AppWithPanels) => void, reject: (error: unknown) => void}} */
  const all = /** @type {any} */ ({});
  all.promise = new Promise((resolve, reject) => Object.assign(all, { resolve, reject }));
  // Avoids an unhandled rejection where nobody awaits it.
  all.promise.catch(() => {});
  return all;
}

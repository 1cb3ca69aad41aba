/**
 * What stands in the shadow root of an element: a tree with a poster or the element's own content, until the workbench
 * is loaded, when the element first comes near the view. It lives while the element is in a page.
 *
 * @typedef {import('./workbench.js').AppWithPanels} AppWithPanels
 * @typedef {{keys: 'element' | 'page', interaction: import('./workbench.js').Interaction, panels: import('./workbench.js').Panel[], loading: 'lazy' | 'eager'}} Wishes
 *   what the attributes ask for
 */
import markup from './canvas-area.html?raw';
import look from '../style/linkage.css?inline';
import { pieces } from './pieces.js';
import { finder, windowOf } from '../ui/dom.js';
import { loaded, whileSeen } from '../ui/lazy.js';
import { createNotices } from '../ui/notice.js';
import { wear } from '../ui/style-sheets.js';

/**
 * @param {HTMLElement & {poster: string, parts: import('../core/linkage.js').Linkage}} element
 * @param {{root: ShadowRoot, wishes: () => Wishes, complain: (error: unknown) => void, start: () => void}} inside `start` lets the document be loaded
 */
export function createShadowTree(element, { root, wishes, complain, start }) {
  const { parts: linkage } = element;
  /** Ends the tree; null while the element is in no page. @type {AbortController | null} */
  let life = null;
  let workbench = withResolvers();
  let isShown = false;
  /** Whether the workbench has been made, or cannot be. */
  let isMade = false;
  const find = finder(root);
  linkage.player.seen = false;

  function build() {
    life = new AbortController();
    const { signal } = life;
    linkage.player.window = windowOf(element);
    wear(root, look);
    root.innerHTML = markup;
    // A field's own event would leave the tree; the element tells of edits in its place.
    root.firstElementChild?.addEventListener('input', (event) => event.stopPropagation());
    linkage.tell = createNotices(find('notices'));
    // One that does not come leaves its place to the content.
    find('poster').addEventListener('error', () => showPoster(false));
    setPoster();
    addEventListener('beforeprint', () => (find('fallback').dataset.line = lineFor(element)), { signal });
    whileSeen(element, signal, (seen) => {
      linkage.player.seen = seen;
      if (seen) show();
    });
    if (wishes().loading === 'eager') show();
  }

  function setPoster() {
    if (!life) return;
    /** @type {HTMLImageElement} */
    const poster = find('poster');
    showPoster(element.poster !== '' && find('canvas').dataset.draws === undefined);
    if (element.poster) poster.src = element.poster;
    else poster.removeAttribute('src');
  }

  /** Behind a poster the content is there for who cannot see it. @param {boolean} on */
  function showPoster(on) {
    find('poster').hidden = !on;
    find('fallback').classList.toggle('sr', on);
  }

  function show() {
    if (isShown || !life) return;
    isShown = true;
    start();
    make(life.signal, workbench);
  }

  /** @param {AbortSignal} signal @param {typeof workbench} made */
  async function make(signal, { resolve, reject }) {
    try {
      // After all scripts that came together: one of them may have it.
      await null;
      if (signal.aborted) return;
      const { createWorkbench } = await loaded({ say: linkage.say, signal }, 'The view', () => pieces.workbench());
      find('bench').classList.remove('waiting');
      const { keys, interaction, panels } = wishes();
      const app = await createWorkbench(linkage, { root, keys: keys === 'page' ? element.ownerDocument : root, interaction, panels, signal });
      // Who waits goes on waiting for the one that takes its place.
      if (signal.aborted) return;
      isMade = true;
      resolve(app);
    } catch (error) {
      if (signal.aborted) return;
      isMade = true;
      complain(error);
      reject(error);
    }
  }

  function dismantle() {
    // With a reason of its own: the default one is an error, whose stack would hold on to the element.
    life?.abort('taken out');
    life = null;
    linkage.player.seen = false;
    linkage.player.draw = () => {};
    root.replaceChildren();
    if (isMade) workbench = withResolvers();
    isShown = isMade = false;
  }

  return {
    /** Whether the element is in a page. */
    get isInPage() {
      return life !== null;
    },
    /** The workbench, once it is made. @returns {Promise<AppWithPanels>} */
    get workbench() {
      return workbench.promise;
    },
    build,
    setPoster,
    show,
    dismantle,
    /** Makes it anew, by what the attributes ask for now. */
    rebuild() {
      if (!life) return;
      const wasShown = isShown;
      dismantle();
      build();
      if (wasShown) show();
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

/** What is printed of an element that was never loaded and has no content. @param {HTMLElement} element */
function lineFor(element) {
  const isContent = (/** @type {ChildNode} */ node) => (node instanceof Element ? !node.matches('script, style, template') : node instanceof Text && /\S/.test(node.data));
  if ([...element.childNodes].some(isContent)) return '';
  return ['Linkage', element.getAttribute('type') ?? element.getAttribute('src')].filter(Boolean).join(' ');
}

/**
 * Parts of the page that are loaded when they are first needed, so that the page opens without them. Where one cannot be
 * loaded that is said, with a button that tries again: no failed load is kept.
 */
import { element, windowOf } from './dom.js';

/** @param {string} what such as "The charts" @param {unknown} error */
const failure = (what, error) => `${what} could not be loaded (${error instanceof Error ? error.message : error}).`;

/**
 * Loads a part and goes on with it, or says that it cannot be loaded. Where the page was left meanwhile nothing is done.
 * @template T
 * @param {{say: import('./notice.js').Say, signal?: AbortSignal}} app
 * @param {string} what stands in the message if it cannot: "The gallery"
 * @param {() => Promise<T>} load
 * @param {(part: T) => unknown} go what is done with it; what goes wrong there is its own matter
 * @returns {Promise<boolean>} whether it was loaded
 */
export async function withPart({ say, signal }, what, load, go) {
  let part;
  try {
    part = await load();
  } catch (error) {
    const again = () => withPart({ say, signal }, what, load, go);
    say(failure(what, error), { label: 'Try again', act: again, stays: true });
    return false;
  }
  if (signal?.aborted) return false;
  await go(part);
  return true;
}

/**
 * The same for what nothing can be done without: resolves when it is loaded, however often that is tried.
 * @template T @param {{say: import('./notice.js').Say, signal?: AbortSignal}} app @param {string} what @param {() => Promise<T>} load @returns {Promise<T>}
 */
export const loaded = (app, what, load) => new Promise((resolve) => withPart(app, what, load, resolve));

/**
 * Says in a panel's place why it is not there, with a button that tries again.
 * @param {HTMLElement} panel @param {string} what such as "The charts" @param {string} why a sentence @param {() => unknown} attempt
 */
export function notLoaded(panel, what, why, attempt) {
  const again = () => {
    // The button goes; the focus stays in its panel.
    panel.tabIndex = -1;
    panel.focus();
    panel.textContent = `${what}: loading …`;
    attempt();
  };
  panel.replaceChildren(element('p', { class: 'not-loaded', role: 'alert' }, why, ' ', element('button', { class: 'link', click: again }, 'Try again')));
}

/**
 * @param {HTMLElement} panel fills itself when it first comes into view
 * @param {string} what stands in the message if it cannot: "The charts"
 * @param {() => Promise<unknown>} load
 */
export function whenSeen(panel, what, load) {
  const attempt = () =>
    load().catch((error) => notLoaded(panel, what, failure(what, error), attempt));
  const { IntersectionObserver } = windowOf(panel);
  const observer = new IntersectionObserver((entries) => {
    if (!entries.some((entry) => entry.isIntersecting)) return;
    observer.disconnect();
    attempt();
  });
  observer.observe(panel);
}

/** How far out of the window something counts as seen, in pixels: it is ready when it scrolls in. */
const MARGIN = 120;

/**
 * Tells whether an element is in view, at once and whenever that changes.
 * @param {HTMLElement} element @param {AbortSignal} signal ends it @param {(seen: boolean) => void} tell
 */
export function whileSeen(element, signal, tell) {
  const { top, bottom, height } = element.getBoundingClientRect();
  const { innerHeight, IntersectionObserver } = windowOf(element);
  // Without waiting for the first picture, which the observer would.
  let seen = height > 0 && bottom > -MARGIN && top < innerHeight + MARGIN;
  tell(seen);
  const observer = new IntersectionObserver(
    (entries) => {
      const now = entries[entries.length - 1].isIntersecting;
      if (now !== seen) tell((seen = now));
    },
    { rootMargin: `${MARGIN}px` },
  );
  observer.observe(element);
  signal.addEventListener('abort', () => observer.disconnect());
}

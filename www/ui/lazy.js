/**
 * Parts that are loaded when they are first seen, so that the page opens without them.
 */

/**
 * @param {HTMLElement} panel fills itself when it first comes into view
 * @param {string} what stands in the message if it cannot: "The charts"
 * @param {() => Promise<unknown>} load
 */
export function whenSeen(panel, what, load) {
  const observer = new IntersectionObserver((entries) => {
    if (!entries.some((entry) => entry.isIntersecting)) return;
    observer.disconnect();
    load().catch((error) => {
      panel.textContent = `${what} could not be loaded (${error instanceof Error ? error.message : error}). Reload the page to try again.`;
    });
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

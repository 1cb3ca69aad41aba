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

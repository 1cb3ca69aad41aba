/**
 * Keeps what floats beside a cell at its cell while anything scrolls or the window changes.
 */

/**
 * @param {HTMLElement} part what floats
 * @param {() => void} place puts it to its cell
 */
export function floating(part, place) {
  /** @type {AbortController | null} */
  let life = null;
  const end = () => {
    life?.abort();
    life = null;
  };
  const follow = () => (part.isConnected ? place() : end());
  return {
    begin() {
      if (life) return;
      life = new AbortController();
      // What scrolls inside a shadow tree is not told outside of it.
      for (const target of [part.getRootNode(), window]) {
        for (const name of ['scroll', 'resize']) target.addEventListener(name, follow, { capture: true, signal: life.signal });
      }
    },
    end,
  };
}

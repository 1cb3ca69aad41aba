/**
 * What the browser remembers of the layout: the dock's height, and what a person folded or unfolded.
 *
 * @typedef {{height?: number, open?: boolean, tables?: boolean, info?: boolean, legend?: boolean, search?: boolean}} Layout height of the dock in pixels; true: not folded, `open` of the dock;
 *   `search` false: no better motion is looked for by itself
 */

const KEY = 'synthetica.dock';

/** Of what is kept, what can be used. @returns {Layout} */
export function recall() {
  try {
    const kept = JSON.parse(localStorage.getItem(KEY) ?? '{}');
    return Object.fromEntries(Object.entries(kept).filter(([name, value]) => typeof value === (name === 'height' ? 'number' : 'boolean')));
  } catch {
    // Storage may be forbidden, or hold something else.
    return {};
  }
}

/** @param {Layout} change */
export function remember(change) {
  try {
    localStorage.setItem(KEY, JSON.stringify({ ...recall(), ...change }));
  } catch {
    // Then all opens as it does for the first time.
  }
}

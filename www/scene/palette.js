/**
 * The scene's colours, read from the style sheet so that the schemes have one home.
 */
import { Color } from 'three';

const NAMES = /** @type {const} */ ([
  'metal', 'dark-metal', 'workpiece', 'ground', 'grid', 'goal', 'closest', 'gap', 'gap-0', 'gap-1', 'gap-2',
  'accent', 'chain-0', 'chain-1', 'chain-2', 'chain-3', 'chain-4', 'axis-x', 'axis-y', 'axis-z',
]);

/** @typedef {Record<typeof NAMES[number], Color>} Palette */

/** @param {Element} element @returns {Palette} */
export function readPalette(element) {
  const style = getComputedStyle(element);
  return /** @type {Palette} */ (
    Object.fromEntries(NAMES.map((name) => [name, new Color(style.getPropertyValue(`--scene-${name}`).trim() || '#888')]))
  );
}

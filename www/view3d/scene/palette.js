/**
 * The scene's colours, read from the style sheet so that the schemes have one home.
 */
import { Color } from 'three';

const NAMES = /** @type {const} */ ([
  'metal', 'dark-metal', 'workpiece', 'ground', 'grid', 'goal', 'closest', 'gap', 'gap-0', 'gap-1', 'gap-2',
  'accent', 'chain-0', 'chain-1', 'chain-2', 'chain-3', 'chain-4', 'axis-x', 'axis-y', 'axis-z',
]);

/** @typedef {Record<typeof NAMES[number], Color>} Palette */

/**
 * As they are beside an element: a colour may depend on the scheme there, so that only a used one tells what it is.
 * @param {Element} element @returns {Palette}
 */
export function readPalette(element) {
  const probe = document.createElement('i');
  probe.hidden = true;
  // Forced colours would make them all one.
  probe.style.forcedColorAdjust = 'none';
  element.after(probe);
  const style = getComputedStyle(probe);
  const colours = NAMES.map((name) => {
    probe.style.color = `var(--scene-${name}, #888)`;
    return [name, new Color(style.color)];
  });
  probe.remove();
  return /** @type {Palette} */ (Object.fromEntries(colours));
}

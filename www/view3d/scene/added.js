/**
 * What other files add to the scene, which is pictured, pointed at and named as the linkage is; and what the legend says of it.
 *
 * @typedef {{group: import('three').Group, names: () => import('./labels.js').Label[], paint: (palette: import('./palette.js').Palette) => void,
 *   pose?: (what: import('../../core/poses.js').Shown) => void}} Part `pose` puts it to a frame, also of a film, which the playhead is not at
 */

/** @param {(part: Part) => void} take a new one @param {() => void} changed */
export function createAdded(take, changed) {
  /** @type {Part[]} */
  const parts = [];
  /** For the legend, of each part: each begins with its sign. @type {Map<Part, string[]>} */
  const notes = new Map();
  /** @type {Set<() => void>} */
  const noted = new Set();
  return {
    names: () => parts.flatMap((part) => part.names()),
    /** @param {import('./palette.js').Palette} palette */
    paint(palette) {
      for (const part of parts) part.paint(palette);
    },
    /** @param {import('../../core/poses.js').Shown} what */
    pose(what) {
      for (const part of parts) part.pose?.(what);
    },
    get notes() {
      return [...notes.values()].flat();
    },
    /** Called when the notes are others. */
    noted,
    /**
     * @param {Part} part
     * @returns {(notes: string[]) => void} tells that it is another now, and what the legend says of it
     */
    add(part) {
      parts.push(part);
      take(part);
      return (next) => {
        notes.set(part, next);
        changed();
        for (const tell of noted) tell();
      };
    },
  };
}

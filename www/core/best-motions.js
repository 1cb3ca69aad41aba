/**
 * The motions that were found by the search for the best one: shown like any other, and not what the planner plans by itself.
 * What is known of each: what writes it for other programs, how often it changes its branch while a frame stands, what
 * it is called in a file's name, and words that say that it is shown.
 *
 * @typedef {{name: 'best' | 'calmer', words: string, write: (format: import('./types.js').ExportFormat, options: import('./types.js').ExportOptions) => Promise<string>, switches: number}} BestMotion
 * @type {WeakMap<import('./types.js').Motion, BestMotion>}
 */
export const bestMotions = new WeakMap();

/** Of a followed motion the one that is shown beside it as a ghost, which files of text do not have. @type {WeakMap<import('./types.js').Motion, import('./types.js').Motion>} */
export const ghosts = new WeakMap();

/** That files are of the followed motion alone, where a ghost stands beside it. @param {import('./types.js').Motion | null} motion */
export function withoutGhost(motion) {
  const ghost = motion && ghosts.get(motion);
  return ghost ? `It has the followed motion, not the ${nameOf(ghost)} one beside it` : '';
}

/** What the motion beside the followed one is called wherever it is named; 'best' until there is one. @param {import('./types.js').Motion | null} motion */
export const nameOf = (motion) => (motion && bestMotions.get(motion)?.name) ?? 'best';

/** What the light motion in the view is called: a calmer one gives up closeness. @param {import('./types.js').Motion | null} motion */
export const closestName = (motion) => `${(motion && bestMotions.get(motion)?.name) ?? 'closest'} motion`;

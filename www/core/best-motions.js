/**
 * The motions that were found by the search for the best one: shown like any other, and not what the planner plans by itself.
 * What is known of each: what writes it for other programs, how often it changes its branch while a frame stands, what
 * it is called in a file's name, and words that say that it is shown.
 *
 * @typedef {{name: 'best' | 'calmer', words: string, write: (format: import('./types.js').ExportFormat, options: import('./types.js').ExportOptions) => Promise<string>, switches: number}} BestMotion
 * @type {WeakMap<import('./types.js').Motion, BestMotion>}
 */
export const bestMotions = new WeakMap();

/** What the motion beside the followed one is called wherever it is named; 'best' until there is one. @param {import('./types.js').Motion | null} motion */
export const nameOf = (motion) => (motion && bestMotions.get(motion)?.name) ?? 'best';

/**
 * Dialogs that are opened from the tables, loaded when they are asked for: a frame's turn in other forms, copies of a
 * chain around an axis, and key frames from a table.
 */

/**
 * @param {HTMLElement} root holds the tables
 * @param {import('../../core/store.js').Store} store
 * @param {import('../../ui/notice.js').Say} say
 * @param {import('./pose-table-form.js').ReadPoses} readPoses asks the planner
 * @param {(doc: import('../../core/types.js').MechanismDocument) => Promise<import('../../core/types.js').Fault | null>} check likewise
 * @param {(path: string) => string} label of a cell, in words
 */
export function createForms(root, store, say, readPoses, check, label) {
  /** @param {string} what @param {() => Promise<void>} open */
  const asked = (what, open) => {
    open().catch((error) => say(`${what} could not be opened (${error instanceof Error ? error.message : error}). Try again.`));
  };
  return {
    /** @param {string} path of a frame @param {string} name "key frame 2", "base frame of chain 1" */
    turn: (path, name) => asked(`The turn of ${name}`, async () => (await import('./turn-form.js')).openTurnForm(root, store, path, name)),
    poseTable: () => asked('The key frames from a table', async () => (await import('./pose-table-form.js')).openPoseTable(root, { store, say }, readPoses)),
    /** @param {string} path of a cell */
    parameter: (path) => asked('The form for a parameter', async () => (await import('./parameter-form.js')).openParameterForm(root, { store, say }, check, path, label)),
    /** @param {number} chain */
    copies: (chain) => asked('The copies around an axis', async () => (await import('./copies-form.js')).openCopiesForm(root, store, chain)),
  };
}

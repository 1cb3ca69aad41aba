/**
 * Dialogs that are opened from the tables, loaded when they are asked for: a frame's turn in other forms, copies of a
 * chain around an axis, the convention of its table, the other unit of angles, a chain by its axes or by its rows, and
 * key frames from a table; and what a motion with driven joints needs, loaded in the same way.
 *
 * @typedef {(text: string, chain: number) => Promise<import('../../core/ask.js').Outcome<string>>} Rewrite gives a chain by its axes
 * @typedef {ReturnType<typeof createForms>} Forms
 */

/**
 * @param {HTMLElement} root holds the tables
 * @param {import('../../core/store.js').Store} store
 * @param {import('../../ui/notice.js').Say} say
 * @param {import('./pose-table-form.js').ReadPoses} readPoses asks the planner
 * @param {(doc: import('../../core/types.js').MechanismDocument) => Promise<import('../../core/types.js').Fault | null>} check likewise
 * @param {(path: string) => string} label of a cell, in words
 * @param {Rewrite} rewrite
 */
export function createForms(root, store, say, readPoses, check, label, rewrite) {
  /** @param {string} what @param {() => Promise<void>} open */
  const asked = (what, open) =>
    open().catch((error) => say(`${what} could not be opened (${error instanceof Error ? error.message : error}). Try again.`));
  return {
    /** @param {string} path of a frame @param {string} name "key frame 2", "base frame of chain 1" */
    turn: (path, name) => asked(`The turn of ${name}`, async () => (await import('./turn-form.js')).openTurnForm(root, store, path, name)),
    poseTable: () => asked('The key frames from a table', async () => (await import('./pose-table-form.js')).openPoseTable(root, { store, say }, readPoses)),
    /** @param {string} path of a cell */
    parameter: (path) => asked('The form for a parameter', async () => (await import('./parameter-form.js')).openParameterForm(root, { store, say }, check, path, label)),
    /** @param {number} chain */
    convention: (chain) => asked('The convention of the table', async () => (await import('./convention-form.js')).openConventionForm(root, store, say, chain)),
    /** @param {import('../../core/angle-unit.js').AngleUnit} unit */
    angles: (unit) => asked('The unit of angles', async () => (await import('./angles-form.js')).openAnglesForm(root, store, unit)),
    /** @param {number} chain */
    rows: (chain) => asked('The rows', async () => (await import('./rows-form.js')).openRowsForm(root, store, chain)),
    /** @param {number} chain */
    byAxes: (chain) => asked('The axes', async () => (await import('./rewriting.js')).giveByAxes({ store, say, rewrite }, chain)),
    /** @param {number} chain */
    intoRows: (chain) => asked('The rows', async () => (await import('./rewriting.js')).turnIntoRows({ store, say }, chain)),
    /** @param {number} chain */
    copies: (chain) => asked('The copies around an axis', async () => (await import('./copies-form.js')).openCopiesForm(root, store, chain)),
    /** The motion by driven joints, or by key frames. @param {boolean} driven */
    drive: (driven) => asked('Driven joints', async () => (await import('../../core/driver-edits.js'))[driven ? 'goToDrivers' : 'goToKeyFrames']({ store, say })),
    /** One joint variable is driven. @param {import('../../core/driver-edits.js').Place} place */
    driveJoint: (place) => asked('Driven joints', async () => (await import('../../core/driver-edits.js')).driveJoint({ store, say }, place)),
    /** @param {ReturnType<typeof import('./cells.js').createCells>} cells @param {(table: () => unknown) => void} made */
    driverTable: (cells, made) => asked('The table of driven joints', async () => made((await import('./driver-table.js')).createDriverTable(root, store, cells))),
  };
}

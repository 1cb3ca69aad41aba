/**
 * What tells the faults of the document beside their cells, loaded when there is one.
 */
export { allFaults } from './all-faults.js';
export { createFaultNote } from './fault-note.js';

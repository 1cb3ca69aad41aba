/**
 * Which rows of a long table are shown: a page of them, turned by hand, and to what is selected or at fault.
 */

/** Rows of a page, some two screens of them: a browser lays all of them out at every edit. A table with no more is shown whole. */
export const PAGE = 20;

/** @param {number} rows @param {number} wanted a row @returns {number} the first row of the page with that row */
export const pageWith = (rows, wanted) => (rows <= PAGE ? 0 : Math.min(Math.max(0, Math.floor(wanted / PAGE) * PAGE), Math.floor((rows - 1) / PAGE) * PAGE));

/** The key frame that a place of the document is in; −1 for none. @param {string} path */
export const keyFrameIn = (path) => Number(/^motion\.key_frames\[(\d+)]/.exec(path)?.[1] ?? -1);

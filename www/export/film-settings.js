/**
 * What all films have in common, however they are made.
 *
 * @typedef {object} Shot what is filmed
 * @property {HTMLCanvasElement} canvas
 * @property {number} seconds how long the film is
 * @property {(share: number) => void} draw draws the picture at a share of the motion, from 0 to 1
 * @property {() => boolean} stopped whether it was cancelled
 */

/** Pictures a second. */
export const RATE = 30;
/** Bits a second: no blocks in even surfaces. */
export const BITS = 8_000_000;
/** Pixels across at most: more is beyond what browsers encode in a bearable time. */
export const WIDEST = 1280;

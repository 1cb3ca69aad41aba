// What the page may cost: the one home of the limits that the measurements beside this file print and that tests keep.

export const LIMITS = {
  /** Bytes after gzip of all that is fetched until the network is idle, without input, preloads counted. */
  firstLoad: 300_000,
  /** Of these, the planner's wasm. */
  firstWasm: 110_000,
  /** ms from the navigation's start until the linkage has moved and been drawn, median. */
  firstFrame: 700,
  /** ms of script of a pointer move, 95 % of them, on a page whose thread is four times slower. */
  move: { 'key frame': 16, workpiece: 12 },
  /** Script of an edit with many key frames, as a multiple of the same with three. */
  edit: 3,
  /** ms of the search for the best motion of a sample, median. */
  best: 1000,
  /** A plan while a search runs, as a multiple of its own time. */
  planBeside: 1.2,
  /**
   * What a round of use may leave behind, when all garbage is collected. Listeners: none. Nodes: a text for each typed number,
   * four in a round, which the browser's own undo of fields keeps. Bytes of the heap: a round makes some 30 steps of undo, each a document and its text, and 500 are kept.
   */
  use: { heap: 500_000, nodes: 8, listeners: 0.5 },
  /** The canvas's least share of the window, by the window's size. */
  canvas: [
    { width: 1440, height: 900, share: 0.5 },
    { width: 1280, height: 720, share: 0.45 },
  ],
};

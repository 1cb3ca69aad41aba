/**
 * The camera's way from one look to another, which takes a moment.
 *
 * @typedef {import('./camera.js').Look} Look
 */

/** Milliseconds of the whole way. */
const WHOLE = 220;

/** @param {number} from @param {number} to @param {number} share */
const between = (from, to, share) => from + (to - from) * share;

export function createGlide() {
  /** @type {{from: Look, to: Look, since: number} | null} */
  let way = null;
  return {
    /** Where it goes; undefined while it rests. */
    get to() {
      return way?.to;
    },
    /** @param {Look} from @param {Look} to */
    begin(from, to) {
      // The short way around.
      const around = to.around - 2 * Math.PI * Math.round((to.around - from.around) / (2 * Math.PI));
      way = { from, to: { ...to, around }, since: performance.now() };
    },
    stop() {
      way = null;
    },
    /** Where it is by now; null while it rests. @returns {Look | null} */
    step() {
      if (!way) return null;
      const share = Math.min(1, (performance.now() - way.since) / WHOLE);
      const soft = share * share * (3 - 2 * share);
      const { from, to } = way;
      if (share === 1) way = null;
      return {
        around: between(from.around, to.around, soft),
        down: between(from.down, to.down, soft),
        reach: between(from.reach, to.reach, soft),
        target: from.target.clone().lerp(to.target, soft),
        right: between(from.right, to.right, soft),
        low: between(from.low, to.low, soft),
      };
    },
  };
}

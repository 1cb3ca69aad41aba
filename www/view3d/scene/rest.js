/**
 * How much a picture may cost: where pictures are computed without a graphics card, shadows and smooth edges take as long as all else,
 * so that they wait until nothing moves and no pointer is down.
 */

/** The rest in milliseconds after which the picture is drawn once more, with all of it. */
const REST = 250;

/** @param {boolean} slow whether it waits @param {() => void} changed draws once more @param {() => boolean} isHeld whether a pointer is down */
export function createRest(slow, changed, isHeld) {
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let rest;
  let resting = false;
  function settle() {
    // What it holds it may move on.
    if (isHeld()) {
      rest = setTimeout(settle, REST);
      return;
    }
    resting = true;
    changed();
  }
  return {
    /** Called at every draw. @returns {boolean} whether this picture has shadows and smooth edges */
    next() {
      if (!slow) return true;
      const fine = resting;
      clearTimeout(rest);
      if (!fine) rest = setTimeout(settle, REST);
      resting = false;
      return fine;
    },
  };
}

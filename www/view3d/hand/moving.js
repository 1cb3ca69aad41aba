/**
 * Tells the view that a hand moves something, until it rests or lets go: what is only read waits for that (core/at-rest.js).
 */

/** After how long without a move a hand rests, in milliseconds. */
const REST = 500;

/**
 * @param {Pick<import('../../element/workbench.js').App, 'store' | 'signal'>} app
 * @param {() => void} rested
 */
export function createMoving({ store, signal }, rested) {
  /** One timer for many moves. @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;
  let last = 0;

  function look() {
    const left = last + REST - performance.now();
    if (left <= 0) return calm();
    timer = setTimeout(look, left);
  }

  /** It has let go, or rests. */
  function calm() {
    clearTimeout(timer);
    timer = undefined;
    if (!store.view.moving) return;
    store.setView({ moving: '' });
    rested();
  }
  signal.addEventListener('abort', calm);

  return {
    /** Before every move. @param {string} place of what is moved */
    stir(place) {
      store.setView({ moving: place });
      last = performance.now();
      timer ??= setTimeout(look, REST);
    },
    calm,
  };
}

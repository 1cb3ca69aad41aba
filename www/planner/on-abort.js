/**
 * Listens to a signal of which many questions want to know, with one listener for all: Node warns of more than ten. The
 * listener goes with the last of them, since a signal that lives long would hold on to every question and its answer.
 */

/** @type {WeakMap<AbortSignal, {calls: Set<() => void>, run: () => void}>} */
const heard = new WeakMap();

/** @param {AbortSignal} signal @param {() => void} call @returns {() => void} ends it */
export function onAbort(signal, call) {
  let one = heard.get(signal);
  if (!one) {
    const calls = new Set();
    one = { calls, run: () => [...calls].forEach((each) => each()) };
    heard.set(signal, one);
    signal.addEventListener('abort', one.run);
  }
  const { calls, run } = one;
  // Two questions may pass the same function.
  const own = () => call();
  calls.add(own);
  return () => {
    calls.delete(own);
    if (calls.size > 0 || heard.get(signal)?.calls !== calls) return;
    heard.delete(signal);
    signal.removeEventListener('abort', run);
  };
}

/**
 * Notices that a worker has ended, of which no event tells: a browser may end it, and it may close itself. Where there are
 * Web Locks, which are only in a secure context with an origin, this is known at once: the worker holds a lock while it
 * lives. Elsewhere a question that is not heard tells it. A worker whose code is loaded says of each question at once
 * that it has heard it, long before the wasm is loaded, unless it computes another one.
 *
 * @typedef {import('./calls.js').Message} Message
 * @typedef {import('./calls.js').Answer} Answer
 */

/** How long a worker that computes nothing may leave a question unheard, in milliseconds. */
const SILENCE = 1500;

/** The same for one that plans in portions: a portion is 30 ms, its last step on a slow machine some seconds. */
const SILENCE_IN_PORTIONS = 10_000;

/** A timer that is later than this, in milliseconds, was held up with the page, as what the worker said meanwhile was. */
const LATE = 500;

/** @param {() => void} ended called once at most */
export function createWatch(ended) {
  const over = new AbortController();
  let byLock = false;
  /** Whether the worker has said anything: before, its code may take as long to load as it takes. */
  let speaks = false;
  /**
   * The last that was said of each question that has no answer yet; `stop` where a plan in portions was asked to stop.
   * @type {Map<number, '' | 'heard' | 'begun' | 'progress' | 'stop'>}
   */
  const said = new Map();
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;

  function end() {
    over.abort();
    clearTimeout(timer);
  }

  function endedByItself() {
    if (over.signal.aborted) return;
    end();
    ended();
  }

  function listen() {
    clearTimeout(timer);
    const all = [...said.values()];
    // What has begun and is not made in portions may take as long as it takes.
    if (over.signal.aborted || byLock || !speaks || all.includes('begun') || !(all.includes('') || all.includes('stop'))) return;
    const silence = all.includes('progress') || all.includes('stop') ? SILENCE_IN_PORTIONS : SILENCE;
    const due = performance.now() + silence;
    timer = setTimeout(() => (performance.now() > due + LATE ? listen() : endedByItself()), silence);
  }

  return {
    /** @param {Message} message to the worker */
    posted(message) {
      // What is taken back is answered at once too.
      if (message.kind === 'ask' || (message.kind === 'cancel' && said.get(message.id) === 'heard')) said.set(message.id, '');
      // A person who asks for what there is so far would else wait for ever.
      if (message.kind === 'stop' && said.get(message.id) === 'progress') said.set(message.id, 'stop');
      listen();
    },
    /** @param {Answer} answer from the worker */
    received({ id, kind }) {
      speaks = true;
      if (kind === 'heard' || kind === 'begun' || kind === 'progress') said.set(id, kind);
      else said.delete(id);
      listen();
    },
    /** @param {string} lock the worker holds it now: who gets it next knows that the worker has ended */
    holds(lock) {
      byLock = true;
      listen();
      navigator.locks.request(lock, { signal: over.signal }, endedByItself).catch(() => {
        // Not watched any more, or the page may not have locks: then the silence tells it.
        byLock = false;
      });
    },
    end,
  };
}

/**
 * Notices that a worker has ended, for which there is no event: a browser may end it, and it may close itself. Where there
 * are Web Locks, which are only in a secure context with an origin, this is known at once: the worker holds a lock while it
 * lives. Elsewhere it is known by a question that is not acknowledged. A worker whose code is loaded answers each question
 * at once with `received`, long before the wasm is loaded, unless it computes another one.
 *
 * @typedef {import('./calls.js').Message} Message
 * @typedef {import('./calls.js').Answer} Answer
 */

/** How long a worker that computes nothing may take to acknowledge a question, in milliseconds. */
const SILENCE = 1500;

/** The same for one that plans in portions: a portion is 30 ms, but one frame's search for other positions takes seconds on a slow machine. */
const SILENCE_IN_PORTIONS = 10_000;

/** A timer that is later than this, in milliseconds, was held up with the page, and with it the worker's messages. */
const LATE = 500;

/** @param {() => void} ended called once at most */
export function createWatch(ended) {
  const over = new AbortController();
  let byLock = false;
  /** Whether the worker has sent a message: before that its code is being loaded, for which there is no limit. */
  let started = false;
  /**
   * The last message about each question that has no answer yet, '' for none; `stop` where a plan in portions was asked to stop.
   * @type {Map<number, '' | 'received' | 'begun' | 'progress' | 'stop'>}
   */
  const latest = new Map();
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
    const all = [...latest.values()];
    // What has begun and is not made in portions may take as long as it takes.
    if (over.signal.aborted || byLock || !started || all.includes('begun') || !(all.includes('') || all.includes('stop'))) return;
    const silence = all.includes('progress') || all.includes('stop') ? SILENCE_IN_PORTIONS : SILENCE;
    const due = performance.now() + silence;
    timer = setTimeout(() => (performance.now() > due + LATE ? listen() : endedByItself()), silence);
  }

  return {
    /** @param {Message} message to the worker */
    posted(message) {
      // What is taken back is answered at once too.
      if (message.kind === 'ask' || (message.kind === 'cancel' && latest.get(message.id) === 'received')) latest.set(message.id, '');
      // A person who asks for what there is so far would else wait for ever.
      if (message.kind === 'stop' && latest.get(message.id) === 'progress') latest.set(message.id, 'stop');
      listen();
    },
    /** @param {Answer} answer from the worker */
    received({ id, kind }) {
      started = true;
      if (kind === 'received' || kind === 'begun' || kind === 'progress') latest.set(id, kind);
      else latest.delete(id);
      listen();
    },
    /** @param {string} lock the worker holds it now; it is granted here when the worker has ended */
    holds(lock) {
      byLock = true;
      listen();
      navigator.locks.request(lock, { signal: over.signal }, endedByItself).catch(() => {
        // Not watched any more, or the page may not have locks: then the missing acknowledgements tell it.
        byLock = false;
      });
    },
    end,
  };
}

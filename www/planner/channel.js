/**
 * The channel over which questions are answered: to a worker, or, where the page cannot have one, within the page itself.
 *
 * `isMakeshift` where the page itself answers though a worker may yet start: when no question is open, another channel
 * should be opened.
 * @typedef {import('./calls.js').Message} Message
 * @typedef {import('./calls.js').Answer} Answer
 * @typedef {{post: (message: Message) => void, close: () => void}} Line
 * @typedef {Line & {isMakeshift: () => boolean}} Channel
 */
import { loading } from './loading.js';
import { startWorker } from './start-worker.js';
import { createWatch } from './watch.js';

/** So many workers in a row must fail to start, with the page itself able to load the planner, before they count as forbidden. */
const TRIES = 2;
let failed = 0;

/**
 * @param {(answer: Answer) => void} receive
 * @param {(reason: string) => void} fail the worker has ended
 * @returns {Channel}
 */
export function openChannel(receive, fail) {
  let works = false;
  let makeshift = false;
  /** What was posted before the worker's first message. @type {Message[]} */
  let first = [];
  /** @type {Line} */
  let line;
  const started = () => {
    works = true;
    first = [];
    failed = 0;
  };
  /** A worker that ends before its first message was forbidden (by a content policy, in a sandbox) or could not be loaded. */
  const end = (/** @type {string} */ reason) => {
    if (works) return fail(reason);
    works = makeshift = true;
    let loads = false;
    line = openHere((answer) => {
      if (answer.kind === 'begun' && !loads) {
        loads = true;
        failed += 1;
      }
      receive(answer);
    });
    for (const message of first) line.post(message);
    first = [];
  };
  try {
    line = openWorker({ started, receive, fail: end });
  } catch {
    works = true;
    line = openHere(receive);
  }
  return {
    post(message) {
      line.post(message);
      if (!works) first.push(message);
    },
    close: () => line.close(),
    isMakeshift: () => makeshift && failed < TRIES,
  };
}

/** @param {{started: () => void, receive: (answer: Answer) => void, fail: (reason: string) => void}} to @returns {Line} */
function openWorker({ started, receive, fail }) {
  const worker = startWorker();
  const close = () => {
    watch.end();
    worker.terminate();
  };
  const watch = createWatch(() => {
    worker.terminate();
    fail('its worker was ended');
  });
  worker.onmessage = ({ data }) => {
    started();
    if (data.kind === 'holds') return watch.holds(data.lock);
    if (data.kind === 'loading') return loading.tell(data);
    watch.received(data);
    receive(data);
  };
  worker.onerror = (event) => {
    event.preventDefault();
    close();
    fail(event.message || 'the planner could not be loaded');
  };
  return {
    post(message) {
      worker.postMessage(message);
      watch.posted(message);
    },
    close,
  };
}

/** Without a worker the page plans by itself, and is held up for a portion at a time. @param {(answer: Answer) => void} receive @returns {Line} */
function openHere(receive) {
  let open = true;
  const calls = import('./calls.js').then(({ createAnswers }) => createAnswers((answer) => open && receive(answer)));
  return {
    post: (message) => {
      // Not the page's own objects, as a worker has none of them.
      const copy = structuredClone(message);
      calls.then(
        (answers) => open && answers.receive(copy),
        (error) => open && 'id' in message && receive({ id: message.id, kind: 'failure', message: String(error), loading: true }),
      );
    },
    close: () => {
      open = false;
    },
  };
}

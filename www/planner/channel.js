/**
 * The channel to what answers questions: a worker; where the page cannot have one, the page itself.
 *
 * @typedef {import('./calls.js').Message} Message
 * @typedef {import('./calls.js').Answer} Answer
 * @typedef {{post: (message: Message) => void, close: () => void}} Channel
 */
import { startWorker } from './start-worker.js';

/**
 * @param {(answer: Answer) => void} receive
 * @param {(reason: string) => void} fail the worker has ended
 * @returns {Channel}
 */
export function openChannel(receive, fail) {
  let works = false;
  /** What was posted before the first answer. @type {Message[]} */
  let first = [];
  /** @type {Channel} */
  let channel;
  /** A worker that ends before its first answer was forbidden (by a content policy, in a sandbox) or could not be loaded. */
  const end = (/** @type {string} */ reason) => {
    if (works) return fail(reason);
    works = true;
    channel = openHere(receive);
    for (const message of first) channel.post(message);
    first = [];
  };
  try {
    channel = openWorker((answer) => {
      works = true;
      first = [];
      receive(answer);
    }, end);
  } catch {
    works = true;
    channel = openHere(receive);
  }
  return {
    post(message) {
      channel.post(message);
      if (!works) first.push(message);
    },
    close: () => channel.close(),
  };
}

/** @param {(answer: Answer) => void} receive @param {(reason: string) => void} fail @returns {Channel} */
function openWorker(receive, fail) {
  const worker = startWorker();
  worker.onmessage = ({ data }) => receive(data);
  worker.onerror = (event) => {
    event.preventDefault();
    worker.terminate();
    fail(event.message || 'the planner could not be loaded');
  };
  return { post: (message) => worker.postMessage(message), close: () => worker.terminate() };
}

/** Without a worker the page plans by itself, and is held up for a portion at a time. @param {(answer: Answer) => void} receive @returns {Channel} */
function openHere(receive) {
  let open = true;
  const calls = import('./calls.js').then(({ createAnswers }) => createAnswers((answer) => open && receive(answer)));
  return {
    post: (message) => {
      // Not the page's own objects, as a worker has none of them.
      const copy = structuredClone(message);
      calls.then(
        (answers) => open && answers.receive(copy),
        (error) => open && 'id' in message && receive({ id: message.id, kind: 'failure', message: String(error) }),
      );
    },
    close: () => {
      open = false;
    },
  };
}

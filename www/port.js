/**
 * The way to the planner: a worker; where the page cannot have one, the page itself.
 *
 * @typedef {import('./planner.calls.js').Question} Question
 * @typedef {import('./planner.calls.js').Answer} Answer
 * @typedef {{post: (question: Question) => void, close: () => void}} Port
 */
import { startWorker } from './start-worker.js';

/**
 * @param {(answer: Answer) => void} receive
 * @param {(reason: string) => void} fail the worker has ended
 * @returns {Port}
 */
export function openPort(receive, fail) {
  let works = false;
  /** @type {Question | null} */
  let last = null;
  /** @type {Port} */
  let port;
  /** A worker that ends before its first answer was forbidden (by a content policy, in a sandbox) or could not be loaded. */
  const end = (/** @type {string} */ reason) => {
    if (works) return fail(reason);
    works = true;
    port = openHere(receive);
    if (last) port.post(last);
  };
  try {
    port = openWorker((answer) => {
      works = true;
      receive(answer);
    }, end);
  } catch {
    port = openHere(receive);
  }
  return {
    post(question) {
      last = question;
      port.post(question);
    },
    close: () => port.close(),
  };
}

/** @param {(answer: Answer) => void} receive @param {(reason: string) => void} fail @returns {Port} */
function openWorker(receive, fail) {
  const worker = startWorker();
  worker.onmessage = ({ data }) => receive(data);
  worker.onerror = (event) => {
    event.preventDefault();
    worker.terminate();
    fail(event.message || 'the planner could not be loaded');
  };
  return { post: (question) => worker.postMessage(question), close: () => worker.terminate() };
}

/** Without a worker a plan holds up the page for its milliseconds. @param {(answer: Answer) => void} receive @returns {Port} */
function openHere(receive) {
  const calls = import('./planner.calls.js');
  let open = true;
  return {
    async post(question) {
      /** @type {Answer} */
      let answer;
      try {
        answer = await (await calls).answer(question);
      } catch (error) {
        answer = { id: question.id, kind: 'failure', message: String(error) };
      }
      if (open) receive(answer);
    },
    close: () => {
      open = false;
    },
  };
}

/**
 * Starts a thread of Node's as the planner's worker, in the words of a browser's. It keeps the program going only while it
 * has a question to answer.
 */
import { availableParallelism } from 'node:os';
import { resolve } from 'node:path';
// By this name, and not as Worker: webpack takes that for a browser's, and writes what is none. It knows the module without `node:`.
import { Worker as Thread } from 'worker_threads';

/** A program may have as many as can run at once. */
export const atMost = availableParallelism;

/** After these nothing more is said of a question. */
const LAST = ['value', 'fault', 'failure', 'cancelled'];

/** The program's own flags are not for it: `--input-type` would end it. */
const OPTIONS = { execArgv: [], name: 'synthetica' };

/** @param {string} [address] of worker.node.js, where it was said */
export function startWorker(address) {
  const thread = address ? new Thread(fileOf(address), OPTIONS) : new Thread(new URL('./worker.node.js', import.meta.url), OPTIONS);
  thread.unref();
  /** Questions without an answer. */
  const open = new Set();
  let ended = false;
  const keep = () => (open.size > 0 ? thread.ref() : thread.unref());
  const end = (message) => {
    if (!ended) worker.onerror?.({ message, preventDefault() {} });
    ended = true;
  };
  const worker = {
    onmessage: null,
    onerror: null,
    postMessage(message) {
      if (message.kind === 'ask') open.add(message.id);
      // Nobody waits any more.
      if (message.kind === 'cancel') open.delete(message.id);
      keep();
      thread.postMessage(message);
    },
    terminate() {
      ended = true;
      thread.terminate();
    },
  };
  thread.on('message', (data) => {
    if (LAST.includes(data.kind)) open.delete(data.id);
    keep();
    if (!ended) worker.onmessage?.({ data });
  });
  thread.on('error', ({ message }) => end(message));
  thread.on('exit', () => end('its thread has ended'));
  return worker;
}

/** @param {string} address */
const fileOf = (address) => (address.startsWith('file:') ? new URL(address) : resolve(address));

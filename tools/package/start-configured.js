/**
 * Starts the planner's worker where the program said that it is, and tells it what wasm to load.
 */
import { atMost, startWorker as start } from 'started:worker';
import { configuration } from '../../www/planner/configuration.js';

export { atMost };

export function startWorker() {
  configuration.begun = true;
  const worker = start(configuration.worker);
  const { wasm } = configuration;
  if (wasm instanceof Promise) whenThere(worker, wasm);
  else if (wasm !== undefined) worker.postMessage({ kind: 'wasm', wasm });
  return worker;
}

/** Holds back its messages until the wasm is there. */
function whenThere(worker, wasm) {
  const post = worker.postMessage.bind(worker);
  let last = wasm.then((bytes) => post({ kind: 'wasm', wasm: bytes }));
  last.catch(({ message }) => worker.onerror?.({ message, preventDefault() {} }));
  worker.postMessage = (message) => {
    last = last.then(() => post(message));
    last.catch(() => {});
  };
}

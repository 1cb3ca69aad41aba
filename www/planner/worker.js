/**
 * The planner's worker: answers the messages that channel.js posts to it.
 */
import { createAnswers, load } from './calls.js';
import { counted } from './loading.js';

const { receive } = createAnswers((answer) => postMessage(answer, { transfer: answer.kind === 'value' ? buffers(answer.value) : [] }));

// Set at once: a message that arrives before the handler exists would be lost.
onmessage = ({ data }) => {
  receive(data);
};
holdLock();
// The first that is fetched is the wasm that every question needs; only the page's own build knows how large that is.
if (typeof FIRST_WASM_BYTES === 'number') {
  const { fetch } = self;
  self.fetch = async (...what) => {
    self.fetch = fetch;
    return counted(await fetch(...what), FIRST_WASM_BYTES, (message) => postMessage(message));
  };
}
load().catch(() => {
  // The first question is answered with the failure.
});

/** Holds a lock of its own while it lives: see watch.js. */
function holdLock() {
  const lock = `synthetica-planner-${Math.random()}`;
  navigator.locks
    ?.request(lock, () => {
      postMessage({ kind: 'holds', lock });
      return new Promise(() => {});
    })
    .catch(() => {
      // There are none without an origin, as in a sandbox.
    });
}

/** The typed columns' memory, which moves to the page instead of being copied. @param {unknown} value */
function buffers(value) {
  if (typeof value !== 'object' || value === null) return [];
  return Object.values(value)
    .filter((column) => ArrayBuffer.isView(column))
    .map((column) => column.buffer);
}

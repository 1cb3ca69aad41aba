/**
 * The planner's worker: answers the messages that channel.js posts to it.
 */
import { buffers } from './buffers.js';
import { createAnswers } from './calls.js';
import { counted } from './loading.js';
import { whole as wholePackage } from './packages.js';

const { receive } = createAnswers((answer) => postMessage(answer, { transfer: buffers(answer) }));

// Set at once: a message that arrives before the handler exists would be lost.
onmessage = ({ data }) => {
  receive(data);
};
holdLock();
// The first that is fetched is a wasm; only the page's own build knows how large both are.
if (typeof WASM_BYTES === 'object') {
  const { first, whole } = WASM_BYTES;
  const { fetch } = self;
  self.fetch = async (...what) => {
    self.fetch = fetch;
    const bytes = wholePackage.isBegun() ? whole : first;
    return counted(await fetch(...what), bytes, (message) => postMessage(message));
  };
}

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

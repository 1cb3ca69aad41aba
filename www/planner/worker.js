/**
 * The worker behind channel.js.
 */
import { createAnswers, load } from './calls.js';

const { receive } = createAnswers((answer) => postMessage(answer, { transfer: answer.kind === 'value' ? buffers(answer.value) : [] }));

// Set at once: a message that arrives before the handler exists would be lost.
onmessage = ({ data }) => {
  receive(data);
};
holdLock();
load().catch(() => {
  // The first question's answer tells it.
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

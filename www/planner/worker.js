/**
 * The worker behind channel.js.
 */
import { createAnswers, load } from './calls.js';

const { receive } = createAnswers((answer) => postMessage(answer, { transfer: answer.kind === 'value' ? buffers(answer.value) : [] }));

// Set at once: a message that arrives before the handler exists would be lost.
onmessage = ({ data }) => {
  receive(data);
};
load().catch(() => {
  // The first question's answer tells it.
});

/** The typed columns' memory, which moves to the page instead of being copied. @param {unknown} value */
function buffers(value) {
  if (typeof value !== 'object' || value === null) return [];
  return Object.values(value)
    .filter((column) => ArrayBuffer.isView(column))
    .map((column) => column.buffer);
}

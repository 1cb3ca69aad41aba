/**
 * The worker behind port.js: answers questions in order.
 */
import { answer, load } from './planner.calls.js';

// Set at once: a message that arrives before the handler exists would be lost.
onmessage = async ({ data }) => {
  const message = await answer(data);
  postMessage(message, { transfer: message.kind === 'value' ? buffers(message.value) : [] });
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

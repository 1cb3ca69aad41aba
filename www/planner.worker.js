/**
 * The worker behind planner.js: one request in, one answer out, in order.
 *
 * @typedef {{id: number, kind: 'value', value: unknown}
 *   | {id: number, kind: 'fault', fault: import('./types.js').Fault}
 *   | {id: number, kind: 'failure', message: string}} Answer
 * @typedef {'plan' | 'pull' | 'drive' | 'explain' | 'normalise' | 'find_start' | 'export_motion' | 'enumeration' | 'trace' | 'matrix' | 'defaults'} Call
 *   the functions of the package that the page asks for
 */
import init, { defaults, drive, enumeration, explain, export_motion, find_start, matrix, normalise, plan, pull, trace } from './pkg/synthetica.js';

/** @type {Record<Call, (...args: any[]) => unknown>} */
const calls = { plan, pull, drive, explain, normalise, find_start, export_motion, enumeration, trace, matrix, defaults };

// Set at once: a message that arrives before the handler exists would be lost.
const ready = init();
onmessage = async ({ data: { id, call, args } }) => {
  try {
    await ready;
    const value = calls[/** @type {Call} */ (call)](...args);
    answer({ id, kind: 'value', value });
  } catch (error) {
    if (isFault(error)) answer({ id, kind: 'fault', fault: error });
    else answer({ id, kind: 'failure', message: String(error) });
  }
};

/** @param {Answer} message */
function answer(message) {
  const columns = message.kind === 'value' ? buffers(message.value) : [];
  postMessage(message, { transfer: columns });
}

/** The typed columns' memory, which moves to the page instead of being copied. @param {unknown} value */
function buffers(value) {
  if (typeof value !== 'object' || value === null) return [];
  return Object.values(value)
    .filter((column) => ArrayBuffer.isView(column))
    .map((column) => column.buffer);
}

/** @param {unknown} error @returns {error is import('./types.js').Fault} */
const isFault = (error) => typeof error === 'object' && error !== null && !(error instanceof Error) && 'where' in error;

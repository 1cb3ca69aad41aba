/**
 * The worker behind planner.js: one request in, one answer out, in order.
 *
 * @typedef {{id: number, kind: 'value', value: unknown}
 *   | {id: number, kind: 'fault', fault: import('./types.js').Fault}
 *   | {id: number, kind: 'failure', message: string}} Answer
 * @typedef {keyof typeof first | 'drive' | 'export_motion' | 'enumeration' | 'trace' | 'matrix'} Call
 *   the functions of the package that the page asks for
 */
import init, { defaults, explain, find_start, normalise, plan, pull } from './pkg-first/synthetica.js';

/** What the page needs at once, from the smaller of the two packages. */
const first = { plan, pull, explain, normalise, find_start, defaults };

/** The whole package, loaded when something else is asked for. @type {Promise<typeof import('./pkg/synthetica.js')> | null} */
let whole = null;

async function loadWhole() {
  const module = await import('./pkg/synthetica.js');
  await module.default();
  return module;
}

// Set at once: a message that arrives before the handler exists would be lost.
const ready = init();
onmessage = async ({ data: { id, call, args } }) => {
  try {
    await ready;
    /** @type {Record<string, any>} */
    const functions = call in first ? first : await (whole ??= loadWhole());
    answer({ id, kind: 'value', value: functions[call](...args) });
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

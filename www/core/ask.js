/**
 * A question to the planner, whose end is one plain value: how it ended is read, not caught. Whatever else is thrown is a
 * mistake of ours, and goes on.
 *
 * @typedef {{is: 'fault', fault: import('./types.js').Fault, message: string}} Faulty the document is at fault, and a person
 *   can mend it
 * @typedef {{is: 'trouble', notLoaded: boolean, message: string}} Trouble the planner failed, or could not be loaded
 * @typedef {{is: 'late', message: ''}} Late a newer question took its place, or it was taken back: nothing is said
 */
import { DocumentFault, PlannerFailure, PlannerNotLoaded, Superseded } from '../planner/planner.js';
import { sentence } from './format.js';

/** @template T @typedef {{is: 'answer', value: T}} Answer */
/** @template T @typedef {Answer<T> | Faulty | Trouble | Late} Outcome */

/** @type {Late} */
export const LATE = { is: 'late', message: '' };

/**
 * @template T
 * @param {() => Promise<T>} call calls the planner
 * @param {string} doing what it is to do, as in "plan the motion", for the message if it fails
 * @returns {Promise<Outcome<T>>}
 */
export async function ask(call, doing) {
  try {
    return { is: 'answer', value: await call() };
  } catch (error) {
    if (error instanceof DocumentFault) return { is: 'fault', fault: error.fault, message: sentence(error.fault.message) };
    if (error instanceof Superseded || (error instanceof DOMException && error.name === 'AbortError')) return LATE;
    if (error instanceof PlannerNotLoaded) return { is: 'trouble', notLoaded: true, message: `The planner could not be loaded (${error.message}).` };
    if (error instanceof PlannerFailure) {
      return { is: 'trouble', notLoaded: false, message: `The planner failed to ${doing} and was started afresh (${error.message}).` };
    }
    throw error;
  }
}

/**
 * For what nothing can be done without: trouble is told over the view, and after "Try again" the question is asked again,
 * until it is answered.
 * @template {{is: string}} O
 * @param {import('./store.js').Store} store
 * @param {() => Promise<O>} question
 * @returns {Promise<Exclude<O, Trouble>>}
 */
export async function untilAnswered(store, question) {
  for (;;) {
    const outcome = /** @type {any} */ (await question());
    if (outcome.is !== 'trouble') return outcome;
    await troubleIsOver(store, outcome.message);
  }
}

/**
 * Tells trouble over the view, with "Try again". Whatever ends it, that button or a plan that was made, is for all who wait.
 * @param {import('./store.js').Store} store @param {string} message @returns {Promise<void>}
 */
export function troubleIsOver(store, message) {
  store.setResult({ trouble: message, again: true });
  return new Promise((resolve) => {
    const leave = store.subscribe('result', () => {
      if (store.result.trouble) return;
      leave();
      resolve();
    });
  });
}

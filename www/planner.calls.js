/**
 * The functions of the wasm packages by their names: one request in, one answer out.
 *
 * @typedef {{id: number, call: Call, args: unknown[]}} Question
 * @typedef {{id: number, kind: 'value', value: unknown}
 *   | {id: number, kind: 'fault', fault: import('./types.js').Fault}
 *   | {id: number, kind: 'failure', message: string}} Answer
 * @typedef {keyof typeof first | 'drive' | 'export_motion' | 'enumeration' | 'assemble' | 'trace' | 'matrix' | 'schema'
 *   | 'chain_by_index' | 'assembly_by_index'} Call the functions of the package that are asked for
 */
import init, { defaults, explain, find_start, normalise, plan, pull } from './pkg-first/synthetica.js';

/** What a page needs at once, from the smaller of the two packages. */
const first = { plan, pull, explain, normalise, find_start, defaults };

/** @type {ReturnType<typeof init> | null} */
let ready = null;

/** The whole package, loaded when something else is asked for. @type {Promise<typeof import('./pkg/synthetica.js')> | null} */
let whole = null;

async function loadWhole() {
  const module = await import('./pkg/synthetica.js');
  await module.default();
  return module;
}

/** Begins to load what every question needs. */
export const load = () => (ready ??= init());

/** @param {Question} question @returns {Promise<Answer>} */
export async function answer({ id, call, args }) {
  try {
    await load();
    /** @type {Record<string, any>} */
    const functions = call in first ? first : await (whole ??= loadWhole());
    return { id, kind: 'value', value: functions[call](...args) };
  } catch (error) {
    return isFault(error) ? { id, kind: 'fault', fault: error } : { id, kind: 'failure', message: String(error) };
  }
}

/** @param {unknown} error @returns {error is import('./types.js').Fault} */
const isFault = (error) => typeof error === 'object' && error !== null && !(error instanceof Error) && 'where' in error;

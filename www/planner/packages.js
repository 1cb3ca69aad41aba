/**
 * The planner's two wasm packages: which of them answers a question, and what the smaller one, which is loaded first, leaves
 * to the whole one.
 *
 * @typedef {import('./calls.js').Call} Call
 * @typedef {import('../core/types.js').Fault} Fault
 *
 * @typedef {{Session: {open: (text: string) => any}}} Module
 * A document with expressions, axes or other conventions is read by the whole package only, and so is one at fault.
 * @typedef {{text: string, sessions: Map<Module['Session'], any>, users: number, closed: boolean, forWhole?: boolean}} Open
 */
import init, { Session } from '../pkg-first/synthetica.js';

/** What a page asks by itself, without any input: the smaller of the two packages has no more. */
export const first = { Session };
/** @type {Call[]} */
const FIRST = ['plan', 'text', 'explain', 'ready'];
/** In the npm package the two are one. */
const areOne = 'in_words' in Session.prototype;

/** The planner could not be loaded, which is no failure of its own. */
export class NotLoaded extends Error {}

/**
 * Loads once; a load that failed is not kept, and the next question tries again.
 * @template T @param {() => Promise<T>} load
 */
function once(load) {
  /** @type {Promise<T> | null} */
  let loading = null;
  let isThere = false;
  return {
    isBegun: () => loading !== null,
    isThere: () => isThere,
    load: () =>
      (loading ??= load().then(
        (loaded) => {
          isThere = true;
          return loaded;
        },
        (error) => {
          loading = null;
          throw new NotLoaded(error instanceof Error ? error.message : String(error));
        },
      )),
  };
}

const small = once(async () => {
  await init();
  return first;
});

/** The whole package, for what is not in the smaller one. */
export const whole = once(async () => {
  // One after the other: in the npm package both are the same.
  if (small.isBegun()) await small.load();
  const module = await import('../pkg/synthetica.js');
  await module.default();
  return module;
});

/**
 * The package that answers: of those that can, the whole one where it is there, or the one that comes already. A plan goes on
 * where it was begun.
 * @param {Call} call @param {Open} [doc] @returns {Promise<Record<string, any> & Module>}
 */
export function packageFor(call, doc) {
  const canFirst = FIRST.includes(call) && !doc?.forWhole;
  const isBegun = call === 'plan' && doc?.sessions.has(Session);
  const takesFirst = canFirst && (isBegun || (!whole.isThere() && (small.isBegun() || !whole.isBegun())));
  return (takesFirst ? small : whole).load();
}

/**
 * The answer to a question of a document. Where the smaller package refuses it, with null, the whole one says why.
 * @param {Call} call @param {unknown[]} args @param {Open} doc @param {Module} module that answers
 */
export async function valueOf(call, args, doc, module) {
  const session = sessionOf(doc, module);
  if (call === 'plan') return session.plan_so_far();
  if (call === 'text' && module === first && !areOne) return JSON.stringify(session.document());
  try {
    return session[call](...args);
  } catch (error) {
    if (error !== null) throw error;
    return sessionOf(doc, await whole.load())[call](...args);
  }
}

/** The document in one of the packages, opened there if it is not yet. @param {Open} doc @param {Module} module */
export function sessionOf({ text, sessions }, { Session: kind }) {
  const open = sessions.get(kind) ?? kind.open(text);
  sessions.set(kind, open);
  return open;
}

/**
 * The whole package has the words for a motion's warnings; the first one has some too.
 * @param {any} motion @param {Open} doc @param {Module} module that planned it
 */
export async function putInWords({ report }, doc, module) {
  if (module !== first || areOne || report.warnings.every((/** @type {{message?: string}} */ { message }) => message !== undefined)) return;
  report.warnings = sessionOf(doc, await whole.load()).in_words(report.warnings);
}

/**
 * Whether the smaller package reads the document. What it refuses, with null, may be at fault, or be more than it knows: the
 * whole package tells.
 * @param {Open} doc
 */
export function isRead(doc) {
  try {
    sessionOf(doc, first);
    return true;
  } catch (error) {
    if (error !== null && !isFault(error)) throw error;
    doc.forWhole = true;
    return false;
  }
}

/** @param {unknown} error @returns {error is Fault} */
export const isFault = (error) => typeof error === 'object' && error !== null && !(error instanceof Error) && 'where' in error;

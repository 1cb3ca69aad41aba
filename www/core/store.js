/**
 * A linkage's kinds of state: the document (saved, undoable), the result (a function of the document), the view
 * (neither), the why (a function of what the view shows), and the progress of a plan that takes long. Knows no DOM
 * and no planner.
 *
 * @typedef {import('./types.js').MechanismDocument} MechanismDocument
 * @typedef {import('./types.js').Result} Result
 * @typedef {import('./types.js').View} View
 * @typedef {import('./types.js').Why} Why
 * @typedef {import('./types.js').Origin} Origin
 * @typedef {import('./types.js').Planning} Planning
 * @typedef {'document' | 'origin' | 'result' | 'view' | 'why' | 'planning'} Part
 * @typedef {{doc: MechanismDocument, result: Result, view: View, why: Why | null, planning: Planning | null}} State
 * @typedef {{doc: MechanismDocument, past: MechanismDocument[], future: MechanismDocument[]}} History
 * @typedef {ReturnType<typeof createStore>} Store
 */

import { same } from './spread.js';

/** Steps that undo keeps; a document is a few kilobytes and shares most of them with its neighbours. */
const MAX_UNDO = 500;

/** @param {MechanismDocument} first */
export function createStore(first) {
  let doc = first;
  /** Where every document came from; an edit hands it on. @type {WeakMap<MechanismDocument, Origin>} */
  const origins = new WeakMap([[first, { title: '', handle: null, saved: first }]]);
  const originOf = (/** @type {MechanismDocument} */ one) => /** @type {Origin} */ (origins.get(one));
  /** @type {MechanismDocument[]} */
  let past = [];
  /** @type {MechanismDocument[]} */
  let future = [];
  /** Edits with the same mark make one undo step. */
  let mark = '';
  /** @type {Result} */
  let result = { motion: null, doc: null, plain: null, fault: null, trouble: '', again: false };
  /** @type {View} */
  let view = {
    frame: 0, playing: false, moving: '', posture: null, selected: '', hovered: '',
    speed: 1, loop: 'once', side: '', charts: ['translation', 'rotation', 'driven', 'path', 'joints', 'sigma'],
    projection: 'perspective', show: { goal: true, closest: true, gaps: true, names: true, axes: true, ground: true, holds: true, freedoms: false }, ghosts: 'none', only: false,
  };
  let readonly = false;
  /** @type {Why | null} */
  let why = null;
  /** @type {Planning | null} */
  let planning = null;
  /** @type {Record<Part, Set<() => void>>} */
  const listeners = { document: new Set(), origin: new Set(), result: new Set(), view: new Set(), why: new Set(), planning: new Set() };

  /** @param {Part} part */
  const tell = (part) => {
    for (const listener of [...listeners[part]]) listener();
  };

  /** @param {MechanismDocument} next */
  const show = (next) => {
    doc = next;
    tell('document');
  };

  return {
    get doc() {
      return doc;
    },
    get result() {
      return result;
    },
    get view() {
      return view;
    },
    get why() {
      return why;
    },
    get planning() {
      return planning;
    },
    /** The present document with the ones before and after it. @returns {History} */
    get history() {
      return { doc, past, future };
    },
    originOf,
    get origin() {
      return originOf(doc);
    },
    /** Whether something is in the document that its file has not. */
    get unsaved() {
      const { saved } = originOf(doc);
      return !saved || !same(saved, doc);
    },
    /** Whether edits are refused: the document is there to be looked at. */
    get readonly() {
      return readonly;
    },
    set readonly(on) {
      readonly = on;
    },
    get canUndo() {
      return past.length > 0;
    },
    get canRedo() {
      return future.length > 0;
    },

    /** @param {Part} part @param {() => void} listener @returns {() => void} ends it */
    subscribe(part, listener) {
      listeners[part].add(listener);
      return () => listeners[part].delete(listener);
    },

    /**
     * Tells when one value of the state is another one (`Object.is`).
     * @template T
     * @param {(state: State) => T} choose
     * @param {(value: T) => void} listener
     * @returns {() => void} ends it
     */
    select(choose, listener) {
      let last = choose(this);
      const look = () => {
        const next = choose(this);
        if (!Object.is(next, last)) listener((last = next));
      };
      const ends = /** @type {Part[]} */ (Object.keys(listeners)).map((part) => this.subscribe(part, look));
      return () => ends.forEach((end) => end());
    },

    /**
     * @param {(doc: MechanismDocument) => MechanismDocument} change
     * @param {string} [merge] edits in a row with the same mark are undone together
     */
    edit(change, merge = '') {
      if (readonly) return;
      const next = change(doc);
      if (next === doc || same(next, doc)) return;
      if (!merge || merge !== mark) {
        past = [...past.slice(1 - MAX_UNDO), doc];
      } else if (same(next, past[past.length - 1])) {
        // Typed and taken back: nothing is left to undo.
        past = past.slice(0, -1);
        mark = '';
        future = [];
        origins.set(next, originOf(doc));
        return show(next);
      }
      mark = merge;
      future = [];
      origins.set(next, originOf(doc));
      show(next);
    },

    undo() {
      const previous = past.at(-1);
      if (!previous || readonly) return;
      past = past.slice(0, -1);
      future = [doc, ...future];
      mark = '';
      show(previous);
    },

    redo() {
      const [next, ...rest] = future;
      if (!next || readonly) return;
      future = rest;
      past = [...past, doc];
      mark = '';
      show(next);
    },

    /**
     * Another document: a step that undo takes back.
     * @param {MechanismDocument} next
     * @param {Origin} origin
     */
    open(next, origin) {
      if (!same(next, doc)) {
        past = [...past.slice(1 - MAX_UNDO), doc];
        future = [];
      }
      mark = '';
      origins.set(next, origin);
      show(next);
    },

    /** Takes the place of everything: work that comes from another visit. @param {History} work @param {Origin} origin */
    restore(work, origin) {
      ({ past, future } = work);
      mark = '';
      for (const one of [work.doc, ...past, ...future]) if (!origins.has(one)) origins.set(one, origin);
      show(work.doc);
    },

    /** The document is in its file now. @param {MechanismDocument} saved @param {Partial<Origin>} file */
    markSaved(saved, file) {
      Object.assign(originOf(saved), file, { saved });
      tell('origin');
    },

    /** @param {Partial<Result>} change */
    setResult(change) {
      result = { ...result, ...(change.trouble === '' && { again: false }), ...change };
      tell('result');
    },

    /** @param {Partial<View>} change */
    setView(change) {
      const keys = /** @type {(keyof View)[]} */ (Object.keys(change));
      if (keys.every((key) => view[key] === change[key])) return;
      view = { ...view, ...change };
      tell('view');
    },

    /** How far a plan is that takes long; null while none does. @param {Planning | null} next */
    setPlanning(next) {
      if (next === planning) return;
      planning = next;
      tell('planning');
    },

    /** What is known of the posture that is shown; null while it is being asked for. @param {Why | null} next */
    setWhy(next) {
      if (next === why) return;
      why = next;
      tell('why');
    },
  };
}

/**
 * The search for the best motion of the present document: what is found so far, and which motion is shown, the followed one,
 * the best one, or both. An edit ends it, and what it found goes with the document.
 *
 * @typedef {import('../../core/types.js').Best} Best
 * @typedef {import('../../core/types.js').Motion} Motion
 * @typedef {'followed' | 'both' | 'best'} Which
 *
 * `best` is null before anything is found; `motion` the best motion, or its calm form where one is chosen: `choice` 0 is the best
 * motion itself, n the n-th point of the curve. `cost` is what that motion costs.
 * @typedef {{doc: unknown, running: boolean, message: string, best: Best | null, followed: Motion | null, motion: Motion | null,
 *   cost: import('../../core/types.js').MotionCost | null, choice: number, waiting: boolean, which: Which}} State
 */
import { ask } from '../../core/ask.js';
import { bestMotions, ghosts } from '../../core/best-motions.js';
import { textOf } from '../../core/document-text.js';
import { drivesJoints } from '../../core/driven.js';
import { Search } from '../../planner/search.js';
import { isCloser, shownWords } from './best-words.js';

/** Least pause between two motions that are fetched while the search goes on, in milliseconds: a long one is large. */
const FETCH_EVERY = 1000;

/** @type {State} */
const NOTHING = { doc: null, running: false, message: '', best: null, followed: null, motion: null, cost: null, choice: 0, waiting: false, which: 'followed' };

/** @typedef {ReturnType<typeof createSearchState>} SearchState */

/** @param {Pick<import('../../element/workbench.js').App, 'store' | 'signal'>} app @param {Search} [search] */
export function createSearchState({ store, signal }, search = new Search()) {
  let state = NOTHING;
  let life = new AbortController();
  let fetched = -Infinity;
  /** The mean of the motion that was fetched. */
  let mean = Infinity;
  /** @type {Set<() => void>} */
  const listeners = new Set();

  /** @param {Partial<State>} change */
  function set(change) {
    state = { ...state, ...change };
    for (const listener of [...listeners]) listener();
  }

  /** What prevents a search now, in words; empty where nothing does. */
  function obstacle() {
    const { motion, doc, fault, trouble } = store.result;
    if (drivesJoints(motion)) return 'Joints are driven: there is no goal, and no motion that is closer to it.';
    if (!motion || doc !== store.doc || fault || trouble) return 'There is no motion of this document yet.';
    return motion.partial ? 'Only a part of the motion is planned: plan the rest first.' : '';
  }

  async function begin() {
    const { doc, motion } = store.result;
    if (!doc || obstacle() || (state.doc === doc && (state.running || state.best?.progress === 1))) return;
    const followed = state.doc === doc && state.followed ? state.followed : motion;
    if (state.doc !== doc) set({ ...NOTHING, doc, followed });
    life = new AbortController();
    const own = life;
    set({ running: true, message: '' });
    const onProgress = (/** @type {Best} */ best) => {
      if (own.signal.aborted) return;
      set({ best });
      if (isCloser(best.best.mean, Math.min(mean, best.followed.mean)) && performance.now() > fetched + FETCH_EVERY) fetch(own.signal, best);
    };
    const found = await ask(() => search.best(textOf(doc), { signal: own.signal, onProgress }), 'look for a better motion');
    if (own.signal.aborted || state.doc !== doc) return;
    if (found.is !== 'answer') return set({ running: false, message: found.message });
    set({ best: found.value });
    await fetch(own.signal, found.value);
    if (!own.signal.aborted) set({ running: false });
  }

  /** The motion of what is found. @param {AbortSignal} ended @param {Best} best */
  async function fetch(ended, best) {
    const { doc } = state;
    fetched = performance.now();
    const got = await ask(() => search.bestMotion(textOf(/** @type {object} */ (doc))), 'fetch the best motion');
    if (ended.aborted || got.is !== 'answer' || state.choice > 0) return;
    mean = best.best.mean;
    take(got.value, best.best, 0);
  }

  /** @param {Motion} motion @param {import('../../core/types.js').MotionCost} cost @param {number} choice */
  function take(motion, cost, choice) {
    const { best } = state;
    const text = textOf(/** @type {object} */ (state.doc));
    const price = best?.curve[choice - 1]?.price;
    const isCalmer = choice > 0;
    bestMotions.set(motion, {
      name: isCalmer ? 'calmer' : 'best',
      words: shownWords(isCalmer ? cost : null, best?.best ?? cost, motion),
      write: (format, options) => search.exportBest(text, format, options, price),
      switches: isCalmer ? 0 : best?.switches.length ?? 0,
    });
    const isShown = store.result.motion === state.motion && state.motion !== null;
    set({ motion, cost, choice, waiting: false });
    noteGhost();
    if (isShown || state.which === 'best') show(state.which);
  }

  /** For what is exported. */
  function noteGhost() {
    const { which, followed, motion } = state;
    if (followed && motion && which === 'both') ghosts.set(followed, motion);
    else if (followed) ghosts.delete(followed);
  }

  /** A person ends it: what is found stays. */
  function stop() {
    life.abort();
    set({ running: false });
  }

  /** @param {Which} which */
  function show(which) {
    const { motion, followed } = state;
    if (which !== 'followed' && !motion) return;
    set({ which });
    noteGhost();
    const wanted = which === 'best' ? motion : followed;
    if (wanted && store.result.motion !== wanted && store.result.doc === state.doc) store.setResult({ motion: wanted });
  }

  /** A point between closer and calmer. @param {number} choice 0: the best motion itself */
  async function choose(choice) {
    const { doc, best } = state;
    if (!best || choice === state.choice) return;
    const point = best.curve[choice - 1];
    set({ choice, waiting: true });
    const which = state.which === 'followed' ? 'both' : state.which;
    const text = textOf(/** @type {object} */ (doc));
    const got = await ask(async () => (point ? search.calmMotion(text, point.price) : { motion: await search.bestMotion(text), ...best.best }), 'make the motion calmer');
    // The slider went on, or the document is another one.
    if (got.is === 'late' || state.doc !== doc || state.choice !== choice) return;
    if (got.is !== 'answer') return set({ waiting: false, message: got.message });
    const { motion, ...cost } = got.value;
    take(motion, cost, choice);
    show(which);
  }

  function reset() {
    life.abort();
    if (state.followed) ghosts.delete(state.followed);
    mean = Infinity;
    fetched = -Infinity;
    if (state !== NOTHING) set(NOTHING);
  }
  // An edit, another document, or another plan of the same one.
  store.subscribe('document', () => store.doc !== state.doc && reset());
  store.subscribe('result', () => {
    const { motion, doc } = store.result;
    if (doc === state.doc && (motion === state.motion || motion === state.followed)) return;
    if (state.doc !== null) reset();
  });
  signal.addEventListener('abort', () => {
    if (state.which === 'best') show('followed');
    life.abort();
    search.leave();
  });

  return {
    get now() {
      return state;
    },
    /** @param {() => void} listener */
    subscribe(listener) {
      listeners.add(listener);
    },
    obstacle,
    begin,
    stop,
    show,
    choose,
    /** Whether the planner lost its way in a frame where the best motion has a pose. @param {number} frame */
    isFoundWhereLost: (frame) => state.motion !== null && (state.best?.found_where_lost.includes(frame) ?? false),
    /** The distances of both motions in a frame, where the best one's is less. @param {number} frame */
    betterAt(frame) {
      const { motion, followed } = state;
      if (!motion || !followed || frame >= motion.frames || frame >= followed.frames) return null;
      const [best, now] = [motion.metric[frame], followed.metric[frame]];
      return isCloser(best, now) ? { best, now } : null;
    },
  };
}

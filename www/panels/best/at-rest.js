/**
 * The search for the best motion of a view, made when it is first wanted; and in the applet when nothing is edited, moved or played
 * for some time after a plan. All that it needs is loaded then.
 *
 * @typedef {import('./search-state.js').SearchState} SearchState
 * @typedef {import('../../element/workbench.js').App} App
 */
import { drivesJoints } from '../../core/driven.js';
import { recall } from '../../ui/kept-layout.js';
import { createBestMotion } from './best-motion.js';
import { reachesAll } from './best-words.js';

/** How long all rests before, in milliseconds. */
const REST = 1500;

/** Of each view. @type {WeakMap<AbortSignal, SearchState>} */
const made = new WeakMap();

/** @param {App} app */
export function searchOf(app) {
  const search = made.get(app.signal) ?? createBestMotion(app);
  made.set(app.signal, search);
  return search;
}

/** What it has found, if there is one. @param {Pick<App, 'signal'>} app */
export const foundOf = ({ signal }) => made.get(signal)?.now;

/** Whether it looks by itself. @param {Pick<App, 'interaction' | 'keys' | 'root'>} app */
export const isApplet = ({ interaction, keys, root }) => interaction === 'full' && keys !== root;

/** @param {App} app */
export function searchAtRest(app) {
  const { store, signal } = app;
  if (signal.aborted) return;
  /** The document that was searched last, or needs no search. @type {unknown} */
  let seen = null;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let waiting;
  const isBusy = () => {
    const { result: { motion, doc, fault, trouble }, view: { playing, moving, posture }, planning } = store;
    return !motion || doc !== store.doc || fault || trouble || planning || playing || moving || posture || motion.partial || document.hidden;
  };
  function follow() {
    const { motion, doc } = store.result;
    clearTimeout(waiting);
    if (doc === seen || isBusy()) return;
    waiting = setTimeout(() => {
      if (signal.aborted || recall().search === false || isBusy() || !motion || motion !== store.result.motion) return;
      seen = doc;
      if (!reachesAll(motion) && !drivesJoints(motion)) searchOf(app).begin();
    }, REST);
  }
  for (const part of /** @type {const} */ (['document', 'result', 'view', 'planning'])) store.subscribe(part, follow);
  document.addEventListener('visibilitychange', follow, { signal });
  signal.addEventListener('abort', () => clearTimeout(waiting));
  follow();
}

/**
 * What stands over the view while the planner is loaded or a plan takes long: how far it is, and a way to stop it; then how
 * far it came, and a way to go on.
 */
import { focusBeside, setText } from '../ui/dom.js';
import { partSentence } from '../core/status-words.js';

/** Least pause between two announcements of a progress, in milliseconds. */
const SPEAK_EVERY = 10_000;

/** After how many milliseconds without the planner it is said that it is being loaded. */
const LOADS_LONG = 500;

const LOADING = 'Loading the planner.';

/** @param {Pick<import('../element/workbench.js').App, 'find' | 'store' | 'planner' | 'replan' | 'signal'>} app */
export function createPlanning({ find, store, planner, replan, signal }) {
  const banner = find('planning');
  const stop = find('planning-stop');
  const on = find('planning-on');
  let spoken = -Infinity;
  let loading = false;

  function show() {
    const { planning, result } = store;
    const text = planning ? `Planning frame ${planning.done + 1} of ${planning.frames}.` : loading ? LOADING : partSentence(result.motion);
    const focused = [stop, on].some((button) => button === focusBeside(button));
    banner.hidden = !text;
    setText(find('planning-text'), text);
    stop.hidden = !planning;
    on.hidden = planning !== null || loading;
    if (focused) (!text ? find('play') : planning ? stop : on).focus();
    if (!planning || performance.now() - spoken < SPEAK_EVERY) return;
    spoken = performance.now();
    setText(find('live'), `${text} Stop shows what is planned so far.`);
  }

  stop.addEventListener('click', () => store.planning?.stop());
  on.addEventListener('click', () => replan());
  store.subscribe('planning', show);
  store.subscribe('result', show);
  show();

  const late = setTimeout(() => {
    loading = true;
    setText(find('live'), LOADING);
    show();
  }, LOADS_LONG);
  const loaded = () => {
    clearTimeout(late);
    loading = false;
    if (!signal.aborted) show();
  };
  // Its first answer says that it is there; where it cannot be loaded, whoever asks next tells why.
  planner.defaults().then(loaded, loaded);
  signal.addEventListener('abort', () => clearTimeout(late), { once: true });
}

/**
 * What stands over the view while the planner is loaded or a plan takes long: how far it is, and a way to stop it; then how
 * far it came, and a way to go on.
 */
import { ask, untilAnswered } from '../core/ask.js';
import { loading } from '../planner/loading.js';
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
  let isLoading = false;

  function show() {
    const { planning, result } = store;
    const text = planning ? `Planning frame ${planning.done + 1} of ${planning.frames}.` : isLoading ? loadingText() : partSentence(result.motion);
    const focused = [stop, on].some((button) => button === focusBeside(button));
    banner.hidden = !text;
    setText(find('planning-text'), text);
    stop.hidden = !planning;
    on.hidden = planning !== null || isLoading;
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

  loading.subscribe(show, signal);
  // Its first answer says that it is there.
  untilAnswered(store, async () => {
    const late = setTimeout(() => {
      isLoading = true;
      setText(find('live'), LOADING);
      show();
    }, LOADS_LONG);
    signal.addEventListener('abort', () => clearTimeout(late), { once: true });
    const answer = await ask(() => planner.ready(), 'start');
    clearTimeout(late);
    isLoading = false;
    if (!signal.aborted) show();
    return answer;
  });
}

/** With how much has come, where that is known. */
function loadingText() {
  const { latest } = loading;
  return latest ? `${LOADING.slice(0, -1)} … ${Math.floor((100 * latest.loaded) / latest.total)} %` : LOADING;
}

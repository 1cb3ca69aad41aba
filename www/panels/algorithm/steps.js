/**
 * The controls that go through iterates: method, slider, first, back, play, on, last.
 *
 * @typedef {import('./algorithm-words.js').Method} Method
 */
import { element, setText } from '../../ui/dom.js';
import { METHODS, kept } from './algorithm-words.js';

/** Milliseconds that an iterate is shown while they play. */
const PACE = 350;

/** @param {{choose: (at: number) => void, chooseMethod: (method: Method) => void}} on */
export function createSteps({ choose, chooseMethod }) {
  let at = 0;
  let last = 0;
  /** @type {ReturnType<typeof setInterval> | undefined} */
  let timer;

  const go = (/** @type {number} */ to) => () => {
    stop();
    choose(to === Infinity ? last : to === -Infinity ? 0 : at + to);
  };
  const button = (/** @type {string} */ label, /** @type {string} */ shape, /** @type {() => void} */ click) => {
    const made = element('button', { class: 'icon', 'aria-label': label, title: label, click });
    made.innerHTML = `<svg viewBox="0 0 16 16" aria-hidden="true"><path class="solid" d="${shape}" /></svg>`;
    return made;
  };
  const first = button('First iterate', 'M3 3h2v10H3zM13 3v10L6 8z', go(-Infinity));
  const back = button('Previous iterate', 'M11 3v10L4 8z', go(-1));
  const on = button('Next iterate', 'M5 3v10l7-5z', go(1));
  const end = button('Last iterate', 'M11 3h2v10h-2zM3 3v10l7-5z', go(Infinity));
  const play = element('button', { 'aria-pressed': 'false', click: toggle }, 'Play steps');
  const slider = element('input', { type: 'range', min: 0, max: 1, step: 1, value: 0, 'aria-label': 'Iterate' });
  slider.addEventListener('input', () => {
    stop();
    choose(Number(slider.value));
  });
  const choice = Object.entries(METHODS).map(([method, name]) => {
    const box = element('input', { type: 'radio', name: 'algorithm-method', value: method });
    box.addEventListener('change', () => {
      stop();
      chooseMethod(/** @type {Method} */ (method));
    });
    return { method, box, label: element('label', {}, box, name) };
  });

  function toggle() {
    if (timer) return stop();
    if (at === last) choose(0);
    setText(play, 'Stop');
    play.setAttribute('aria-pressed', 'true');
    timer = setInterval(() => {
      if (at < last) choose(at + 1);
      if (at >= last) stop();
    }, PACE);
  }

  function stop() {
    clearInterval(timer);
    timer = undefined;
    setText(play, 'Play steps');
    play.setAttribute('aria-pressed', 'false');
  }

  return {
    root: element(
      'div',
      { class: 'steps' },
      element('fieldset', {}, element('legend', { class: 'sr' }, 'Method'), ...choice.map(({ label }) => label)),
      element('div', { class: 'buttons', role: 'group', 'aria-label': 'Iterates' }, first, back, on, end, play),
      slider,
    ),
    stop,
    focus: () => slider.focus(),
    /** @param {Method} method @param {number} index @param {import('../../core/types.js').History} history */
    show(method, index, history) {
      at = index;
      last = kept(history) - 1;
      for (const one of choice) one.box.checked = one.method === method;
      slider.max = String(last);
      slider.value = String(at);
      slider.setAttribute('aria-valuetext', `iterate ${history.iteration[at]} of ${history.last}`);
      // A disabled button would lose the focus of a keyboard that stepped to the end.
      for (const one of [first, back]) one.setAttribute('aria-disabled', String(at === 0));
      for (const one of [on, end]) one.setAttribute('aria-disabled', String(at === last));
    },
  };
}

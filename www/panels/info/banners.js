/**
 * What stands over the view when something is wrong: the document's fault, the planner's trouble; and what a screen reader
 * is told of the shown frame.
 *
 * @typedef {ReturnType<typeof createBanners>} Banners
 */
import { atRest } from '../../core/at-rest.js';
import { setText } from '../../ui/dom.js';
import { faultParts, faultText } from '../../core/fault-text.js';
import { frameSentence, partSentence } from '../../core/status-words.js';

/** Pause before the live region speaks, in milliseconds: while the motion plays it would never stop. */
const SPEAK_AFTER = 600;

/** @param {Pick<import('../../element/workbench.js').App, 'find' | 'store'>} app */
export function createBanners({ find, store }) {
  const button = find('go-to-fault');
  button.hidden = true;
  const live = find('live');

  function show() {
    const { motion, fault, trouble, again } = store.result;
    find('fault-banner').hidden = !fault;
    setText(find('fault-text'), fault ? `${faultParts(fault).what}${motion ? ' The last good motion is still shown.' : ''}` : '');
    find('trouble').hidden = !trouble;
    setText(find('trouble-text'), trouble);
    find('try-again').hidden = !again;
  }
  find('try-again').addEventListener('click', () => {
    store.setResult({ trouble: '' });
    find('play').focus();
  });

  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let speech;
  function speak() {
    clearTimeout(speech);
    speech = setTimeout(() => {
      const { motion, fault, trouble } = store.result;
      if (store.view.playing && !fault && !trouble) return;
      setText(live, fault ? faultText(fault) : trouble || (motion ? `${partSentence(motion)} ${frameSentence(store)}`.trim() : ''));
    }, SPEAK_AFTER);
  }

  atRest(store, ['view', 'result'], speak);
  store.subscribe('result', show);
  show();
  return {
    /** Where there are tables, there is a way to the cell at fault. @param {() => void} act */
    goToFault(act) {
      button.hidden = false;
      button.addEventListener('click', act);
    },
  };
}

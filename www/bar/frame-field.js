/**
 * The frame number, which becomes a field when it is clicked: a frame can be typed.
 */
import { focusBeside, setText } from '../ui/dom.js';

/**
 * The index of a typed frame, or why it is none.
 * @param {string} text @param {number} frames that are planned @param {number} [all] frames of the goal motion
 * @returns {number | string}
 */
export function readFrame(text, frames, all = frames) {
  const typed = text.trim().replace(/\s*\/.*$/, '');
  const frame = Number(typed);
  if (/^\d+$/.test(typed) && frame >= 1 && frame <= frames) return frame - 1;
  const accepted = `a whole number from 1 to ${frames}`;
  if (/^\d+$/.test(typed) && frame > frames && frame <= all) return `Frame ${typed} is not planned: type ${accepted}.`;
  return typed === '' ? `Type ${accepted}.` : `There is no frame ${typed}: type ${accepted}.`;
}

/** @param {Pick<import('../element/workbench.js').App, 'find' | 'store'>} app @param {(frame: number) => void} goTo */
export function createFrameField({ find, store }, goTo) {
  const number = find('frame-number');
  /** @type {HTMLInputElement} */
  const field = find('frame-field');
  const refusal = find('frame-refusal');
  const frames = () => store.result.motion?.frames ?? 1;
  const read = () => readFrame(field.value, frames(), store.result.motion?.goal_frames);

  /** @param {string} text */
  function refuse(text) {
    refusal.hidden = text === '';
    setText(refusal, text);
    if (text) field.setAttribute('aria-invalid', 'true');
    else field.removeAttribute('aria-invalid');
  }

  function close() {
    if (field.hidden) return;
    const focused = focusBeside(field) === field;
    number.hidden = false;
    field.hidden = true;
    refuse('');
    if (focused) number.focus();
  }

  number.addEventListener('click', () => {
    field.value = String(store.view.frame + 1);
    field.setAttribute('aria-label', `Frame, 1 to ${frames()}`);
    field.hidden = false;
    number.hidden = true;
    field.focus();
    field.select();
  });
  field.addEventListener('input', () => refuse(''));
  field.addEventListener('keydown', (event) => {
    if (event.key !== 'Enter' && event.key !== 'Escape') return;
    // Or the button, which gets the focus, would take the key as a click.
    event.preventDefault();
    if (event.key === 'Escape') return close();
    const typed = read();
    if (typeof typed === 'string') return refuse(typed);
    goTo(typed);
    close();
  });
  field.addEventListener('blur', () => {
    const typed = read();
    if (typeof typed === 'number' && typed !== store.view.frame && !field.hidden) goTo(typed);
    close();
  });
}

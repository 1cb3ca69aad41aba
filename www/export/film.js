/**
 * A film of one pass of the motion, as WebM: what is drawn in it, the dialog while it is made, and the saved file.
 *
 * @typedef {import('../element/workbench.js').App} App
 */
import '../style/export.css';
import { element, setText } from '../ui/dom.js';
import { saveFile } from './save.js';
import { shownName } from './shown-name.js';
import { frameAt } from '../core/playhead.js';
import { shown } from '../core/shown.js';
import { openDialog } from '../ui/dialog.js';
import { checkFilm } from './film-check.js';
import { encodeFilm } from './film-encode.js';
import { recordFilm } from './film-record.js';
import { WIDEST } from './film-settings.js';
import { encodes, recordedType } from './film-type.js';
import { legendLines } from './legend.js';
import { drawPicture } from './picture.js';

/** @param {App} app */
export async function exportFilm({ store, scene, player, say }) {
  // What is filmed stays the same, whatever is planned meanwhile.
  const { result } = store;
  const { motion, doc } = result;
  if (!scene || !motion || !doc) return;
  const { frame, playing } = store.view;
  player.pause();

  const { clientWidth: width, clientHeight: height } = scene.canvas;
  const ratio = Math.min(WIDEST / width, devicePixelRatio, 2);
  // Encoders want even numbers.
  const wish = { width: even(width * ratio) / ratio, height: even(height * ratio) / ratio, ratio, legend: legendLines({ store, scene }) };
  const canvas = element('canvas', { class: 'film' });
  // Without transparency, which would be half of the work, and of the file.
  canvas.getContext('2d', { alpha: false });
  const bar = element('progress', { max: 1, value: 0, 'aria-label': 'Made so far' });
  const told = element('output', {});
  let cancelled = false;
  const dialog = openDialog('Making the film', canvas, element('p', {}, bar, ' ', told), element('button', { click: () => dialog.close() }, 'Cancel'));
  dialog.addEventListener('close', () => {
    cancelled = true;
  });

  const seconds = player.passSeconds;
  const [from, to] = [motion.time[0], motion.time[motion.frames - 1]];
  /** @param {number} share of the pass */
  const draw = (share) => {
    const what = shown({ result, view: { ...store.view, posture: null, frame: frameAt(motion.time, from + share * (to - from)) } });
    if (what) scene.pose(what);
    drawPicture(scene, wish, canvas);
    bar.value = share;
    setText(told, `${(share * seconds).toFixed(1)} of ${seconds.toFixed(1)} s`);
  };

  /** @returns {Promise<string>} what is told of it */
  async function made() {
    const shot = { canvas, seconds, draw, stopped: () => cancelled };
    const film = (encodes() ? await encodeFilm(shot) : null) ?? (cancelled ? null : await recorded(shot));
    if (typeof film === 'string') return film;
    if (cancelled || !film) return 'The film was cancelled.';
    await checkFilm(film, seconds);
    const name = shownName(result, 'webm');
    saveFile(name, new Blob([film], { type: 'video/webm' }));
    return `Saved ${name}.`;
  }

  try {
    const words = await made();
    // A notice below an open dialog is not spoken.
    dialog.close();
    say(words);
  } finally {
    dialog.close();
    player.frame = frame;
    player.invalidate();
    if (playing) player.play();
  }
}

/**
 * Recorded as it plays: a page that is not seen is not drawn, so the recording ends with that.
 * @param {import('./film-settings.js').Shot} shot
 * @returns {Promise<Uint8Array<ArrayBuffer> | string | null>} the film, or why there is none; null if it was cancelled
 */
async function recorded(shot) {
  if (!recordedType()) throw new Error('this browser can neither encode nor record one');
  let hidden = document.hidden;
  const watch = () => {
    hidden ||= document.hidden;
  };
  document.addEventListener('visibilitychange', watch);
  try {
    const film = await recordFilm({ ...shot, stopped: () => hidden || shot.stopped() });
    return hidden && !shot.stopped() ? 'The film ended when the page was hidden: this browser can only record what is seen.' : film;
  } finally {
    document.removeEventListener('visibilitychange', watch);
  }
}

/** @param {number} pixels */
const even = (pixels) => 2 * Math.max(1, Math.floor(pixels / 2));

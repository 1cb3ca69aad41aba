/**
 * A film of one pass of the motion, recorded while it plays, as WebM.
 *
 * @typedef {import('../element/workbench.js').App} App
 */
import '../style/export.css';
import { element, setText } from '../ui/dom.js';
import { fileName, saveFile } from './save.js';
import { frameAt } from '../core/playhead.js';
import { shown } from '../core/shown.js';
import { openDialog } from '../ui/dialog.js';
import { filmType } from './film-type.js';
import { drawPicture } from './picture.js';
import { withDuration } from './webm.js';

const RATE = 30; // pictures a second
const WIDEST = 1280; // pixels; more is beyond what browsers encode while they draw
const BITS = 8_000_000; // a second: no blocks in even surfaces
/** Milliseconds for which the last picture stands before and after it is taken once more: a film ends with a picture. */
const LAST = 100;

/** @param {App} app */
export async function exportFilm({ store, scene, player, say }) {
  const { motion, doc: mechanism } = store.result;
  const type = filmType();
  if (!scene || !motion || !mechanism || !type) return;
  const { frame, playing } = store.view;
  player.pause();

  const { clientWidth: width, clientHeight: height } = scene.canvas;
  const ratio = Math.min(WIDEST / width, devicePixelRatio, 2);
  // Encoders want even numbers.
  const wish = { width: even(width * ratio) / ratio, height: even(height * ratio) / ratio, ratio };
  const canvas = element('canvas', { class: 'film' });
  const bar = element('progress', { max: 1, value: 0, 'aria-label': 'Recorded' });
  const told = element('output', {});
  let stopped = false;
  const stop = () => {
    stopped = true;
  };
  const dialog = openDialog('Recording the film', canvas, element('p', {}, bar, ' ', told), element('button', { click: stop }, 'Cancel'));
  dialog.addEventListener('close', stop);
  // A page that is not seen is not drawn.
  const hidden = () => {
    if (document.hidden) stop();
  };
  document.addEventListener('visibilitychange', hidden);

  const seconds = player.passSeconds;
  const [from, to] = [motion.time[0], motion.time[motion.frames - 1]];
  /** @param {number} share of the pass */
  const draw = (share) => {
    const what = shown({ result: store.result, view: { ...store.view, posture: null, frame: frameAt(motion.time, from + share * (to - from)) } });
    if (what) scene.pose(what);
    drawPicture(scene, wish, canvas);
    bar.value = share;
    setText(told, `${(share * seconds).toFixed(1)} of ${seconds.toFixed(1)} s`);
  };

  try {
    draw(0);
    // Where the browser can, each picture is recorded by hand, also where drawing takes longer than it should stand.
    const byHand = 'CanvasCaptureMediaStreamTrack' in globalThis && 'requestFrame' in CanvasCaptureMediaStreamTrack.prototype;
    const stream = canvas.captureStream(byHand ? 0 : RATE);
    const [track] = /** @type {CanvasCaptureMediaStreamTrack[]} */ (stream.getVideoTracks());
    const take = () => {
      if (byHand) track.requestFrame();
    };
    const recorder = new MediaRecorder(stream, { mimeType: type, videoBitsPerSecond: BITS });
    /** @type {Blob[]} */
    const pieces = [];
    recorder.addEventListener('dataavailable', ({ data }) => pieces.push(data));
    const ended = new Promise((resolve, reject) => {
      recorder.addEventListener('stop', resolve);
      recorder.addEventListener('error', () => reject(new Error('the browser stopped recording')));
    });
    recorder.start();
    take();
    const start = performance.now();
    for (let share = 0; share < 1 && !stopped; ) {
      share = Math.min(1, (performance.now() - start) / 1000 / seconds);
      draw(share);
      take();
      await pause(1000 / RATE);
    }
    if (!stopped) {
      await pause(LAST);
      take();
      await pause(LAST);
    }
    const length = performance.now() - start;
    recorder.stop();
    await ended;
    track.stop();
    if (stopped) return say(document.hidden ? 'The recording ended when the page was hidden.' : 'The recording was cancelled.');
    const film = withDuration(new Uint8Array(await new Blob(pieces).arrayBuffer()), length);
    const name = fileName(mechanism, 'webm');
    saveFile(name, new Blob([film], { type: 'video/webm' }));
    say(`Saved ${name}.`);
  } finally {
    document.removeEventListener('visibilitychange', hidden);
    dialog.close();
    player.frame = frame;
    if (playing) player.play();
  }
}

/** @param {number} pixels */
const even = (pixels) => 2 * Math.max(1, Math.floor(pixels / 2));

/** @param {number} milliseconds */
const pause = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));

/**
 * A film recorded while the motion plays, for browsers that cannot encode pictures one by one.
 */
import { BITS, RATE } from './film-settings.js';
import { recordedType } from './film-type.js';
import { withDuration } from './webm.js';

/** Milliseconds for which the last picture stands before and after it is taken once more: a film ends with a picture. */
const LAST = 50;

/**
 * @param {import('./film-settings.js').Shot} shot
 * @returns {Promise<Uint8Array<ArrayBuffer> | null>} a WebM file; null if it was stopped
 */
export async function recordFilm({ canvas, seconds, draw, stopped }) {
  draw(0);
  // Where the browser can, each picture is recorded by hand, also where drawing takes longer than it should stand.
  const byHand = 'CanvasCaptureMediaStreamTrack' in globalThis && 'requestFrame' in CanvasCaptureMediaStreamTrack.prototype;
  const stream = canvas.captureStream(byHand ? 0 : RATE);
  const [track] = /** @type {CanvasCaptureMediaStreamTrack[]} */ (stream.getVideoTracks());
  const take = () => {
    if (byHand) track.requestFrame();
  };
  const recorder = new MediaRecorder(stream, { mimeType: recordedType(), videoBitsPerSecond: BITS });
  /** @type {Blob[]} */
  const pieces = [];
  recorder.addEventListener('dataavailable', ({ data }) => pieces.push(data));
  const ended = new Promise((resolve, reject) => {
    recorder.addEventListener('stop', resolve);
    recorder.addEventListener('error', () => reject(new Error('the browser stopped recording')));
  });
  // It may fail before it is awaited below.
  ended.catch(() => {});
  try {
    recorder.start();
    take();
    const start = performance.now();
    for (let share = 0; share < 1 && !stopped(); ) {
      share = Math.min(1, (performance.now() - start) / 1000 / seconds);
      draw(share);
      take();
      await pause(1000 / RATE);
    }
    if (!stopped()) {
      await pause(LAST);
      take();
      await pause(LAST);
    }
    const length = performance.now() - start;
    if (recorder.state !== 'inactive') recorder.stop();
    await ended;
    return stopped() ? null : withDuration(new Uint8Array(await new Blob(pieces).arrayBuffer()), length);
  } finally {
    track.stop();
  }
}

/** @param {number} milliseconds */
const pause = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));

/**
 * A film recorded while the motion plays, for browsers that cannot encode pictures one by one.
 */
import { BITS, RATE } from './film-settings.js';
import { recordedType } from './film-type.js';
import { withDuration } from './webm.js';

/** Milliseconds for which the last picture stands, twice: a film ends with a picture. */
const LAST = 50;

/**
 * @param {import('./film-settings.js').Shot} shot
 * @returns {Promise<Uint8Array<ArrayBuffer> | null>} a WebM file; null if it was stopped
 */
export async function recordFilm({ canvas, seconds, draw, stopped }) {
  draw(0);
  // Where the browser can, each picture is recorded by hand.
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
  // Drawing takes no time of the film: the recorder rests meanwhile.
  let length = 0;
  /** @param {number} milliseconds for which the picture that was drawn last is recorded */
  const stand = async (milliseconds) => {
    recorder.resume();
    const from = performance.now();
    take();
    await pause(milliseconds);
    recorder.pause();
    length += performance.now() - from;
  };
  try {
    recorder.start();
    recorder.pause();
    for (let share = 0; share < 1 && !stopped(); ) {
      await stand(1000 / RATE);
      share = Math.min(1, length / 1000 / seconds);
      draw(share);
    }
    if (!stopped()) {
      await stand(LAST);
      await stand(LAST);
    }
    if (recorder.state !== 'inactive') recorder.stop();
    await ended;
    return stopped() ? null : withDuration(new Uint8Array(await new Blob(pieces).arrayBuffer()), length);
  } finally {
    track.stop();
  }
}

/** @param {number} milliseconds */
const pause = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));

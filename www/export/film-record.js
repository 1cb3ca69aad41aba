/**
 * A film recorded while the motion plays, for browsers that cannot encode pictures one by one.
 */
import { BufferTarget, EncodedPacketSink, EncodedVideoPacketSource, Output, WebMOutputFormat } from 'mediabunny';
import { readFilm } from './film-check.js';
import { BITS, RATE } from './film-settings.js';
import { recordedType } from './film-type.js';

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
    await Promise.all([pause(milliseconds), presented()]);
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
    return stopped() ? null : await atLength(new Uint8Array(await new Blob(pieces).arrayBuffer()), seconds);
  } finally {
    track.stop();
  }
}

/** Until the canvas is on the screen, which is when it is recorded; a page that is not seen waits only so long. */
const presented = () => Promise.race([new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))), pause(1000)]);

/** @param {number} milliseconds */
const pause = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));

/**
 * The same pictures, as long as the motion: browsers record a live stream without a length, in which players cannot
 * seek, and where time was lost while it was recorded it is a little too long.
 * @param {Uint8Array<ArrayBuffer>} film @param {number} seconds
 */
async function atLength(film, seconds) {
  const { input, track } = await readFilm(film);
  try {
    const codec = await track.getCodec();
    const decoderConfig = await track.getDecoderConfig();
    if (!codec || !decoderConfig) throw new Error('the browser recorded a film that it cannot read');
    const packets = [];
    for await (const packet of new EncodedPacketSink(track).packets()) packets.push(packet);
    const [from, to] = [packets[0].timestamp, packets[packets.length - 1].timestamp];
    // The last picture begins one picture before the end.
    const scale = (seconds - 1 / RATE) / (to - from);
    const times = [...packets.map(({ timestamp }) => (timestamp - from) * scale), seconds];
    const target = new BufferTarget();
    const output = new Output({ format: new WebMOutputFormat(), target });
    const source = new EncodedVideoPacketSource(codec);
    output.addVideoTrack(source);
    await output.start();
    for (const [at, packet] of packets.entries()) {
      await source.add(packet.clone({ timestamp: times[at], duration: times[at + 1] - times[at] }), { decoderConfig });
    }
    await output.finalize();
    return target.buffer && new Uint8Array(target.buffer);
  } finally {
    input.dispose();
  }
}

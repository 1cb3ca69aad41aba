/**
 * A film made picture by picture: each is drawn, encoded and given its place in time, however long that takes.
 */
import { BufferTarget, CanvasSource, Output, WebMOutputFormat, getFirstEncodableVideoCodec } from 'mediabunny';
import { BITS, RATE } from './film-settings.js';

/** What WebM takes, the smallest files first; AV1 is last because it is slow without a chip for it. */
const CODECS = /** @type {const} */ (['vp9', 'vp8', 'av1']);
/** Seconds between pictures that are kept whole: players seek to these. */
const WHOLE = 1;

/**
 * @param {import('./film-settings.js').Shot} shot
 * @returns {Promise<Uint8Array<ArrayBuffer> | null>} a WebM file; null if this browser encodes none of its codecs, or it was stopped
 */
export async function encodeFilm({ canvas, seconds, draw, stopped }) {
  draw(0);
  const codec = await getFirstEncodableVideoCodec([...CODECS], { width: canvas.width, height: canvas.height, bitrate: BITS });
  if (!codec) return null;
  const target = new BufferTarget();
  const output = new Output({ format: new WebMOutputFormat(), target });
  const source = new CanvasSource(canvas, { codec, bitrate: BITS, keyFrameInterval: WHOLE });
  output.addVideoTrack(source);
  // The first and the last picture are the motion's; all stand equally long, together as long as the motion.
  const pictures = Math.max(2, Math.round(seconds * RATE));
  const each = seconds / pictures;
  try {
    await output.start();
    for (let at = 0; at < pictures; at++) {
      if (stopped()) {
        await output.cancel();
        return null;
      }
      draw(at / (pictures - 1));
      await source.add(at * each, each);
      await breathe();
    }
    await output.finalize();
  } catch (error) {
    if (output.state !== 'canceled' && output.state !== 'finalized') await output.cancel();
    throw error;
  }
  if (!target.buffer) throw new Error('the film is empty');
  return new Uint8Array(target.buffer);
}

/** Lets the page draw and hear the Cancel button; timers of a page that is not seen are too slow for every picture. */
const breathe = () => (document.hidden ? null : new Promise((resolve) => setTimeout(resolve)));

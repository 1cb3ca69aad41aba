/**
 * Reads a film that was just made, before it is saved: a browser may record a file without a picture and say nothing.
 */
import { BufferSource, Input, VideoSampleSink, WEBM } from 'mediabunny';

/** How much longer or shorter than the motion a film may be: a share of it, and seconds for its first and last picture. */
const SHARE = 0.05;
const ENDS = 0.25;

/**
 * @param {Uint8Array<ArrayBuffer>} film a WebM file
 * @param {number} seconds how long it should be
 * @throws {Error} with what is wrong with it
 */
export async function checkFilm(film, seconds) {
  const input = new Input({ source: new BufferSource(film), formats: [WEBM] });
  try {
    if (!(await input.canRead())) throw new Error(`the browser made a file of ${film.length} bytes that is no film`);
    const track = await input.getPrimaryVideoTrack();
    const pictures = track ? (await track.computePacketStats()).packetCount : 0;
    if (!track || pictures < 2) throw new Error(`the browser made a film of ${film.length} bytes without a moving picture`);
    const length = await input.computeDuration();
    if (!(Math.abs(length - seconds) <= SHARE * seconds + ENDS)) {
      throw new Error(`the browser made a film of ${length.toFixed(1)} s instead of ${seconds.toFixed(1)} s`);
    }
    if (!(await track.canDecode())) return;
    const sink = new VideoSampleSink(track);
    for (const time of [await track.getFirstTimestamp(), length]) {
      const sample = await sink.getSample(time);
      if (!sample) throw new Error('the browser made a film that it cannot read');
      sample.close();
    }
  } finally {
    input.dispose();
  }
}

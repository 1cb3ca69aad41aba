/**
 * Reads a film that was just made, before it is saved: a browser may record a file without a picture and say nothing.
 */
import { BufferSource, Input, VideoSampleSink, WEBM } from 'mediabunny';

/** How much longer or shorter than the motion a film may be, as a share of it. */
const SHARE = 0.01;

/**
 * @param {Uint8Array<ArrayBuffer>} film
 * @returns {Promise<{input: Input, track: import('mediabunny').InputVideoTrack}>} `input` is to be disposed of
 * @throws {Error} if it is no film or has no pictures
 */
export async function readFilm(film) {
  const input = new Input({ source: new BufferSource(film), formats: [WEBM] });
  const track = (await input.canRead()) ? await input.getPrimaryVideoTrack() : null;
  if (track && (await track.computePacketStats()).packetCount > 1) return { input, track };
  input.dispose();
  throw new Error(`the browser made a file of ${film.length} bytes that is no film`);
}

/**
 * @param {Uint8Array<ArrayBuffer>} film a WebM file
 * @param {number} seconds how long it should be
 * @throws {Error} with what is wrong with it
 */
export async function checkFilm(film, seconds) {
  const { input, track } = await readFilm(film);
  try {
    // As players read it: its last picture alone does not tell how long it stands.
    const length = (await input.getDurationFromMetadata()) ?? 0;
    if (!(Math.abs(length - seconds) <= SHARE * seconds)) {
      throw new Error(`the browser made a film of ${length.toFixed(2)} s instead of ${seconds.toFixed(2)} s`);
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

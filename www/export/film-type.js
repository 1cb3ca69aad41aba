/**
 * Whether and how this browser can make a film of a canvas.
 */

/** @returns {string} the kind of WebM that it records while a canvas is drawn; empty if it records none */
export function recordedType() {
  if (typeof MediaRecorder === 'undefined' || !('captureStream' in HTMLCanvasElement.prototype)) return '';
  return ['video/webm;codecs=vp9', 'video/webm;codecs=vp8', 'video/webm'].find((type) => MediaRecorder.isTypeSupported(type)) ?? '';
}

/** Whether pictures can be encoded one by one, without playing; not every browser that can has a codec for WebM. */
export const encodes = () => typeof VideoEncoder !== 'undefined';

export const canFilm = () => encodes() || recordedType() !== '';

/**
 * Whether and how this browser can record a canvas.
 */

/** @returns {string} the kind of WebM that it records; empty if it records none */
export function filmType() {
  if (typeof MediaRecorder === 'undefined' || !('captureStream' in HTMLCanvasElement.prototype)) return '';
  return ['video/webm;codecs=vp9', 'video/webm;codecs=vp8', 'video/webm'].find((type) => MediaRecorder.isTypeSupported(type)) ?? '';
}

/**
 * The last picture of a view, which stands in its place while its graphics context is given back: on paper, and for the
 * moment in which it scrolls in again.
 */
import { element } from '../../ui/dom.js';

/** @param {HTMLCanvasElement} canvas */
export function createPoster(canvas) {
  const poster = element('canvas', { class: 'poster', 'aria-hidden': 'true' });
  return {
    /** Keeps what has just been drawn. */
    keep() {
      Object.assign(poster, { width: canvas.width, height: canvas.height });
      poster.getContext('2d')?.drawImage(canvas, 0, 0);
      canvas.before(poster);
      canvas.style.visibility = 'hidden';
    },
    drop() {
      if (!poster.isConnected) return;
      canvas.style.visibility = '';
      poster.remove();
      // Its memory.
      poster.width = 0;
    },
  };
}

/**
 * Printing: the view is drawn once more for paper, sharper and in the light scheme, and keeps the shape that it has on the
 * screen, whatever room the paper gives it; style/print.css lays it out.
 */

/** @param {Pick<import('../element/workbench.js').App, 'find' | 'scene' | 'signal'>} app */
export function createPrinting({ find, scene, signal }) {
  if (!scene) return;
  const bench = find('bench');
  /** @param {boolean} on */
  const print = (on) => {
    const { clientWidth: width, clientHeight: height } = scene.canvas;
    bench.classList.toggle('printed', on && width > 0);
    bench.style.setProperty('--print-width', `${width}px`);
    bench.style.setProperty('--print-shape', `${width} / ${height}`);
    scene.print(on);
  };
  addEventListener('beforeprint', () => print(true), { signal });
  addEventListener('afterprint', () => print(false), { signal });
}

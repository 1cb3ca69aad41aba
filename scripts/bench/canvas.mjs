// The canvas's share of the window, as the page stands when it is opened.
import { LIMITS } from './limits.mjs';
import { planned } from './page.mjs';
import { percent } from './print.mjs';

/** @param {import('./page.mjs').Bench} bench @returns {Promise<import('./print.mjs').Bar[]>} */
export async function canvasShares(bench) {
  /** @type {import('./print.mjs').Bar[]} */
  const bars = [];
  for (const { width, height, share } of LIMITS.canvas) {
    const { context, page } = await bench.load({ viewport: { width, height }, reducedMotion: 'reduce' });
    await planned(page);
    const box = await page.locator('#canvas').boundingBox();
    bars.push({ what: `canvas's share of a window of ${width}×${height}`, value: ((box?.width ?? 0) * (box?.height ?? 0)) / (width * height), limit: share, least: true, write: percent });
    await context.close();
  }
  return bars;
}

// The first animated frame: from the navigation's start until the playhead has moved and been drawn, by the page's own
// clock; each load with an empty cache, from a server on this machine, in a browser whose window has been open for a while: one
// that has just opened it loads its own pages too.
import { LIMITS } from './limits.mjs';
import { median, noted } from './page.mjs';
import { milliseconds } from './print.mjs';

const LOADS = 7;

/** How long the window is open before, in ms. */
const SETTLED = 2500;

/** @param {import('./page.mjs').Bench} bench @returns {Promise<import('./print.mjs').Bar[]>} */
export async function firstFrame(bench) {
  /** @type {number[]} */
  const all = [];
  for (let i = 0; i < LOADS; i += 1) {
    const { context, page, moved } = await bench.load({}, SETTLED);
    await moved;
    all.push((await noted(page)).moved);
    await context.close();
  }
  const more = `median of ${LOADS} loads, ${Math.min(...all).toFixed(0)} to ${Math.max(...all).toFixed(0)}`;
  return [{ what: 'first animated frame', value: median(all), limit: LIMITS.firstFrame, write: milliseconds, more }];
}

// Script of a pointer move while something is dragged, at full speed and on a page four times slower.
//
// - Script: the growth of Chromium's own ScriptDuration (all script on the page's main thread, so handlers, store, tables,
//   drawing commands and the answers of the worker) from one pointer move until all that it caused is done. CPU throttling
//   slows the main thread. The picture itself is computed outside the main thread and is not counted.
// - Round trip: from a message to the planner's worker to its answer's arrival on the main thread, so with the wait for
//   a picture that is being drawn. Planning alone: what the worker says that a plan took, which throttling spares.
import { LIMITS } from './limits.mjs';
import { countersOf, noted, pause, planned, quantile } from './page.mjs';
import { milliseconds } from './print.mjs';

const MOVES = 60;
const SLOW = 4;

/** What is dragged. */
const DRAGS = [
  { what: /** @type {const} */ ('key frame'), place: 'motion.key_frames[1]', call: 'plan' },
  { what: /** @type {const} */ ('workpiece'), place: 'workpiece', call: 'pull' },
];

/** Selects a thing with the keyboard, as a person may: ] goes through the things. @param {import('./page.mjs').Page} page @param {string} place */
async function select(page, place) {
  await page.locator('#canvas').focus();
  const pointed = page.locator(`#canvas[data-hovered="${place}"]`);
  for (let i = 0; i < 60 && !(await pointed.count()); i += 1) await page.keyboard.press(']');
  await page.keyboard.press('Enter');
  await page.locator(`#canvas[data-hand]`).waitFor();
  const [x, y] = (await page.locator('#canvas').getAttribute('data-hand') ?? '').split(' ').map(Number);
  const box = await page.locator('#canvas').boundingBox();
  return { x: (box?.x ?? 0) + x, y: (box?.y ?? 0) + y };
}

/** @param {import('./page.mjs').Bench} bench @param {typeof DRAGS[number]} drag @param {number} rate */
async function move(bench, { place, call }, rate) {
  const { context, page } = await bench.load({ reducedMotion: 'reduce' });
  await planned(page);
  const at = await select(page, place);
  const { devtools, script, throttle } = await countersOf(page);
  await throttle(rate);
  await page.mouse.move(at.x, at.y);
  await page.mouse.down();
  // Not by Playwright's mouse, which runs a script in the page at every move.
  const to = (/** @type {number} */ x, /** @type {number} */ y) => devtools.send('Input.dispatchMouseEvent', { type: 'mouseMoved', x, y, button: 'left', buttons: 1 });
  await to(at.x + 8, at.y);
  await pause(500);
  const { calls: earlier } = await noted(page);
  /** @type {number[]} */
  const times = [];
  for (let i = 0; i < MOVES; i += 1) {
    const angle = (i / MOVES) * 4 * Math.PI;
    const before = await script();
    await to(at.x + 8 + 30 * Math.sin(angle), at.y + 30 * (1 - Math.cos(angle)));
    await pause(60 * rate);
    times.push((await script()) - before);
  }
  const { calls } = await noted(page);
  await page.mouse.up();
  await context.close();
  /** @type {{call: string, ms: number, planning?: number}[]} */
  const done = calls.slice(earlier.length).filter((/** @type {{call: string}} */ answer) => answer.call === call);
  const planning = done.map((answer) => answer.planning ?? NaN).filter((ms) => !Number.isNaN(ms));
  return { script: times, trip: done.map(({ ms }) => ms), planning };
}

/** @param {number[]} values */
const both = (values) => (values.length ? `${quantile(values, 0.5).toFixed(1)} (${quantile(values, 0.95).toFixed(1)})` : '–').padStart(15);

/** @param {import('./page.mjs').Bench} bench @returns {Promise<import('./print.mjs').Bar[]>} */
export async function moves(bench) {
  /** @type {import('./print.mjs').Bar[]} */
  const bars = [];
  console.log('\n  per pointer move, ms, median (95 %)                    script      round trip  planning alone');
  for (const drag of DRAGS) {
    for (const rate of [1, SLOW]) {
      const { script, trip, planning } = await move(bench, drag, rate);
      console.log(`  ${`${drag.what}, ${rate === 1 ? 'full speed' : `${rate} times slower`}`.padEnd(44)} ${both(script)} ${both(trip)} ${both(planning)}`);
      if (rate === 1) continue;
      bars.push({ what: `script of a move of the ${drag.what}, 95 %, at ${rate}×`, value: quantile(script, 0.95), limit: LIMITS.move[drag.what], write: milliseconds });
    }
  }
  return bars;
}

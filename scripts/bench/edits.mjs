// Script of an edit: a number is typed into a cell and kept with Enter, in a document with many key frames and in the same
// one with three, until the page has shown all that the edit caused; planning in the worker is not counted.
import { readFileSync } from 'node:fs';
import { LIMITS } from './limits.mjs';
import { countersOf, median, noted, pause, planned } from './page.mjs';
import { milliseconds, times } from './print.mjs';

const FEW = 3;
const MANY = 1000;
const EDITS = 9;
/** The first edits are made by code that the browser has not compiled yet. */
const WARM_UP = 4;
/** So many ms without script, and all is done: the work is kept for the next visit 400 ms after an edit. */
const STILL = 600;
/** What a digit adds to a number: the way stays the same but for this. */
const STEP = 0.0005;

/** The cells that are typed into, and their panels. */
const CELLS = [
  { what: 'a key frame', path: 'motion.key_frames[1].x', panel: 'Motion' },
  { what: 'a chain', path: 'chains[0].base.x', panel: 'Mechanism' },
];

/**
 * The sample with so many key frames on the straight way through its own.
 * @param {number} count
 */
export function withKeyFrames(count) {
  const doc = JSON.parse(readFileSync('www/mechanisms/3rps.json', 'utf8'));
  const own = doc.motion.key_frames;
  const between = (/** @type {number} */ at) => {
    const from = Math.min(own.length - 2, Math.floor(at));
    const numbers = Object.entries(own[from]).filter(([, value]) => typeof value === 'number');
    return Object.fromEntries(numbers.map(([field, value]) => [field, value + (own[from + 1][field] - value) * (at - from)]));
  };
  doc.motion.key_frames = Array.from({ length: count }, (_, i) => between((i * (own.length - 1)) / (count - 1)));
  return doc;
}

/** ms of script of each edit. @param {import('./page.mjs').Bench} bench @param {number} count of key frames @param {{path: string, panel: string}} cell */
export async function edits(bench, count, { path, panel }) {
  const { context, page } = await bench.load({ reducedMotion: 'reduce' });
  await planned(page);
  await page.evaluate((doc) => {
    /** @type {any} */ (document.querySelector('synthetica-linkage')).document = doc;
  }, withKeyFrames(count));
  await page.waitForFunction(async (n) => {
    const { store } = await /** @type {any} */ (document.querySelector('synthetica-linkage')).workbench;
    return store.result.doc?.motion.key_frames?.length === n;
  }, count);
  await page.getByRole('tab', { name: panel, exact: true }).click();
  const cell = page.locator(`[data-path="${path}"]`);
  await cell.waitFor();
  const first = Number((await cell.getAttribute('title')) || (await cell.inputValue()));
  const { script } = await countersOf(page);
  const still = async () => {
    let now = await script();
    for (let before = -1; now !== before || (await noted(page)).open > 0; ) {
      await pause(STILL);
      [before, now] = [now, await script()];
    }
    return now;
  };
  /** @type {number[]} */
  const all = [];
  for (let i = 0; i < WARM_UP + EDITS; i += 1) {
    const before = await still();
    await cell.focus();
    await page.keyboard.type((first + STEP * (1 + (i % 7))).toFixed(4));
    await page.keyboard.press('Enter');
    all.push((await still()) - before);
  }
  await context.close();
  return all.slice(WARM_UP);
}

/** @param {import('./page.mjs').Bench} bench @returns {Promise<import('./print.mjs').Bar[]>} */
export async function editRatios(bench) {
  /** @type {import('./print.mjs').Bar[]} */
  const bars = [];
  for (const cell of CELLS) {
    const few = median(await edits(bench, FEW, cell));
    const many = median(await edits(bench, MANY, cell));
    bars.push({ what: `edit of ${cell.what} with ${MANY} key frames against ${FEW}`, value: many / few, limit: LIMITS.edit, write: times, more: `${milliseconds(many)} against ${milliseconds(few)}` });
  }
  return bars;
}

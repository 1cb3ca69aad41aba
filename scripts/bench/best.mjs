// The search for the best motion: how long it takes for each sample, as the panel asks for it, and what it costs a plan that is
// made meanwhile, with the view paused.
//
// - Search: from the question to the worker to its answer, so with the document's opening and the plan of the followed motion.
//   The worker is loaded before. Samples whose joints are driven have no goals.
// - Plan: from the question to its answer, of another linkage on the same page, in turns with a search that runs and without.
import { readdirSync, readFileSync } from 'node:fs';
import { LIMITS } from './limits.mjs';
import { median, noted, pause, planned, quantile } from './page.mjs';
import { milliseconds, times } from './print.mjs';

/** @typedef {import('./page.mjs').Page} Page */

const FRAMES = 129;
const SEARCHES = 5;
/** A search that goes on while plans are made, and the plans: long enough for the browser's coarse clock. */
const LONG_SEARCH = { sample: 'hexapod', frames: 20_001 };
const PLAN = { sample: '2tpr', frames: 4097 };
/** Turns without and with a search, and the plans of each. */
const TURNS = 8;
const PLANS = 5;
/** ms after which a motion that was planned is drawn, charted and kept. */
const STILL = 2000;

/** @param {string} name @param {number} frames @param {string} [suffix] a document of another name is searched anew */
function sample(name, frames, suffix = '') {
  const doc = JSON.parse(readFileSync(`www/mechanisms/${name}.json`, 'utf8'));
  return { ...doc, name: doc.name + suffix, motion: { ...doc.motion, frames } };
}

const names = () => readdirSync('www/mechanisms').filter((name) => name.endsWith('.json') && name !== 'index.json').map((name) => name.slice(0, -'.json'.length));

/** Gives a linkage a document, and waits for its motion. @param {Page} page @param {object} doc @param {string} which selector */
const plan = (page, doc, which = 'synthetica-linkage') =>
  page.evaluate(
    async ({ doc, which }) => {
      const element = /** @type {any} */ (document.querySelector(which));
      const { store } = await element.workbench;
      const is = () => store.result.doc?.name === doc.name && store.result.motion?.frames === doc.motion.frames;
      await new Promise((resolve) => {
        store.subscribe('result', () => is() && resolve(null));
        element.document = doc;
      });
    },
    { doc, which },
  );

/** Presses a button; the other linkage may lie over it. @param {Page} page @param {RegExp} name */
const press = (page, name) => page.getByRole('button', { name }).dispatchEvent('click');
const BEGIN = /^(Look for a better motion|Go on searching)$/;

/** ms of the answers to one kind of question. @param {Page} page @param {string} call */
const answers = async (page, call) => (await noted(page)).calls.filter((/** @type {{call: string}} */ answer) => answer.call === call).map((/** @type {{ms: number}} */ { ms }) => ms);

/** ms of the search of a document. @param {Page} page @param {object} doc */
async function search(page, doc) {
  await plan(page, doc);
  const { length } = await answers(page, 'best');
  await press(page, BEGIN);
  await page.waitForFunction((n) => /** @type {any} */ (globalThis).noted.calls.filter((/** @type {{call: string}} */ { call }) => call === 'best').length > n, length, { polling: 50 });
  return (await answers(page, 'best'))[length];
}

/** @param {import('./page.mjs').Bench} bench */
async function open(bench) {
  const { context, page } = await bench.load({ reducedMotion: 'reduce' });
  await planned(page);
  await page.evaluate(() => localStorage.setItem('synthetica.dock', JSON.stringify({ ...JSON.parse(localStorage.getItem('synthetica.dock') ?? '{}'), search: false })));
  await page.reload();
  await planned(page);
  const fold = page.getByRole('button', { name: 'Charts and algorithm' });
  if ((await fold.getAttribute('aria-expanded')) === 'false') await fold.click();
  await page.getByRole('tab', { name: 'Best motion' }).click();
  await page.getByRole('button', { name: 'Look for a better motion' }).waitFor();
  return { context, page };
}

/** @param {import('./page.mjs').Bench} bench @returns {Promise<import('./print.mjs').Bar[]>} */
export async function best(bench) {
  /** @type {import('./print.mjs').Bar[]} */
  const bars = [];
  const { context, page } = await open(bench);
  await search(page, sample('3rps', FRAMES, ' loaded'));
  for (const name of names()) {
    if (sample(name, FRAMES).motion.drivers) continue;
    /** @type {number[]} */
    const all = [];
    for (let i = 0; i < SEARCHES; i += 1) all.push(await search(page, sample(name, FRAMES, ` ${i}`)));
    bars.push({ what: `best motion of ${name}, ${FRAMES} frames`, value: median(all), limit: LIMITS.best, write: milliseconds, more: `${milliseconds(Math.min(...all))} to ${milliseconds(Math.max(...all))}` });
  }

  await page.evaluate(() => document.body.insertAdjacentHTML('beforeend', '<synthetica-linkage id="other" style="position: fixed; inset: auto auto 0 0; width: 120px; height: 90px"></synthetica-linkage>'));
  /** @type {number[][]} */
  const [alone, beside] = [[], []];
  const stop = page.getByRole('button', { name: 'Stop the search' });
  let made = 0;
  /** ms of a plan of the other linkage. */
  const other = async () => {
    await plan(page, sample(PLAN.sample, PLAN.frames, ` ${(made += 1)}`), '#other');
    return (await answers(page, 'plan')).at(-1);
  };
  await other();
  for (let turn = 0; turn < TURNS; turn += 1) {
    for (let i = 0; i < PLANS; i += 1) alone.push(await other());
    while (beside.length < alone.length) {
      if (!(await stop.isVisible())) {
        await plan(page, sample(LONG_SEARCH.sample, LONG_SEARCH.frames, ` ${made}`));
        // What is drawn of so many frames is no part of the search.
        await pause(STILL);
        await press(page, BEGIN);
        await pause(100);
      }
      const ms = await other();
      if (await stop.isVisible()) beside.push(ms);
    }
    if (await stop.isVisible()) await stop.dispatchEvent('click');
    await pause(STILL);
  }
  await context.close();
  bars.push({ what: 'plan while a search runs against alone', value: median(beside) / median(alone), limit: LIMITS.planBeside, write: times, more: `${milliseconds(median(beside))} (95 %: ${milliseconds(quantile(beside, 0.95))}) against ${milliseconds(median(alone))} (${milliseconds(quantile(alone, 0.95))})` });
  return bars;
}

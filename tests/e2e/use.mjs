// Rounds of use, each the same, and what the page holds after each: for the test that nothing is left behind, and for the bench.
import { cell, doTo, openSample } from './browser.mjs';

/** Two documents in turn: each takes the place of the other. */
const SAMPLES = ['2tpr.json', '3rps.json'];

const still = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 50)))));

/** A thing in hand is dragged there and back. */
async function drag(page) {
  await page.locator('#canvas').focus();
  const pointed = page.locator('#canvas[data-hovered="motion.key_frames[1]"]');
  for (let i = 0; i < 60 && !(await pointed.count()); i += 1) await page.keyboard.press(']');
  await page.keyboard.press('Enter');
  await page.locator('#canvas[data-hand]').waitFor();
  await still(page);
  const [x, y] = (await page.locator('#canvas').getAttribute('data-hand')).split(' ').map(Number);
  const box = await page.locator('#canvas').boundingBox();
  await page.mouse.move(box.x + x, box.y + y);
  await page.mouse.down();
  for (const step of [8, 16, 24, 16]) {
    await page.mouse.move(box.x + x + step, box.y + y - step);
    await still(page);
  }
  await page.mouse.up();
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Escape');
}

/** A number is typed into a cell, and taken back. */
async function type(page, panel, path, text) {
  await page.getByRole('tab', { name: panel, exact: true }).click();
  await cell(page, path).click();
  await page.keyboard.type(text);
  await page.keyboard.press('Enter');
  await still(page);
  await page.keyboard.press('Control+z');
}

/** A person's round through the page: what is opened is closed, what is changed is taken back. */
export async function useOnce(page) {
  for (const sample of SAMPLES) {
    await openSample(page, sample);
    await page.locator('#play').click();
    await page.waitForTimeout(500);
    await page.locator('#play').click();
    await type(page, 'Motion', 'motion.key_frames[0].x', '0.3');
    await type(page, 'Mechanism', 'chains[0].base.x', '-0.49');
    await doTo(page, 'chain 1', 'Duplicate');
    await doTo(page, 'chain 2', 'Remove');
    await still(page);
    for (let undone = 0; undone < 2; undone += 1) await page.keyboard.press('Control+z');
    await drag(page);
  }
  for (const panel of ['Teach', 'Types', 'Motion', 'Mechanism']) await page.getByRole('tab', { name: panel, exact: true }).click();
  for (const fold of ['#fold-tables', '#fold-info', '#dock-toggle']) {
    await page.locator(fold).click();
    await page.locator(fold).click();
  }
  await page.getByRole('button', { name: 'Share', exact: true }).click();
  await page.locator('dialog[open]').waitFor();
  await page.keyboard.press('Escape');
  await page.locator('dialog').waitFor({ state: 'detached' });
  await page.locator('#canvas').focus();
  await page.keyboard.press('?');
  await page.locator('dialog[open]').waitFor();
  await page.keyboard.press('Escape');
  await page.locator('dialog').waitFor({ state: 'detached' });
  await elementOnce(page);
}

/** An element is put into the page and taken out again. */
async function elementOnce(page) {
  await page.evaluate(() => {
    const guest = document.createElement('synthetica-linkage');
    guest.document = document.querySelector('synthetica-linkage').document;
    guest.className = 'guest';
    guest.style.cssText = 'position: fixed; left: 0; top: 0; width: 200px; height: 150px; z-index: 9';
    document.body.append(guest);
  });
  await page.waitForFunction(() => document.querySelector('.guest').shadowRoot.querySelector('#canvas')?.dataset.draws > 0);
  await page.evaluate(() => document.querySelector('.guest').remove());
}

/** What the page holds, when its garbage is collected: bytes of the heap, nodes, listeners. */
export async function heldBy(devtools) {
  // What waits for its end, as what a closed dialog still does.
  await new Promise((done) => setTimeout(done, 700));
  for (let times = 0; times < 2; times += 1) await devtools.send('HeapProfiler.collectGarbage');
  const { metrics } = await devtools.send('Performance.getMetrics');
  const of = (wanted) => metrics.find(({ name }) => name === wanted).value;
  return { heap: of('JSHeapUsedSize'), nodes: of('Nodes'), listeners: of('JSEventListeners') };
}

/**
 * What each round leaves behind: of all pairs of rounds the middle slope, which single outliers do not move.
 * @param {{heap: number, nodes: number, listeners: number}[]} held after each round
 */
export function growthOf(held) {
  const middle = (what) => {
    const slopes = held.flatMap((one, at) => held.slice(at + 1).map((other, on) => (other[what] - one[what]) / (on + 1)));
    return slopes.sort((a, b) => a - b)[slopes.length >> 1];
  };
  return { heap: middle('heap'), nodes: middle('nodes'), listeners: middle('listeners') };
}

/**
 * Rounds of use of a page whose first motion is planned. The first rounds load what is loaded when it is wanted, and are not
 * counted.
 * @param {import('playwright-core').Page} page
 * @param {{before: number, rounds: number, until?: number, round?: () => Promise<void>}} how `until`: a time after which no
 *   round begins; `round`: what is done in one
 */
export async function useRounds(page, { before, rounds, until = Infinity, round = () => useOnce(page) }) {
  const devtools = await page.context().newCDPSession(page);
  await devtools.send('Performance.enable');
  const held = [];
  for (let done = 0; done < before + rounds && Date.now() < until; done += 1) {
    await round();
    if (done >= before) held.push(await heldBy(devtools));
  }
  return held;
}

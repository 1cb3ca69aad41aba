// What holds the workpiece back, drawn in the view where it acts, and the freedoms of the workpiece.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { openBrowser, scrubTo } from './browser.mjs';
import { LINKAGE, openGuestPage, planned } from './guest-page.mjs';
import { convertLengths } from '../../www/core/units.js';

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

const WIDE = { viewport: { width: 1280, height: 800 } };
const shows = (page, names, value) => page.waitForFunction(([name, wanted]) => page$('#canvas').dataset[name] === wanted, [names, value]);

/** Texts and places of the names of the wrenches, as they are drawn. */
const named = (page) => page.locator('#labels [data-place$=".wrench"]').evaluateAll((tags) => tags.map((tag) => [tag.textContent, ...tag.style.transform.match(/-?[\d.]+/g).map(Number)]));

const drawn = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));

async function choose(page, name) {
  await page.getByRole('button', { name: 'Show' }).click();
  await page.getByRole('menuitemcheckbox', { name }).click();
  // The button hears a little later that its menu is closed.
  await drawn(page);
}

test('nothing of it is loaded before a person does something; then each chain’s wrench stands there with its share and in the legend', async () => {
  const { page, problems } = await browser.openPage(WIDE);
  const scripts = [];
  page.on('request', (request) => scripts.push(request.url()));
  // Set by a program: the playhead rests where there is a gap, and why is known.
  await page.evaluate(() => (document.querySelector('synthetica-linkage').parts.player.frame = 60));
  await page.waitForFunction(() => page$('.shares li'));
  assert.deepEqual(scripts.filter((url) => /holds/.test(url)), []);
  await page.keyboard.press('Shift');
  await shows(page, 'wrenches', '0,1,2');
  assert.equal(scripts.filter((url) => /holds/.test(url)).length, 1);
  const shares = await page.locator('.shares strong').allTextContents();
  assert.deepEqual((await named(page)).map(([text]) => text), shares.map((share, i) => `chain ${i + 1} ${share}`));
  await page.locator('#legend').getByText('→ force that holds it back').waitFor();

  // A row that is pointed at, and a thing of the view.
  await page.locator('.shares li').nth(1).locator('button').hover();
  await shows(page, 'lit', '1');
  await page.locator('.shares li').nth(2).locator('button').focus();
  await shows(page, 'lit', '2');
  await page.mouse.move(5, 5);
  await page.locator('#canvas').focus();
  await shows(page, 'lit', '');

  // Where the goal is met nothing holds it back.
  await scrubTo(page, 0);
  await shows(page, 'wrenches', '');
  await page.locator('#legend').getByText('force that holds it back').waitFor({ state: 'detached' });
  await scrubTo(page, 60);
  await shows(page, 'wrenches', '0,1,2');
  // While it moves there is none.
  await page.evaluate(() => document.querySelector('synthetica-linkage').play());
  await shows(page, 'wrenches', '');
  await page.evaluate(() => document.querySelector('synthetica-linkage').pause());
  await scrubTo(page, 60);
  await shows(page, 'wrenches', '0,1,2');
  await choose(page, 'Freedoms');
  await shows(page, 'freedoms', '3');
  await page.locator('#legend').getByText('↔ freedom of the workpiece').waitFor();
  await choose(page, 'What holds it back');
  await shows(page, 'wrenches', '');
  await shows(page, 'freedoms', '3');
  assert.deepEqual(problems, []);
});

test('in millimetres, and far from the origin, the wrenches stand at the same places of the picture', async () => {
  const { page, problems } = await browser.openPage(WIDE);
  const sample = JSON.parse(readFileSync(new URL('../../www/mechanisms/3rps.json', import.meta.url), 'utf8'));
  const { metric_length: length, ...planner } = sample.planner;
  const millimetres = { ...convertLengths(sample, 1000, 'mm'), planner: { ...planner, metric_length: 1000 * length } };
  const away = (frame) => ({ ...frame, x: (frame.x ?? 0) + 1000, y: (frame.y ?? 0) - 500 });
  const far = {
    ...sample,
    planner: { ...sample.planner, metric_origin: [1000, -500, 0] },
    chains: sample.chains.map((chain) => ({ ...chain, base: away(chain.base ?? {}) })),
    motion: { ...sample.motion, reference: (sample.motion.reference ?? [0, 0, 0]).map((value, i) => value + [1000, -500, 0][i]), key_frames: sample.motion.key_frames.map(away) },
  };
  await scrubTo(page, 60);
  await page.keyboard.press('Shift');
  await shows(page, 'wrenches', '0,1,2');
  const before = await named(page);
  for (const [name, doc] of Object.entries({ millimetres, far })) {
    await page.evaluate((next) => document.querySelector('synthetica-linkage').parts.store.edit(() => next), doc);
    await page.waitForFunction(() => {
      const { store } = document.querySelector('synthetica-linkage').parts;
      return store.result.doc === store.doc && store.why?.of.doc === store.result.doc;
    });
    await page.locator('#fit').click();
    await shows(page, 'wrenches', '0,1,2');
    await drawn(page);
    (await named(page)).forEach(([text, x, y], i) => {
      assert.equal(text, before[i][0], name);
      assert.ok(Math.abs(x - before[i][1]) < 1 && Math.abs(y - before[i][2]) < 1, `${name}: ${text} at ${x}, ${y}, before at ${before[i]}`);
    });
  }
  assert.deepEqual(problems, []);
});

test('in another page a press beside the linkage loads nothing; one on it does', async () => {
  const body = `<p id="beside">beside</p>${LINKAGE.replace(' src', ' panels="info" src')}`;
  const { page, problems } = await openGuestPage(browser, body, { viewport: { width: 1000, height: 700 } });
  const scripts = [];
  page.on('request', (request) => scripts.push(request.url()));
  await planned(page);
  await page.locator('#beside').click();
  await page.evaluate(() => (document.querySelector('synthetica-linkage').currentTime = 0.3));
  await page.waitForFunction(() => page$('.shares li'));
  assert.deepEqual(scripts.filter((url) => /holds/.test(url)), []);
  await page.locator('.shares li').first().click();
  await page.waitForFunction(() => page$('#canvas').dataset.wrenches);
  assert.equal(scripts.filter((url) => /holds/.test(url)).length, 1);
  assert.deepEqual(problems, []);
});

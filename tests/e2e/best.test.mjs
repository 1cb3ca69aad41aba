// The best motion: a search beside the plans, what it finds as lanes, numbers, line and ghost, and how much calmer it may be.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { goldenDocument } from './golden.mjs';
import { cell, number, openBrowser, openSample, scrubTo, text, unfoldCharts } from './browser.mjs';

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

const DESK = { viewport: { width: 1280, height: 800 } };
const panel = (page) => page.getByRole('tabpanel', { name: 'Best motion' });
const better = (page) => page.locator('#better');
const shown = (page, name) => panel(page).getByRole('radio', { name, exact: true });
/** The frame at which the ghost stands; '' for none. */
const ghost = (page) => page.locator('#canvas').getAttribute('data-best');

/** 3PRS, of which a better motion of the same assembly is known. */
async function openGolden(options = DESK) {
  const { page, problems } = await browser.openPage(options);
  await page.evaluate((doc) => {
    document.querySelector('synthetica-linkage').document = doc;
  }, goldenDocument('3PRS'));
  await page.locator('#frame-number').filter({ hasText: '/ 33' }).waitFor();
  return { page, problems };
}

async function openPanel(page) {
  await unfoldCharts(page);
  await page.getByRole('tab', { name: 'Best motion' }).click();
  await panel(page).getByRole('button', { name: /^(Look for a better motion|Stop the search)$/ }).waitFor();
}

async function search(page) {
  await openPanel(page);
  await panel(page).getByRole('button', { name: 'Look for a better motion' }).click();
  await isComplete(page);
}
const isComplete = (page) => panel(page).getByRole('button', { name: 'Look for a better motion' }).and(page.locator(':disabled')).waitFor({ timeout: 180_000 });

test('a better motion is found, told in numbers and words, and shown as a ghost or in place of the followed one', async () => {
  const { page, problems } = await openGolden();
  await search(page);
  assert.match(await panel(page).locator('.best-verdict').textContent(), /^A motion with \d+ switch(es)? to another branch is closer on average by \d+ %\.$/);
  const words = await panel(page).locator('.best-body').textContent();
  assert.match(words, /No motion over the branches known is closer on average than [\d.e−]+/);
  assert.match(words, /\d+ starts made, \d+ branches found\. .*further starts would find another/);
  // Of the numbers the best one's mean and largest distance are less.
  const row = async (name) => (await panel(page).getByRole('row', { name: new RegExp(`^${name}`) }).first().getByRole('cell').allTextContents()).map(number);
  for (const name of ['mean distance', 'largest distance']) {
    const [followed, best] = await row(name);
    assert.ok(best < followed, `${name}: ${best} for ${followed}`);
  }
  assert.equal(number(String((await row('largest distance'))[0])), 0.0359);

  await scrubTo(page, 16);
  await better(page).filter({ hasText: /^A better pose exists: [\d.]+ instead of 0\.03\d+\. Show it$/ }).waitFor();
  assert.equal(await ghost(page), '');
  await better(page).getByRole('button', { name: 'Show it' }).click();
  await page.locator('#canvas[data-best="16"]').waitFor();
  assert.ok(await shown(page, 'both').isChecked());
  await page.locator('#legend').filter({ hasText: 'best motion' }).waitFor();
  const followed = number(await text(page, 'metric'));

  await shown(page, 'best').check();
  await page.locator('#best-shown').filter({ hasText: 'The best motion is shown.' }).waitFor();
  assert.ok(number(await text(page, 'metric')) < followed - 1e-3, 'its numbers stand in the panels');
  assert.equal(await ghost(page), '');
  await page.getByRole('button', { name: 'Back to the followed one' }).click();
  assert.equal(number(await text(page, 'metric')), followed);
  await better(page).getByRole('button', { name: 'Show it' }).waitFor();
  assert.equal(await page.locator('#strip-best .other').count(), 1);
  assert.equal(await page.locator('#strip-best .switch').count(), await panel(page).locator('button.switch').count());
  await scrubTo(page, 0);
  await better(page).waitFor({ state: 'hidden' });

  // The ways to assemble are counted apart.
  const branches = await panel(page).getByRole('img', { name: /branches over the frames/ }).getAttribute('aria-label');
  await panel(page).getByRole('button', { name: 'Ways to assemble…' }).click();
  const dialog = page.getByRole('dialog', { name: 'Ways to assemble' });
  await dialog.locator('.best-mode').waitFor({ timeout: 180_000 });
  await dialog.getByText(new RegExp(`The search for the best motion knows ${/^\d+/.exec(branches)} branches, \\d+ of them at this key frame: it makes its own starts, over all frames\\.$`)).waitFor();
  assert.deepEqual(problems, []);
});

test('lanes, switches and the slider go by keyboard, and are a table too', async () => {
  const { page, problems } = await openGolden();
  await search(page);
  const lanes = panel(page).locator('.lane-names button');
  assert.match(await lanes.first().textContent(), /^followed( best)?: frames 1 to 33, mean distance [\d.]+/);
  const change = panel(page).locator('button.switch').first();
  const [, frame] = /^(?:Before frame|At the start)(?: (\d+))?: from the followed branch to branch \d+, joint motion/.exec(await change.getAttribute('aria-label'));
  await change.focus();
  await page.keyboard.press('Enter');
  if (frame) assert.match(await text(page, 'frame-number'), new RegExp(`^${frame} /`));
  // In line with the strip above.
  const [strip, plot] = await Promise.all(['#strip', '.lane-plot svg'].map((one) => page.locator(one).boundingBox()));
  assert.ok(Math.abs(strip.x - plot.x) < 2 && Math.abs(strip.width - plot.width) < 2, 'frames stand below frames');
  // A click of the locator scrolls: the lowest lanes may be below what is seen.
  await panel(page).locator('.lane-plot svg').click({ position: { x: plot.width / 2, y: plot.height - 8 } });
  assert.match(await text(page, 'frame-number'), /^17 \//);

  const slider = panel(page).getByRole('slider', { name: 'From closer to calmer' });
  await slider.focus();
  const first = await slider.getAttribute('aria-valuetext');
  await page.keyboard.press('ArrowRight');
  await page.locator('#canvas[data-best="16"]').waitFor();
  const next = await slider.getAttribute('aria-valuetext');
  const step = (words) => number(/largest joint step ([\d.]+) rad or sizes$/.exec(words)[1]);
  assert.ok(step(next) <= step(first), `${next} after ${first}`);
  await panel(page).locator('output[aria-busy="false"]').waitFor();
  await panel(page).getByRole('columnheader', { name: 'calmer' }).waitFor();
  // A calmer motion is not called the best one anywhere, and there is a way back to that.
  assert.equal(await shown(page, 'best').count(), 0);
  await page.locator('#legend').filter({ hasText: 'calmer motion' }).waitFor();
  await panel(page).getByText('Marks and switches are those of the best motion').waitFor();
  assert.equal(await page.locator('#strip-best .switch').count(), 0);
  await shown(page, 'calmer').check();
  const pill = page.locator('#best-shown');
  await pill.filter({ hasText: /^A calmer motion is shown: mean [\d.e−]+ \(best [\d.e−]+\), largest joint step [\d.]+ rad or sizes \(best [\d.]+\)\. Show the best one Back to the followed one$/ }).waitFor();
  // Its frames are no closest poses: nothing is said to hold them back.
  await page.locator('#why-title').filter({ hasText: 'What is free here' }).waitFor();
  assert.equal(await page.locator('#why .shares').count(), 0);
  assert.equal(await page.locator('#canvas').getAttribute('data-wrenches'), '');
  await pill.getByRole('button', { name: 'Show the best one' }).click();
  await pill.filter({ hasText: 'The best motion is shown.' }).waitFor();
  assert.ok(await shown(page, 'best').isChecked());
  assert.notEqual(await page.locator('#strip-best .switch').count(), 0);
  assert.ok(await panel(page).getByText('Marks and switches are those of the best motion').isHidden());
  await slider.focus();
  await page.keyboard.press('ArrowRight');
  await pill.filter({ hasText: 'A calmer motion' }).waitFor();
  await page.keyboard.press('Tab');
  await panel(page).locator('summary').filter({ hasText: 'Table' }).click();
  const tables = panel(page).getByRole('region', { name: 'Branches, switches and calmer motions' });
  assert.equal(await tables.getByRole('table').count(), 3);
  assert.ok((await tables.getByRole('table', { name: 'Branches' }).getByRole('row').count()) > 2);
  await slider.focus();
  await page.keyboard.press('Home');
  await panel(page).locator('output').filter({ hasText: 'The best motion itself' }).waitFor();
  assert.deepEqual(problems, []);
});

test('a plan is not held up, partial results are shown, and an edit ends the search quietly', async () => {
  const { page, problems } = await openGolden();
  await page.evaluate((doc) => {
    document.querySelector('synthetica-linkage').document = doc;
  }, goldenDocument('3PRS', 513));
  await page.locator('#frame-number').filter({ hasText: '/ 513' }).waitFor();
  await openPanel(page);
  await panel(page).getByRole('button', { name: 'Look for a better motion' }).click();
  await panel(page).getByRole('progressbar', { name: 'Search for a better motion' }).waitFor();
  await panel(page).locator('.lane-names button').first().waitFor();
  const stop = panel(page).getByRole('button', { name: 'Stop the search' });
  assert.ok(await stop.isVisible(), 'lanes are there while it goes on');
  await stop.click();
  await panel(page).getByRole('button', { name: 'Go on searching' }).click();
  await stop.waitFor();
  await page.getByRole('tab', { name: 'Motion', exact: true }).click();
  await cell(page, 'motion.frames').fill('65');
  await page.locator('#frame-number').filter({ hasText: '/ 65' }).waitFor();
  await panel(page).getByRole('button', { name: 'Look for a better motion' }).waitFor();
  assert.equal(await panel(page).locator('.lane-names button').count(), 0, 'what was found went with its document');
  assert.ok(await better(page).isHidden());
  assert.deepEqual(await page.locator('#notices p').allTextContents(), []);
  assert.deepEqual(problems, []);
});

test('files are of the motion that is shown, and what is saved and refused is told once', async () => {
  const { page, problems } = await openGolden();
  await search(page);
  const items = () => page.getByRole('menuitem');
  const openMenu = async () => {
    await page.getByRole('button', { name: 'Export', exact: true }).click();
    await items().first().waitFor();
  };
  await shown(page, 'best').check();
  await openMenu();
  assert.equal(await items().filter({ hasText: 'The best motion switches while a frame stands: choose a calmer one' }).count(), 1);
  await items().filter({ hasText: /^MuJoCo model with gravity.*Nor with gravity, for the same reason$/ }).and(page.locator('[aria-disabled="true"]')).waitFor();
  await page.keyboard.press('Escape');
  // Beside a ghost the file has the followed motion, and says so before and after.
  await shown(page, 'both').check();
  for (const [item, name] of [[/^Table \(CSV\)/, '3prs.csv'], [/^Playing page/, '3prs.html']]) {
    await openMenu();
    assert.match(await items().filter({ hasText: item }).textContent(), /It has the followed motion, not the best one beside it\./);
    const [download] = await Promise.all([page.waitForEvent('download'), items().filter({ hasText: item }).click()]);
    assert.equal(download.suggestedFilename(), name);
    await page.getByRole('status').filter({ hasText: new RegExp(`^Saved ${name}.*It has the followed motion, not the best one beside it\\.$`) }).waitFor();
  }
  await shown(page, 'followed').check();
  await openMenu();
  assert.equal(await items().filter({ hasText: 'It has the followed motion' }).count(), 0);
  await items().filter({ hasText: /^Table \(CSV\)/ }).click();
  await page.getByRole('status').filter({ hasText: /^Saved 3prs\.csv\.$/ }).waitFor();
  assert.deepEqual(problems, []);
});

test('a double click begins a search and does not stop it, and opens the ways to assemble and does not close them', async () => {
  const { page, problems } = await openGolden();
  await page.evaluate((doc) => {
    document.querySelector('synthetica-linkage').document = doc;
  }, goldenDocument('3PRS', 10_001));
  await page.locator('#frame-number').filter({ hasText: '/ 10001' }).waitFor();
  await openPanel(page);
  const begin = panel(page).getByRole('button', { name: 'Look for a better motion' });
  const stop = panel(page).getByRole('button', { name: 'Stop the search' });
  const { x } = await begin.boundingBox();
  await begin.dblclick();
  await stop.waitFor();
  assert.equal((await begin.boundingBox()).x, x);
  assert.equal(await begin.getAttribute('aria-disabled'), 'true');
  await panel(page).locator('.lane-names button').first().waitFor();
  await stop.dblclick();
  const on = panel(page).getByRole('button', { name: 'Go on searching' });
  await on.waitFor();
  assert.ok(await stop.isHidden());
  await on.press('Enter');
  await stop.press('Enter');
  await on.waitFor();
  assert.ok(await on.evaluate((button) => button === pageFocus()), 'the focus is not lost with the button');
  // As two quick presses in one place: the dialog is there at the second one.
  const ways = panel(page).getByRole('button', { name: 'Ways to assemble…' });
  const box = await ways.boundingBox();
  await ways.click();
  const dialog = page.getByRole('dialog', { name: 'Ways to assemble' });
  await dialog.waitFor();
  await page.mouse.move(box.x + 5, box.y + 5);
  await page.mouse.down({ clickCount: 2 });
  await page.mouse.up({ clickCount: 2 });
  assert.ok(await dialog.isVisible());
  await page.keyboard.press('Escape');
  await dialog.waitFor({ state: 'detached' });
  assert.deepEqual(problems, []);
});

test('in the applet it is looked for by itself, when all rests', async () => {
  const { page, problems } = await openGolden({ ...DESK, search: true });
  await scrubTo(page, 16);
  await better(page).filter({ hasText: 'A better pose exists' }).waitFor({ timeout: 180_000 });
  // What draws it may not be there yet.
  assert.ok(!(await ghost(page)), 'nothing is shown that was not asked for');
  assert.deepEqual(problems, []);
});

test('on a phone, in the dark, all of it is there', async () => {
  const { page, problems } = await openGolden({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, colorScheme: 'dark' });
  await page.getByRole('tab', { name: 'Best motion' }).click();
  await panel(page).getByRole('button', { name: 'Look for a better motion' }).click();
  await isComplete(page);
  const width = await page.evaluate(() => document.documentElement.scrollWidth);
  assert.ok(width <= 390, `no wider than the screen: ${width}`);
  for (const name of await panel(page).locator('.lane-names button').all()) assert.ok((await name.boundingBox()).x >= 0, 'its name is seen');
  for (const button of await panel(page).locator('.lanes button').all()) {
    const { width: wide, height } = await button.boundingBox();
    assert.ok(wide >= 32 && height >= 32, `${wide} by ${height}`);
  }
  await panel(page).locator('summary').filter({ hasText: 'Table' }).tap();
  for (const table of await panel(page).locator('.best-tables table').all()) {
    const { x, width: wide } = await table.boundingBox();
    assert.ok(x >= 0 && x + wide <= 390, `a table from ${x}, ${wide} wide`);
  }
  await shown(page, 'both').tap();
  await page.locator('#canvas[data-best]:not([data-best=""])').waitFor();
  assert.deepEqual(problems, []);
});

test('driven joints have no goal: there is nothing to look for', async () => {
  const { page, problems } = await browser.openPage(DESK);
  await openSample(page, 'four-bar.json');
  await page.getByRole('tab', { name: 'Motion', exact: true }).click();
  await page.getByRole('radio', { name: 'Driven joints' }).check();
  await unfoldCharts(page);
  await page.getByRole('tab', { name: 'Best motion' }).click();
  await panel(page).getByText('Joints are driven').waitFor();
  assert.ok(await panel(page).getByRole('button', { name: 'Look for a better motion' }).isDisabled());
  assert.deepEqual(problems, []);
});

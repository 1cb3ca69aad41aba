// Driven joints in the page: from key frames to drivers and back, a full turn, a dead point, and not a word of a goal.
import assert from 'node:assert/strict';
import { mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, afterEach, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { violations } from './axe.mjs';
import { cell, doTo, keeps, notice, number, openBrowser, openSample, scrubTo, text, unfoldCharts } from './browser.mjs';

let browser;
let problems = [];
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());
afterEach(() => assert.deepEqual(problems, []));

/** The four-bar sample, whose shorter link goes round and whose rocker cannot, with its motion's tables. */
async function fourBar(options) {
  let page;
  ({ page, problems } = await browser.openPage({ viewport: { width: 1280, height: 860 }, ...options }));
  await openSample(page, 'four-bar.json');
  await page.getByRole('tab', { name: 'Motion', exact: true }).click();
  return page;
}

const kind = (page, name) => page.getByRole('radio', { name });
const value = (at, row, column) => `motion.drivers[${at}].values[${row}].${column}`;
const driven = (page) => page.waitForFunction(() => /Joints are driven/.test(page$('#motion-metric')?.textContent));

/** What stands anywhere and is no number or nothing, also in names for screen readers. */
const holes = (page) =>
  page.evaluate(() =>
    page$$('body *, .bench, .bench *').filter((node) => !node.closest('script, style') && node.children.length === 0)
      .map((node) => [node.textContent, ...[...node.attributes].map(({ value }) => value)].join(' '))
      .filter((all) => /\bNaN\b|\bnull\b|\bundefined\b/.test(all)));

/** All that is told of the motion, except where it says that there is no goal. */
const told = (page) =>
  page.evaluate(() => {
    const parts = ['#info', '#legend', '#live', '#canvas-text', '#charts', '.transport'].map((id) => page$(id).cloneNode(true));
    for (const part of parts) for (const gone of part.querySelectorAll('[hidden], #motion-metric, option')) gone.remove();
    return [...parts.map((part) => part.textContent), ...['#scrub', '#strip'].map((id) => page$(id).getAttribute('aria-valuetext') ?? page$(id).getAttribute('aria-label'))].join(' ');
  });

test('the crank goes round, and nothing is said of a goal; the key frames come back', async () => {
  const page = await fourBar();
  await kind(page, 'Driven joints').check();
  await driven(page);
  assert.deepEqual([await cell(page, value(0, 0, 'value')).inputValue(), await cell(page, value(0, 1, 'value')).inputValue()], ['90', '450'], 'a turn on from where it is');
  await cell(page, 'motion.frames').fill('73');
  await page.waitForFunction(() => page$('#frame-number').textContent.endsWith('/ 73'));
  await scrubTo(page, 18);
  assert.match(await page.locator('#scrub').getAttribute('aria-valuetext'), /^Frame 19 of 73: reached, θ₁ of crank at 180°\.$/);
  assert.equal(await text(page, 'frame-time'), 't = 1.25 s');
  assert.match(await text(page, 'motion-summary'), /^73 frames: 73 reached\.\s*$/);
  assert.ok(number(await text(page, 'closure')) <= 1e-10);
  await page.waitForFunction(() => page$('#why-title')?.textContent === 'What is free here' && !page$('#why').matches('.waiting, .unsaid, [hidden]') && /180°/.test(page$('#live').textContent));
  await unfoldCharts(page);
  // Chebyshev's stroke is almost a straight line, 1.6 m above the ground.
  await page.getByRole('region', { name: 'Workpiece’s origin' }).or(page.locator('section.chart[aria-label="Workpiece’s origin"]')).first().waitFor();
  const titles = await page.locator('#charts section.chart').evaluateAll((charts) => charts.map((chart) => chart.getAttribute('aria-label')));
  assert.deepEqual(titles.slice(0, 2), ['Driven joint, crank θ₁', 'Workpiece’s origin']);
  assert.match(await page.locator('section.chart[aria-label="Driven joint, crank θ₁"] .plot').getAttribute('aria-label'), /90 to 450°, largest at frame 73/);
  assert.match(await text(page, 'legend'), /^\s*path of the workpiece\s*$/);
  assert.doesNotMatch(await told(page), /goal|gap|closest|metric|gradient/i);
  assert.deepEqual(await holes(page), []);
  await page.getByRole('button', { name: 'Show', exact: false }).and(page.locator('[aria-haspopup=menu]')).click();
  assert.doesNotMatch(await page.locator('[role=menu]:popover-open').innerText(), /goal|gap|key frame/i);
  await page.keyboard.press('Escape');
  await page.getByRole('tab', { name: 'Algorithm' }).click();
  await page.locator('#algorithm').filter({ hasText: 'there is no goal' }).waitFor();
  // Another visit finds it as it was left.
  await keeps(page, '"drivers"');
  await page.reload();
  await driven(page);
  // The key frames of another visit are gone; its undo steps are not.
  await page.getByRole('button', { name: 'Undo' }).first().click();
  await page.getByRole('button', { name: 'Undo' }).first().click();
  await page.waitForFunction(() => /Metric/.test(page$('#motion-metric').textContent));
  await page.getByRole('tab', { name: 'Motion', exact: true }).click();
  await page.locator('.keys tbody').nth(6).waitFor();
  assert.equal(await page.locator('.keys tbody').count(), 7);
});

test('values are typed, added, pasted and removed; switching keeps what was there', async () => {
  const page = await fourBar();
  await kind(page, 'Driven joints').check();
  await notice(page, '7 key frames are kept until another linkage is opened.').waitFor();
  await page.getByRole('button', { name: '+ value' }).click();
  assert.deepEqual([await cell(page, value(0, 2, 'time')).inputValue(), await cell(page, value(0, 2, 'value')).inputValue()], ['10', '450'], 'a dwell');
  await cell(page, value(0, 0, 'time')).evaluate((field) => {
    field.focus();
    const clipboardData = new DataTransfer();
    clipboardData.setData('text/plain', '0\t90\n1\t180\n2\t180\n3\t60');
    field.dispatchEvent(new ClipboardEvent('paste', { clipboardData, bubbles: true, cancelable: true }));
  });
  await page.waitForFunction((path) => page$(`input[data-path="${path}"]`)?.value === '60', value(0, 3, 'value'));
  await page.getByRole('button', { name: 'Remove driver 1, value 2', exact: true }).click();
  assert.equal(await page.locator('.drive tbody tr').count(), 3);
  await cell(page, 'motion.drivers[0].ramp').selectOption('smooth');
  await page.getByRole('button', { name: 'Full turn' }).click();
  assert.deepEqual([await cell(page, value(0, 1, 'time')).inputValue(), await cell(page, value(0, 1, 'value')).inputValue()], ['3', '450']);
  // A time that is no later than the one before is at fault, at its cell.
  await cell(page, value(0, 1, 'time')).fill('-1');
  await page.locator(`[data-path="${value(0, 1, 'time')}"][aria-invalid="true"]`).waitFor();
  await cell(page, value(0, 1, 'time')).fill('4');
  await page.waitForFunction(() => !page$('[aria-invalid="true"]'));
  await kind(page, 'Key frames').check();
  await page.waitForFunction(() => page$$('.keys tbody').length === 7 && /Metric/.test(page$('#motion-metric').textContent));
  await kind(page, 'Driven joints').check();
  await driven(page);
  assert.equal(await cell(page, 'motion.drivers[0].ramp').inputValue(), 'smooth');
  await notice(page, 'Joints are driven.').locator('..').getByRole('button', { name: 'Undo' }).click();
  await page.waitForFunction(() => page$$('.keys tbody').length === 7);
});

test('a rocker comes to its dead point: where, and why', async () => {
  const page = await fourBar();
  await kind(page, 'Driven joints').check();
  await driven(page);
  await page.getByRole('combobox', { name: 'joint of driver 1' }).selectOption({ label: 'θ₁ of rocker, joint 1' });
  await page.locator('#warning-list').filter({ hasText: 'a dead point is met' }).waitFor();
  await page.locator('#warning-list li', { hasText: 'a dead point' }).getByRole('button').first().click();
  await page.waitForFunction(() => page$('#frame-word').textContent === 'Stalled');
  await page.locator('#why').filter({ hasText: 'What stops the drivers' }).filter({ hasText: 'a dead point is met' }).waitFor();
  assert.match(await text(page, 'frame-meaning'), /driven joints cannot have their values here/);
  assert.match(await text(page, 'motion-summary'), /\d+ reached, \d+ stalled/);
  // What is spoken comes a moment later.
  await page.locator('#live').filter({ hasText: 'stalled' }).waitFor({ state: 'attached' });
  assert.doesNotMatch(await told(page), /goal|gap|closest|metric|gradient/i);
  assert.deepEqual(await holes(page), []);
});

test('the saved page plays without a goal', async () => {
  const page = await fourBar();
  await kind(page, 'Driven joints').check();
  await driven(page);
  await page.getByRole('button', { name: 'Export', exact: true }).click();
  const [download] = await Promise.all([page.waitForEvent('download'), page.getByRole('menuitem', { name: /HTML/ }).click()]);
  const folder = await mkdtemp(join(tmpdir(), 'synthetica-'));
  const file = join(folder, 'driven.html');
  await writeFile(file, await readFile(await download.path()));
  const { page: alone, problems: own } = await browser.blankPage({ offline: true });
  await alone.goto(String(pathToFileURL(file)));
  await alone.locator('#scrub').fill('32');
  await alone.locator('#status').filter({ hasText: 'Reached: θ₁ of crank at 270°. Every driven joint has its value' }).waitFor();
  assert.doesNotMatch(await alone.locator('body').innerText(), /goal|gap|NaN/);
  assert.deepEqual(own.filter((words) => !words.startsWith('asks for file:')), []);
  await rm(folder, { recursive: true });
});

test('a joint is driven from its slider and from its menu; a hand may pull, and key frames are not offered', async () => {
  const page = await fourBar();
  await page.getByRole('tab', { name: 'Teach' }).click();
  await page.getByRole('button', { name: 'Drive this joint: θ₁ of crank' }).click();
  await notice(page, 'θ₁ of crank is driven from').waitFor();
  await driven(page);
  const slider = page.locator('.teach-row[data-variable="0"] input[type=text]');
  await slider.fill('100');
  await slider.press('Enter');
  await page.waitForFunction(() => page$('#frame-word').textContent === 'Driven');
  assert.equal(await page.getByRole('button', { name: 'Add key frame here' }).count(), 0);
  await page.getByRole('button', { name: 'Use as start' }).first().waitFor();
  await page.getByRole('tab', { name: 'Mechanism' }).click();
  await doTo(page, 'joint 2 of chain 2', 'Drive θ₂');
  // It leaves the crank no freedom, or the crank it.
  await page.locator('#warning-list').filter({ hasText: 'is not driven' }).waitFor();
  await page.getByRole('tab', { name: 'Motion', exact: true }).click();
  assert.equal(await page.locator('.driver').count(), 2);
});

test('on a phone, in the dark', async () => {
  const page = await fourBar({ viewport: { width: 390, height: 844 }, isMobile: true, hasTouch: true, colorScheme: 'dark' });
  await kind(page, 'Driven joints').check();
  await page.locator('.driver').waitFor();
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), 'nothing sticks out');
  assert.deepEqual(await violations(page), []);
  await page.getByRole('tab', { name: 'Info' }).click();
  await driven(page);
});

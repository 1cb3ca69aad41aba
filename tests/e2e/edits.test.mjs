// Every edit is live; a bad one is explained beside its cell and undone.
import assert from 'node:assert/strict';
import { after, afterEach, before, beforeEach, test } from 'node:test';
import { cell, doTo, faultBeside, metricBecomes, noFault, number, openBrowser, openSample, otherMetric, scrubTo, text } from './browser.mjs';

let browser;
let page;
let problems;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());
beforeEach(async () => {
  ({ page, problems } = await browser.openPage());
  await scrubTo(page, 60);
});
afterEach(() => assert.deepEqual(problems, []));

/** A shift of the slider along the leg's own plane: the 3RPS reaches the same poses with any number here. */
const A = 'chains[0].joints[1].rows[0].a';
/** A tilt of the leg out of its plane: other poses. */
const ALPHA = 'chains[0].joints[1].rows[0].alpha';

test('a number of a Denavit–Hartenberg row replans, undo brings the motion back, redo the new one', async () => {
  const old = await text(page, 'metric');
  const curve = await page.locator('#strip .gap').getAttribute('d');
  await cell(page, ALPHA).fill('80');
  const fresh = await otherMetric(page, old);
  assert.notEqual(await page.locator('#strip .gap').getAttribute('d'), curve);
  assert.ok(number(await text(page, 'closure')) <= 1e-10);
  await page.getByRole('button', { name: 'Undo' }).click();
  await metricBecomes(page, old);
  assert.equal(await cell(page, ALPHA).inputValue(), '90');
  await page.getByRole('button', { name: 'Redo' }).click();
  await metricBecomes(page, fresh);
});

for (const bad of ['abc', '1e999', '']) {
  test(`"${bad}" is explained beside its cell, kept as typed, and mended by undo; the motion stays`, async () => {
    const old = await text(page, 'metric');
    await cell(page, A).fill(bad);
    await page.keyboard.press('Enter');
    assert.match(await faultBeside(page, A), /number/);
    assert.equal(await cell(page, A).inputValue(), bad);
    assert.equal(await text(page, 'metric'), old, 'the last good motion is still shown');
    await page.keyboard.press('Control+z');
    await noFault(page);
    assert.equal(await cell(page, A).inputValue(), '0');
    assert.equal(await text(page, 'metric'), old);
  });
}

test('Escape gives a bad cell its last good value, also when one comes back to it', async () => {
  await cell(page, A).fill('abc');
  await page.keyboard.press('Enter');
  await faultBeside(page, A);
  await page.keyboard.press('Escape');
  await noFault(page);
  assert.equal(await cell(page, A).inputValue(), '0');

  await cell(page, A).fill('abc');
  await page.keyboard.press('Tab');
  await faultBeside(page, A);
  await cell(page, A).focus();
  await page.keyboard.press('Escape');
  await noFault(page);
});

test('the axes of a T must meet: its inner length is refused in its place', async () => {
  await openSample(page, '2tpr.json');
  const inner = 'chains[1].joints[0].rows[1].a';
  await cell(page, inner).waitFor();
  await cell(page, inner).fill('1');
  assert.match(await faultBeside(page, inner), /0/);
  await page.keyboard.press('Escape');
  await noFault(page);
});

test('a fault in a panel that is not open is found from the info panel', async () => {
  await page.setViewportSize({ width: 1280, height: 700 });
  await cell(page, A).fill('abc');
  await page.keyboard.press('Tab');
  await faultBeside(page, A);
  await page.getByRole('tab', { name: 'Motion', exact: true }).click();
  await page.getByRole('button', { name: 'Go to it' }).click();
  assert.equal(await page.evaluate(() => pageFocus().dataset.path), A);
});

test('a key frame moves the goal', async () => {
  const old = await text(page, 'metric');
  await page.getByRole('tab', { name: 'Motion', exact: true }).click();
  await cell(page, 'motion.key_frames[1].x').fill('0.6');
  await otherMetric(page, old);
  await cell(page, 'motion.key_frames[1].name').fill('half way');
  await page.locator('#labels').getByText('half way').waitFor();
  await doTo(page, 'key frame 2', 'Duplicate');
  await cell(page, 'motion.key_frames[3].z').waitFor();
  await page.keyboard.press('Control+z');
  await cell(page, 'motion.key_frames[3].z').waitFor({ state: 'detached' });
});

test('frames, interpolation and method are settings of the document', async () => {
  await page.getByRole('tab', { name: 'Motion', exact: true }).click();
  await cell(page, 'motion.frames').fill('9');
  await page.locator('#frame-number').filter({ hasText: '/ 9' }).waitFor();
  await cell(page, 'motion.interpolation').selectOption('straight');
  await cell(page, 'planner.method').selectOption('gradient');
  await page.waitForFunction(() => page$('#undo').disabled === false);
  for (let i = 0; i < 3; i++) await page.keyboard.press('Control+z');
  await page.locator('#frame-number').filter({ hasText: '/ 129' }).waitFor();
  await page.keyboard.press('Control+Shift+z');
  await page.locator('#frame-number').filter({ hasText: '/ 9' }).waitFor();
});

test('joints and chains come and go, and undo brings them back', async () => {
  const types = () => page.locator('#chain-rows td:nth-child(2)').allTextContents();
  const typesBecome = (wanted) =>
    page.waitForFunction(
      (list) => [...page$$('#chain-rows td:nth-child(2)')].map((node) => node.textContent).join() === list,
      wanted.join(),
    );
  assert.deepEqual(await types(), ['RPS', 'RPS', 'RPS']);
  await cell(page, 'chains[2].joints[0].type').selectOption('T');
  // T, P and S have six freedoms; a chain may have five.
  await page.locator('#fault-note').waitFor();
  await page.keyboard.press('Control+z');
  await noFault(page);
  await doTo(page, 'chain 3', 'Remove');
  await typesBecome(['RPS', 'RPS']);
  await doTo(page, 'chain 2', 'Duplicate');
  await typesBecome(['RPS', 'RPS', 'RPS']);
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  await typesBecome(['RPS', 'RPS', 'RPS']);
});

test('a limit holds a joint back', async () => {
  await page.locator('.chain details summary').first().click();
  const limit = 'chains[0].joints[1].limits[0].max';
  await cell(page, limit).fill('1.3');
  await page.waitForFunction(() => /limit/i.test(page$('#motion-summary').textContent));
  await cell(page, limit).fill('');
  await page.keyboard.press('Tab');
  await page.waitForFunction(() => !/limit/i.test(page$('#motion-summary').textContent));
});

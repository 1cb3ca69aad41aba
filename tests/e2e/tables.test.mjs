// Chains, joints and key frames come, go and change places, by menu and by keyboard.
import assert from 'node:assert/strict';
import { after, afterEach, before, beforeEach, test } from 'node:test';
import { cell, doTo, openBrowser, scrubTo, text } from './browser.mjs';

let browser;
let page;
let problems;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());
beforeEach(async () => {
  ({ page, problems } = await browser.openPage());
});
afterEach(() => assert.deepEqual(problems, []));

const joints = (chain) => page.locator(`[data-path^="chains[${chain}].joints"][data-path$=".type"]`).evaluateAll((all) => all.map((s) => s.value).join(''));
const names = () => page.locator('#mechanism h3 input:not(.type)').evaluateAll((all) => all.map((input) => input.value));
const active = () => page.evaluate(() => pageFocus().dataset.path ?? pageFocus().dataset.menu);

test('a joint is inserted, moved by its menu and by Alt and an arrow, removed; each is one step of undo', async () => {
  assert.equal(await joints(0), 'RPS');
  await doTo(page, 'joint 2 of chain 1', 'Insert a joint before');
  await cell(page, 'chains[0].joints[3].type').waitFor();
  assert.equal(await joints(0), 'RRPS');
  await doTo(page, 'joint 3 of chain 1', 'Move up');
  assert.equal(await joints(0), 'RPRS');
  assert.equal(await active(), 'chains[0].joints[1]', 'the focus goes with the joint');
  await cell(page, 'chains[0].joints[1].rows[0].alpha').focus();
  await page.keyboard.press('Alt+ArrowDown');
  assert.equal(await joints(0), 'RRPS');
  assert.equal(await active(), 'chains[0].joints[2].rows[0].alpha');
  await doTo(page, 'joint 2 of chain 1', 'Remove');
  assert.equal(await joints(0), 'RPS');
  for (let i = 0; i < 4; i++) await page.keyboard.press('Control+z');
  assert.equal(await joints(0), 'RPS');
  await page.locator('#fault-note').waitFor({ state: 'detached' });
});

test('chains change places', async () => {
  await doTo(page, 'chain 1', 'Move down');
  assert.deepEqual(await names(), ['chain 2', 'chain 1', 'chain 3']);
  await cell(page, 'chains[1].base.x').focus();
  await page.keyboard.press('Alt+ArrowDown');
  assert.deepEqual(await names(), ['chain 2', 'chain 3', 'chain 1']);
  assert.equal(await active(), 'chains[2].base.x');
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  assert.deepEqual(await names(), ['chain 1', 'chain 2', 'chain 3']);
});

test('key frames come at the shown pose, and change places', async () => {
  await scrubTo(page, 40);
  await page.getByRole('tab', { name: 'Motion' }).click();
  await page.getByRole('button', { name: '+ at the shown pose' }).click();
  await cell(page, 'motion.key_frames[3].x').waitFor();
  await page.keyboard.press('Control+z');
  await cell(page, 'motion.key_frames[3].x').waitFor({ state: 'detached' });

  await doTo(page, 'key frame 1', 'Move down');
  const order = await page.locator('#motion .key th input').evaluateAll((all) => all.map((input) => input.value));
  assert.deepEqual(order, ['between', 'begin', 'end']);
  await page.getByRole('button', { name: 'Go to key frame 3' }).click();
  const [at, of] = (await text(page, 'frame-number')).split(' / ');
  assert.equal(at, of);
});

test('a key frame at the shown goal is where the goal is', async () => {
  await page.getByRole('tab', { name: 'Motion' }).click();
  await scrubTo(page, 128);
  await page.getByRole('button', { name: '+ at the shown goal' }).click();
  await cell(page, 'motion.key_frames[3].x').waitFor();
  for (const key of ['x', 'y', 'z', 'longitude', 'latitude', 'roll']) {
    const [last, fresh] = await Promise.all([2, 3].map(async (index) => Number(await cell(page, `motion.key_frames[${index}].${key}`).inputValue())));
    assert.ok(Math.abs(last - fresh) < 1e-3, key);
  }
});

test('a key frame at the shown pose can be reached', async () => {
  await scrubTo(page, 64);
  await page.getByRole('tab', { name: 'Motion' }).click();
  await doTo(page, 'key frame 2', 'Take the shown pose');
  await page.getByRole('button', { name: 'Go to key frame 2' }).click();
  await page.waitForFunction(() => page$('#frame-word').textContent === 'Reached');
});

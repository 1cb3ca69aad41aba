// The 3D view: what is pointed at is named, what is clicked is selected, and the keyboard and touch can do the same.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { openBrowser, scrubTo } from './browser.mjs';

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

const drawn = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));

/** Where a thing is on the screen: its name stands there once the keyboard points at it. */
async function placeOf(page, thing) {
  await page.locator('#canvas').focus();
  const name = page.locator(`#labels [data-place="${thing}"].pointed`);
  for (let i = 0; i < 60 && !(await name.count()); i++) await page.keyboard.press(']');
  await drawn(page);
  const [x, y] = await name.evaluate((tag) => tag.style.transform.match(/[\d.]+(?=px)/g).map(Number));
  const { x: left, y: top } = await page.locator('#canvas').boundingBox();
  await page.keyboard.press('Escape');
  return [left + x, top + y];
}

const chosen = (page, place) => page.locator(`#canvas[data-selected="${place}"]`).waitFor();

test('hover tells what a thing is, a click selects it, a click beside it ends that', async () => {
  const { page, problems } = await browser.openPage();
  await scrubTo(page, 60);
  const joint = 'chains[1].joints[2]';
  const at = await placeOf(page, joint);
  await page.mouse.move(...at);
  await page.locator('#tip').filter({ hasText: 'chain 2, joint 3: S, spherical' }).waitFor();
  const plain = await page.locator('#canvas').screenshot();
  await page.mouse.down();
  await page.mouse.up();
  await chosen(page, joint);
  await page.locator(`#labels .chosen[data-place="${joint}"]`).waitFor();
  await drawn(page);
  assert.notDeepEqual(await page.locator('#canvas').screenshot(), plain, 'it is outlined');
  const { x, y, height } = await page.locator('#canvas').boundingBox();
  await page.mouse.click(x + 10, y + height - 30);
  await chosen(page, '');
  assert.deepEqual(problems, []);
});

test('turning the view selects nothing', async () => {
  const { page } = await browser.openPage();
  const [x, y] = await placeOf(page, 'workpiece');
  const before = await page.locator('#canvas').screenshot();
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 60, y + 20, { steps: 4 });
  await page.mouse.up();
  await drawn(page);
  assert.notDeepEqual(await page.locator('#canvas').screenshot(), before);
  assert.equal((await page.locator('#canvas').getAttribute('data-selected')) || '', '');
});

test('the keyboard goes through the things, says them, and leaves the view with Tab', async () => {
  const { page } = await browser.openPage();
  await page.locator('#canvas').focus();
  await page.keyboard.press(']');
  await page.locator('#view-live').filter({ hasText: /^workpiece, 1 of \d+/ }).waitFor();
  await page.keyboard.press(']');
  await page.locator('#view-live').filter({ hasText: 'base of chain 1' }).waitFor();
  await page.keyboard.press('Enter');
  await chosen(page, 'chains[0].base');
  await page.keyboard.press('Escape');
  await chosen(page, '');
  await page.keyboard.press('Tab');
  assert.notEqual(await page.evaluate(() => document.activeElement.id), 'canvas');
});

test('a tap selects', async () => {
  const { page } = await browser.openPage({ viewport: { width: 390, height: 844 }, isMobile: true, hasTouch: true });
  const at = await placeOf(page, 'chains[0].joints[1]');
  await page.touchscreen.tap(...at);
  await chosen(page, 'chains[0].joints[1]');
});

test('at rest nothing is drawn', async () => {
  const { page } = await browser.openPage();
  const draws = () => page.locator('#canvas').getAttribute('data-draws');
  let last = '';
  // Without a graphics card the shadows follow once the picture rests.
  while (last !== (last = await draws())) await page.waitForTimeout(700);
  await page.waitForTimeout(700);
  assert.equal(await draws(), last);
  await page.locator('#canvas').focus();
  await page.keyboard.press('ArrowLeft');
  await page.waitForFunction((old) => document.querySelector('#canvas').dataset.draws !== old, last);
});

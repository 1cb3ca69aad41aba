// The header around the linkage: light and dark, and its one row on a phone.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { nameIs, openBrowser, openSample, ready, scrubTo } from './browser.mjs';

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

/** How light the picture of the linkage is, from 0 to 1. */
const lightness = async (page) =>
  page.evaluate(async (bytes) => {
    const bitmap = await createImageBitmap(new Blob([new Uint8Array(bytes)]));
    const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
    context.drawImage(bitmap, 0, 0);
    const { data } = context.getImageData(0, 0, bitmap.width, bitmap.height);
    return data.reduce((sum, value, index) => (index % 4 === 3 ? sum : sum + value), 0) / (data.length * 0.75 * 255);
  }, [...(await page.locator('#canvas').screenshot())]);

test('light, dark, as the system: chosen in the header, kept, followed by the view', async () => {
  const { page, problems } = await browser.openPage();
  await scrubTo(page, 60);
  const theme = page.locator('#theme');
  const state = () => page.evaluate(() => {
    const style = getComputedStyle(document.documentElement);
    return { scheme: style.colorScheme, page: style.backgroundColor };
  });
  const light = await state();
  assert.ok((await lightness(page)) > 0.65);
  await theme.click();
  assert.equal((await state()).scheme, 'light');
  await theme.click();
  const dark = await state();
  assert.equal(dark.scheme, 'dark');
  assert.notEqual(dark.page, light.page);
  assert.ok((await lightness(page)) < 0.35);
  assert.match(await theme.getAttribute('aria-label'), /dark.*system/);
  await page.reload();
  assert.equal((await state()).page, dark.page, 'before the scripts ran');
  await ready(page);
  await theme.click();
  assert.deepEqual(await state(), light);
  assert.deepEqual(problems, []);
});

test('on a phone the header is one row, and its menu holds the rest', async () => {
  const { page } = await browser.openPage({ viewport: { width: 390, height: 844 }, isMobile: true, hasTouch: true });
  const bar = await page.locator('.bar').boundingBox();
  assert.ok(bar.height < 60, `${bar.height} pixels high`);
  await openSample(page, '2tpr.json');
  await nameIs(page, '2TPR');
  await page.getByRole('button', { name: 'File', exact: true }).tap();
  for (const name of [/^New/, /^Open/, /^Save/, /^Share/, /^Colours/]) assert.ok(await page.getByRole('menuitem', { name }).first().isVisible(), String(name));
  await page.getByRole('menuitem', { name: /^Colours/ }).tap();
  assert.equal(await page.evaluate(() => document.documentElement.dataset.theme), 'light');
});

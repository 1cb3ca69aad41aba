// The ways to assemble at a key frame: pictures, numbers, an order, and a start that undo takes back.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { cell, doTo, notice, openBrowser, openSample, scrubTo, unfoldCharts } from './browser.mjs';

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

const dialog = (page) => page.getByRole('dialog', { name: 'Ways to assemble' });
const ways = (page) => dialog(page).getByRole('list', { name: 'Ways to assemble' }).getByRole('listitem');
const isComplete = (page) => dialog(page).locator('.best-mode').waitFor({ timeout: 180_000 });
const start = (page) => page.evaluate(() => JSON.stringify(document.querySelector('synthetica-linkage').document.chains.map((chain) => chain.start)));

/** The agile eye has eight ways; the linkage that the page begins with has one. With many frames the motions from all take long. */
async function openDialog(options = { viewport: { width: 1280, height: 800 } }, key = 1, frames = 0) {
  const { page, problems } = await browser.openPage(options);
  await openSample(page, 'agile-eye.json');
  await page.getByRole('tab', { name: 'Motion', exact: true }).click();
  if (frames) {
    await cell(page, 'motion.frames').fill(String(frames));
    await page.locator('#frame-number').filter({ hasText: `/ ${frames}` }).waitFor();
  }
  await doTo(page, `key frame ${key}`, 'Ways to assemble…');
  await dialog(page).waitFor();
  return { page, problems };
}

test('each way has its picture, its distance, who found it and what its motion costs; one is the document’s start', async () => {
  const { page, problems } = await openDialog();
  await isComplete(page);
  const count = await ways(page).count();
  assert.equal(count, 8);
  assert.match(await dialog(page).locator('.modes-note').textContent(), new RegExp(`^${count} ways found by \\d+ starts\\. .*further starts`));
  assert.equal(await ways(page).filter({ hasText: 'the document’s start' }).count(), 1);
  for (const one of await ways(page).all()) {
    const words = await one.textContent();
    assert.match(words, /reaches the key frame|distance [\d.e−]+ from the key frame/);
    assert.match(words, /\d+ starts? or more of each chain led to it/);
    assert.match(words, /motion from it: every frame reaches its goal/);
    await one.locator('canvas[data-drawn]').waitFor();
  }
  // A picture has more than its background.
  const colours = await ways(page).first().locator('canvas').evaluate((canvas) => {
    const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
    return new Set(Array.from({ length: data.length / 4 }, (_, i) => `${data[4 * i] >> 4} ${data[4 * i + 1] >> 4} ${data[4 * i + 2] >> 4}`)).size;
  });
  assert.ok(colours > 20, `${colours} colours`);
  // No two are alike: a leg or more stands elsewhere.
  const least = await ways(page).locator('canvas').evaluateAll((all) => {
    const { width, height } = all[0];
    const pen = new OffscreenCanvas(width, height).getContext('2d', { willReadFrequently: true });
    const pictures = all.map((canvas) => {
      pen.drawImage(canvas, 0, 0);
      return pen.getImageData(0, 0, width, height).data;
    });
    const share = (one, other) => one.reduce((sum, value, i) => sum + Number(i % 4 < 3 && Math.abs(value - other[i]) > 24), 0) / (0.75 * one.length);
    return Math.min(...pictures.flatMap((one, i) => pictures.slice(i + 1).map((other) => share(one, other))));
  });
  assert.ok(least > 0.03, `two pictures differ in ${least} of their values`);
  await dialog(page).getByLabel('Order').selectOption('motion');
  // They are alike: none is better than that of the document's start.
  assert.match(await ways(page).first().textContent(), /the document’s start ?best mode/);
  assert.deepEqual(problems, []);
});

test('a way becomes the start, an edit that undo takes back', async () => {
  const { page, problems } = await openDialog();
  await isComplete(page);
  const before = await start(page);
  const other = ways(page).filter({ hasNotText: 'the document’s start' }).first();
  await other.getByRole('button', { name: /^Start from this: way \d+$/ }).click();
  await dialog(page).waitFor({ state: 'detached' });
  await notice(page, /^Way \d+ was made the start/).waitFor();
  assert.notEqual(await start(page), before);
  await notice(page, /was made the start/).getByRole('button', { name: 'Undo' }).click();
  await page.waitForFunction((old) => JSON.stringify(document.querySelector('synthetica-linkage').document.chains.map((chain) => chain.start)) === old, before);
  // By keyboard too: the notice offers no other step then.
  await page.keyboard.press('Control+y');
  await page.waitForFunction((old) => JSON.stringify(document.querySelector('synthetica-linkage').document.chains.map((chain) => chain.start)) !== old, before);
  await doTo(page, 'key frame 1', 'Ways to assemble…');
  await isComplete(page);
  await ways(page).filter({ hasNotText: 'the document’s start' }).last().getByRole('button', { name: /^Start from this/ }).click();
  await notice(page, /was made the start/).waitFor();
  await page.keyboard.press('Control+z');
  await notice(page, /was made the start/).getByRole('button', { name: 'Undo' }).waitFor({ state: 'detached', timeout: 4000 });
  assert.deepEqual(problems, []);
});

test('after a way became the start the focus is where the dialog was opened from', async () => {
  const { page, problems } = await openDialog();
  const takeOther = async () => {
    const other = ways(page).filter({ hasNotText: 'the document’s start' }).first().getByRole('button', { name: /^Start from this/ });
    await other.focus();
    await page.keyboard.press('Enter');
    await notice(page, /was made the start/).waitFor();
    await dialog(page).waitFor({ state: 'detached' });
  };
  await takeOther();
  await page.locator('#motion button:focus').waitFor();
  assert.equal(await page.locator('#motion button:focus').getAttribute('aria-label'), 'Actions of key frame 1');
  await page.keyboard.press('Control+z');
  await unfoldCharts(page);
  await page.getByRole('tab', { name: 'Best motion' }).click();
  const opener = page.getByRole('button', { name: 'Ways to assemble…' });
  await opener.focus();
  await page.keyboard.press('Enter');
  await takeOther();
  await page.locator('#best button:focus').filter({ hasText: 'Ways to assemble…' }).waitFor();
  // Also when it is planned.
  await page.locator('#best button:focus:not([aria-disabled])').filter({ hasText: 'Ways to assemble…' }).waitFor();
  assert.deepEqual(problems, []);
});

test('by keyboard: another key frame, stop, go on, close; the focus comes back', async () => {
  const { page, problems } = await openDialog(undefined, 1, 10_001);
  const stop = dialog(page).getByRole('button', { name: 'Stop', exact: true });
  await stop.waitFor();
  await stop.focus();
  await page.keyboard.press('Enter');
  const on = dialog(page).getByRole('button', { name: 'Go on searching' });
  await on.waitFor();
  await on.focus();
  await page.keyboard.press('Enter');
  await stop.waitFor();
  await dialog(page).getByLabel('Key frame').selectOption('2');
  await stop.waitFor();
  await page.keyboard.press('Escape');
  await dialog(page).waitFor({ state: 'detached' });
  // Plans go on as before.
  await scrubTo(page, 5);
  await cell(page, 'motion.frames').fill('33');
  await page.locator('#frame-number').filter({ hasText: '/ 33' }).waitFor();
  assert.deepEqual(problems, []);
});

test('from the panel of the best motion, of the key frame at the playhead; on a phone it fits', async () => {
  const { page, problems } = await browser.openPage({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  await scrubTo(page, 100);
  await page.getByRole('tab', { name: 'Best motion' }).click();
  await page.getByRole('button', { name: 'Ways to assemble…' }).tap();
  assert.equal(await dialog(page).getByLabel('Key frame').inputValue(), '1');
  await ways(page).first().waitFor();
  const box = await dialog(page).boundingBox();
  assert.ok(box.x >= 0 && box.x + box.width <= 390, JSON.stringify(box));
  await dialog(page).getByRole('button', { name: 'Close' }).tap();
  await dialog(page).waitFor({ state: 'detached' });
  assert.deepEqual(problems, []);
});

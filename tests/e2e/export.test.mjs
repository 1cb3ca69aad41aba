// What the Export menu saves: every file is caught and read.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { after, before, test } from 'node:test';
import { number, openBrowser, scrubTo, text } from './browser.mjs';

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

/** Chooses an item of the Export menu. */
async function choose(page, item) {
  await page.getByRole('button', { name: 'Export', exact: true }).click();
  await page.getByRole('menuitem', { name: item }).click();
}

/** What is saved when `act` is done: its name and its bytes. */
async function saved(page, act) {
  const [download] = await Promise.all([page.waitForEvent('download'), act()]);
  return { name: download.suggestedFilename(), bytes: await readFile(await download.path()) };
}

test('the table has the numbers that are shown', async () => {
  const { page, problems } = await browser.openPage();
  await scrubTo(page, 63);
  const { name, bytes } = await saved(page, () => choose(page, /CSV/));
  assert.equal(name, '3rps.csv');
  const [headings, ...lines] = bytes.toString().trimEnd().split('\n').map((line) => line.split(','));
  assert.equal(lines.length, Number((await text(page, 'frame-number')).split(' / ')[1]));
  const at = (heading) => {
    assert.ok(headings.includes(heading), `${heading} among ${headings}`);
    return Number(lines[63][headings.indexOf(heading)]);
  };
  assert.ok(Math.abs(at('translation_gap[m]') - number(await text(page, 'gap-translation'))) < 1e-4);
  assert.ok(Math.abs(at('rotation_gap[deg]') - number(await text(page, 'gap-rotation'))) < 1e-2);
  assert.ok(at('chain1_theta1[deg]') > 3 && at('chain1_d2[m]') > 0, 'degrees and metres');
  assert.deepEqual(problems, []);
});

test('the data hold every frame and the document', async () => {
  const { page } = await browser.openPage();
  const { name, bytes } = await saved(page, () => choose(page, /JSON/));
  assert.equal(name, '3rps.motion.json');
  const motion = JSON.parse(bytes.toString());
  assert.equal(motion.frames, 129);
  assert.ok(motion.columns.length > 30 && motion.columns.every(({ values }) => values.length === 129));
  assert.equal(motion.document.chains.length, 3);
});

test('the MuJoCo model has every joint and closes the loops', async () => {
  const { page } = await browser.openPage();
  const { name, bytes } = await saved(page, () => choose(page, /MJCF/));
  assert.equal(name, '3rps.mjcf.xml');
  const counts = await page.evaluate((xml) => {
    const model = new DOMParser().parseFromString(xml, 'application/xml');
    return ['parsererror', 'joint[type]', 'weld', 'key'].map((query) => model.querySelectorAll(query).length);
  }, bytes.toString());
  assert.deepEqual(counts, [0, 15, 2, 129]);
});

/** Size of a picture, its share of clear pixels, and how many colours it has. */
const looked = (page, bytes) =>
  page.evaluate(async (base64) => {
    const data = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
    const bitmap = await createImageBitmap(new Blob([data]));
    const pen = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
    pen.drawImage(bitmap, 0, 0);
    const pixels = new Uint32Array(pen.getImageData(0, 0, bitmap.width, bitmap.height).data.buffer);
    const clear = pixels.filter((pixel) => pixel >>> 24 === 0).length / pixels.length;
    return { width: bitmap.width, height: bitmap.height, clear, colours: new Set(pixels).size };
  }, bytes.toString('base64'));

test('the picture has the size that was asked for, the linkage, and no background if so wished', async () => {
  const { page, problems } = await browser.openPage();
  const view = await page.locator('#canvas').evaluate((canvas) => [canvas.clientWidth, canvas.clientHeight, canvas.width]);
  await choose(page, /PNG/);
  const plain = await saved(page, () => page.getByRole('button', { name: 'Save picture' }).click());
  assert.equal(plain.name, '3rps.png');
  const first = await looked(page, plain.bytes);
  assert.deepEqual([first.width, first.height, first.clear], [2 * view[0], 2 * view[1], 0]);
  assert.ok(first.colours > 500, `${first.colours} colours`);

  await choose(page, /PNG/);
  await page.getByLabel('Size in pixels').selectOption({ label: 'Slide: 1920 × 1080' });
  await page.getByLabel('Transparent background').check();
  const slide = await saved(page, () => page.getByRole('button', { name: 'Save picture' }).click());
  const second = await looked(page, slide.bytes);
  assert.deepEqual([second.width, second.height], [1920, 1080]);
  assert.ok(second.clear > 0.3 && second.clear < 0.98, `${second.clear} clear`);
  assert.equal(await page.locator('#canvas').evaluate((canvas) => canvas.width), view[2], 'the view stays as it is');
  assert.deepEqual(problems, []);
});

// The animation bar: what happens at the end, speed, scrubbing by mouse, touch and keys, key frames, a typed frame.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { openBrowser, openSample, scrubTo, text } from './browser.mjs';

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

const PHONE = { viewport: { width: 390, height: 844 }, isMobile: true, hasTouch: true };

/** The shown frame, counted from 1. */
const frame = async (page) => Number((await text(page, 'frame-number')).split(' / ')[0]);
const overflow = (page) => page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
const button = (page, name) => page.getByRole('button', { name, exact: true });

test('once stops at the end, loop begins again', async () => {
  const { page } = await browser.openPage();
  await page.selectOption('#loop', 'once');
  await page.selectOption('#speed', '4');
  await scrubTo(page, 110);
  await button(page, 'Play').click();
  await button(page, 'Play').waitFor();
  assert.equal(await frame(page), 129);
  await page.selectOption('#loop', 'loop');
  await button(page, 'Play').click();
  await page.waitForFunction(() => Number(page$('#scrub').value) < 60);
  assert.equal(await button(page, 'Pause').count(), 1, 'and plays on');
});

test('first and last frame, and what the slider says', async () => {
  const { page } = await browser.openPage({ viewport: { width: 1400, height: 600 } });
  await button(page, 'To the last frame').click();
  assert.equal(await frame(page), 129);
  assert.match(await page.getAttribute('#scrub', 'aria-valuetext'), /^Frame 129 of 129: reached/);
  await button(page, 'To the first frame').click();
  assert.equal(await frame(page), 1);
  assert.equal(await text(page, 'frame-time'), 't = 0.000');
});

test('by mouse: a press anywhere on the strip, a drag, and what is under the pointer in words', async () => {
  const { page } = await browser.openPage();
  const lane = await page.locator('#lane').boundingBox();
  const x = (share) => lane.x + share * lane.width;
  const y = lane.y + 30;
  await page.mouse.move(x(0.25), y);
  await page.locator('#strip-tip').filter({ hasText: /^frame 33: ◐ closest, gap [\d.]+ m, [\d.]+°$/ }).waitFor();
  assert.equal(await frame(page), 1, 'the pointer only reads');
  await page.mouse.down();
  assert.equal(await frame(page), 33);
  await page.mouse.move(x(0.75), y - 80, { steps: 3 });
  assert.equal(await frame(page), 97, 'also when the pointer leaves the strip');
  await page.mouse.move(x(2), y);
  assert.equal(await frame(page), 129);
  await page.mouse.up();
  await page.mouse.move(x(0.5), y - 200);
  assert.equal(await frame(page), 129);
  assert.equal(await page.locator('#strip-tip').isVisible(), false);
  const line = await page.locator('#strip-playhead').boundingBox();
  assert.ok(Math.abs(line.x + line.width / 2 - x(1)) < 1.5, 'the playhead stands there');
  assert.equal(await page.evaluate(() => pageFocus().id), 'scrub', 'and the keys go on from there');
});

test('a press pauses', async () => {
  const { page } = await browser.openPage({ reducedMotion: 'no-preference' });
  const lane = await page.locator('#lane').boundingBox();
  await page.mouse.click(lane.x + lane.width / 2 + 30, lane.y + 30);
  await button(page, 'Play').waitFor();
});

test('by key: one, ten, key frames, ends; beside the animation only', async () => {
  const { page } = await browser.openPage();
  await page.locator('#scrub').focus();
  for (const [key, wanted] of [
    ['ArrowRight', 2], ['PageUp', 12], ['PageDown', 2], ['End', 129], ['Control+ArrowLeft', 65], ['Control+ArrowLeft', 1], ['Control+ArrowRight', 65],
    ['.', 66], [',', 65], ['Home', 1], ['PageDown', 1],
  ]) {
    await page.keyboard.press(key);
    assert.equal(await frame(page), wanted, key);
  }
  await button(page, 'Play').focus();
  await page.keyboard.press('.');
  assert.equal(await frame(page), 2);
  await page.getByRole('tab', { name: 'Mechanism' }).focus();
  await page.keyboard.press('.');
  assert.equal(await frame(page), 2);
});

test('key frames are marked by name, and a press goes there', async () => {
  const { page } = await browser.openPage();
  const tick = page.getByRole('button', { name: 'To key frame between, frame 65' });
  assert.equal(await tick.textContent(), 'between');
  await tick.locator('span').click();
  assert.equal(await frame(page), 65);
  await page.getByRole('button', { name: 'To key frame end, frame 129' }).evaluate((node) => node.click());
  assert.equal(await frame(page), 129, 'by a screen reader');
  await openSample(page, 'scara.json');
  await page.locator('#frame-number').filter({ hasText: '/ 65' }).waitFor();
  const places = await page.locator('.tick').evaluateAll((all) => all.map((one) => Number(one.dataset.frame)));
  assert.deepEqual([places[0], places.at(-1)], [0, 64]);
});

test('a frame is typed; one that is none is refused in words', async () => {
  const { page } = await browser.openPage();
  await page.locator('#frame-number').click();
  const field = page.getByRole('textbox', { name: 'Frame, 1 to 129' });
  await field.fill('200');
  await field.press('Enter');
  await page.getByRole('alert').filter({ hasText: 'There is no frame 200: type a whole number from 1 to 129.' }).waitFor();
  assert.equal(await field.getAttribute('aria-invalid'), 'true');
  assert.equal(await page.locator('#scrub').inputValue(), '0');
  await field.fill('40');
  await field.press('Enter');
  assert.equal(await frame(page), 40);
  assert.equal(await page.evaluate(() => pageFocus().id), 'frame-number');
  await page.keyboard.press('Enter');
  await field.fill('7');
  await page.keyboard.press('Escape');
  assert.equal(await frame(page), 40);
});

test('how frames ended is told apart without colour', async () => {
  const { page } = await browser.openPage();
  const heights = await page.evaluate(() => {
    const of = (name) => [...page$$(`#strip .band.${name}`)].map((band) => band.getAttribute('height'));
    return { reached: of('reached'), closest: of('closest') };
  });
  assert.deepEqual(heights.reached, ['4', '4']);
  assert.equal(heights.closest.length, 2, 'a double line');
  assert.match(await page.getAttribute('#strip', 'aria-label'), /2 reached, 127 closest/);
});

for (const [width, rows] of [[800, 2], [1100, 1], [1300, 1], [390, 2]]) {
  test(`the bar has ${rows} rows at ${width}`, async () => {
    const { page } = await browser.openPage({ viewport: { width, height: 600 } });
    const box = async (id) => page.locator(id).boundingBox();
    const [buttons, modes, track] = [await box('#play'), await box('#speed'), await box('#track')];
    assert.equal(track.y + track.height <= buttons.y, rows === 2, 'the track stands above the buttons, or beside them');
    if (rows === 1) assert.ok(track.x > buttons.x + buttons.width && track.x + track.width < modes.x && track.width > 200);
    assert.ok(Math.abs(buttons.y - modes.y) < 8, 'buttons and speed stand in one line');
    assert.ok(modes.x + modes.width <= (await box('.stage')).x + (await box('.stage')).width);
  });
}

test('on a phone: by touch, with room for a thumb, and nothing sticks out', async () => {
  const { page, problems } = await browser.openPage(PHONE);
  assert.equal(await overflow(page), 0);
  const track = await page.locator('#track').boundingBox();
  assert.ok(track.height >= 44 && track.width > 340, `${track.width} × ${track.height}`);
  const lane = await page.locator('#lane').boundingBox();
  await page.touchscreen.tap(lane.x + lane.width * 0.25, track.y + 30);
  assert.equal(await frame(page), 33);
  const client = await page.context().newCDPSession(page);
  const touch = (type, share) =>
    client.send('Input.dispatchTouchEvent', { type, touchPoints: share === undefined ? [] : [{ x: lane.x + lane.width * share, y: track.y + 30 }] });
  await touch('touchStart', 0.4);
  for (const share of [0.45, 0.55, 0.75]) await touch('touchMove', share);
  await page.waitForFunction(() => page$('#scrub').value === '96');
  assert.ok(await page.locator('#strip-tip').isVisible(), 'the finger hides the strip, not what it says');
  await touch('touchEnd');
  assert.equal(await frame(page), 97);
  for (const name of ['Play', 'One frame back', 'One frame on']) assert.ok((await button(page, name).boundingBox()).height >= 36, name);
  for (const id of ['speed', 'loop', 'frame-number']) assert.ok((await page.locator(`#${id}`).boundingBox()).height >= 36, id);
  assert.deepEqual(problems, []);
});

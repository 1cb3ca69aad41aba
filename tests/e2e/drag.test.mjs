// Moving by hand: the gizmo on a key frame.
import assert from 'node:assert/strict';
import { after, afterEach, before, test } from 'node:test';
import { cell, metricBecomes, number, openBrowser, otherMetric, text } from './browser.mjs';

let browser;
let page;
let problems;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());
afterEach(async () => {
  assert.deepEqual(problems, []);
  await page.context().close();
});

const KEY = 'motion.key_frames[1]';

/** The page with the gizmo on the second key frame of the 3RPS, at whose moment the playhead stands. */
async function keyInHand(options) {
  ({ page, problems } = await browser.openPage(options));
  await page.locator('#scrub').fill('64');
  await page.locator(`#labels [data-place="${KEY}"]`).click();
  await page.locator('.drag-bar').getByText('between').waitFor();
  await settled();
}

/** Names of the scene are set 8 px right of and 22 px above their things. */
async function placeOf(path) {
  const tag = page.locator(`#labels [data-place="${path}"]`);
  return tag.evaluate((node) => {
    const { x, y } = node.getBoundingClientRect();
    return { x: x - parseFloat(getComputedStyle(node).left), y: y - parseFloat(getComputedStyle(node).top) };
  });
}

/** Until the picture is drawn and the planner has answered. */
const settled = () => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 50)))));

async function drag(from, dx, dy, { steps = 4, release = true } = {}) {
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  for (let i = 1; i <= steps; i++) await page.mouse.move(from.x + (dx * i) / steps, from.y + (dy * i) / steps);
  if (release) await page.mouse.up();
}

const coordinates = async () => {
  await page.getByRole('tab', { name: 'Motion' }).click();
  const names = ['x', 'y', 'z', 'longitude', 'latitude', 'roll'];
  return Promise.all(names.map(async (name) => Number((await cell(page, `${KEY}.${name}`).getAttribute('title')) || (await cell(page, `${KEY}.${name}`).inputValue()))));
};
const bar = (name) => page.locator('.drag-bar').getByRole('button', { name });

test('a drag of the gizmo moves the key frame, the motion follows, and one undo takes the whole drag back', async () => {
  await keyInHand();
  const old = await text(page, 'metric');
  const before = await coordinates();
  await drag(await placeOf(KEY), 40, -30);
  await otherMetric(page, old);
  const after = await coordinates();
  assert.notDeepEqual(after.slice(0, 3), before.slice(0, 3));
  assert.deepEqual(after.slice(3), before.slice(3), 'it is moved, not turned');
  assert.ok(number(await text(page, 'closure')) <= 1e-10);
  await page.keyboard.press('Control+z');
  await metricBecomes(page, old);
  assert.deepEqual(await coordinates(), before);
  assert.ok(await page.locator('#undo').isDisabled(), 'one step');
});

test('with Shift the numbers are round', async () => {
  await keyInHand();
  const before = await coordinates();
  await page.keyboard.down('Shift');
  await drag(await placeOf(KEY), 35, -45);
  await page.keyboard.up('Shift');
  await page.waitForFunction(() => !document.querySelector('#undo').disabled);
  const after = await coordinates();
  assert.notDeepEqual(after, before);
  for (const value of after.slice(0, 3)) assert.ok(Math.abs(value * 20 - Math.round(value * 20)) < 1e-9, `${value} is round`);
});

test('in turning mode the angles change and the place stays', async () => {
  await keyInHand();
  await bar('Turn').click();
  const before = await coordinates();
  const at = await placeOf(KEY);
  await drag({ x: at.x + 8, y: at.y + 6 }, 30, 12);
  await page.waitForFunction(() => !document.querySelector('#undo').disabled);
  const after = await coordinates();
  assert.deepEqual(after.slice(0, 3), before.slice(0, 3));
  assert.notDeepEqual(after.slice(3), before.slice(3));
});

test('Escape during a drag gives the key frame back', async () => {
  await keyInHand();
  const old = await text(page, 'metric');
  const before = await coordinates();
  await drag(await placeOf(KEY), 40, -30, { release: false });
  await otherMetric(page, old);
  await page.keyboard.press('Escape');
  await metricBecomes(page, old);
  await page.mouse.up();
  assert.deepEqual(await coordinates(), before);
  assert.ok(await page.locator('#undo').isDisabled(), 'nothing is left to undo');
  assert.ok(await bar('Move').isVisible(), 'it is still in hand');
});

test('keys move and turn by a step, along the axes of the world or its own', async () => {
  await keyInHand();
  const before = await coordinates();
  await page.locator('#canvas').focus();
  await page.keyboard.press('PageUp');
  await page.waitForFunction(() => !document.querySelector('#undo').disabled);
  let now = await coordinates();
  const step = now[2] - before[2];
  assert.ok([0.05, 0.1, 0.2].some((round) => Math.abs(step - round) < 1e-5), `a step of ${step}`);
  assert.deepEqual([now[0], now[1]], [before[0], before[1]]);
  assert.match(await page.locator('.drag-bar [role=status]').textContent(), /between at x/);

  await page.keyboard.press('Control+z');
  await page.locator('#canvas').focus();
  await page.keyboard.press('r');
  await page.keyboard.press('PageUp');
  now = await coordinates();
  assert.deepEqual(now.slice(0, 3), before.slice(0, 3));
  assert.notDeepEqual(now.slice(3), before.slice(3));

  await page.keyboard.press('Control+z');
  await page.locator('#canvas').focus();
  await page.keyboard.press('x');
  assert.equal(await bar('axes').textContent(), 'Own axes');
  await page.keyboard.press('PageUp');
  now = await coordinates();
  // A turn about its own z axis is a roll.
  assert.ok(Math.abs(now[5] - before[5] - 15) < 1e-3, `rolled by ${now[5] - before[5]}`);
  assert.deepEqual(now.slice(0, 5), before.slice(0, 5));

  await page.locator('#canvas').focus();
  await page.keyboard.press('Escape');
  await page.locator('.drag-bar').waitFor({ state: 'hidden' });
});

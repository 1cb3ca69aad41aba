// Moving by hand: the gizmo on a key frame and on the workpiece, the freedoms' handles, things dragged themselves.
import assert from 'node:assert/strict';
import { after, afterEach, before, test } from 'node:test';
import { cell, metricBecomes, number, openBrowser, openSample, otherMetric, text } from './browser.mjs';

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

/** A name's flag is shifted from the point that it names. */
async function placeOf(path) {
  const tag = page.locator(`#labels [data-place="${path}"]`);
  return tag.evaluate((node) => {
    const { x, y } = node.getBoundingClientRect();
    const [right, down] = node.style.translate.split(' ').map(parseFloat);
    return { x: x - right, y: y - down };
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
  await page.getByRole('tab', { name: 'Motion', exact: true }).click();
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
  await page.waitForFunction(() => !page$('#undo').disabled);
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
  await page.waitForFunction(() => !page$('#undo').disabled);
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
  await page.waitForFunction(() => !page$('#undo').disabled);
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

/** The page with the workpiece selected, its place on the screen told by the canvas. */
async function pieceInHand(options, sample) {
  ({ page, problems } = await browser.openPage(options));
  if (sample) {
    await openSample(page, sample);
    await page.waitForFunction(() => page$('#mobility-count').textContent === '−2');
    // What the pointer is over is gone on from.
    await page.mouse.move(0, 0);
  }
  await page.locator('#scrub').fill('40');
  await page.locator('#canvas').focus();
  await page.keyboard.press(']');
  await page.keyboard.press('Enter');
  await page.locator('.drag-bar strong', { hasText: 'workpiece' }).waitFor();
  await settled();
}

async function hand() {
  const [x, y] = (await page.locator('#canvas').getAttribute('data-hand')).split(' ').map(Number);
  const box = await page.locator('#canvas').boundingBox();
  return { x: box.x + x, y: box.y + y };
}

/** Until a picture shows the workpiece there, or, the other way, elsewhere: pictures come after the numbers. @param {string} place of `data-hand` */
const handComes = (place, there = true) => page.waitForFunction(([place, there]) => (page$('#canvas').dataset.hand === place) === there, [place, there]);
const placeInHand = () => page.locator('#canvas').getAttribute('data-hand');

/** Until a thing stays where it is: handles are laid anew once the planner has explained the new posture. */
const atRest = (selector) =>
  page.waitForFunction(
    (which) => {
      const { x, y } = page$(which).getBoundingClientRect();
      const now = `${x} ${y}`;
      const rests = globalThis.lastPlace === now;
      globalThis.lastPlace = now;
      return rests;
    },
    selector,
    { polling: 400 },
  );

const byHand = (shown) => page.locator('#by-hand').waitFor({ state: shown ? 'visible' : 'hidden' });
const frameIsShown = (number) => page.locator('#frame-number').filter({ hasText: `${number} /` }).waitFor();

test('the workpiece is pulled by its gizmo: the linkage follows with closed loops, and the motion comes back', async () => {
  await pieceInHand();
  const old = await text(page, 'metric');
  const before = await placeInHand();
  await drag(await hand(), 70, 20);
  await byHand(true);
  await otherMetric(page, old);
  assert.ok(number(await text(page, 'closure')) <= 1e-10);
  await handComes(before, false);
  await page.getByRole('button', { name: 'Back to the motion' }).click();
  assert.ok(await page.locator('#undo').isDisabled(), 'the document is untouched');
  await byHand(false);
  await metricBecomes(page, old);
  await frameIsShown(41);
  await handComes(before);
});

test('the workpiece itself can be dragged; Escape lets it go back', async () => {
  await pieceInHand();
  await page.keyboard.press('Escape');
  await page.locator('.drag-bar').waitFor({ state: 'hidden' });
  await settled();
  // Without the move bar the picture is higher, and the workpiece elsewhere in it.
  const at = await page.evaluate(async () => {
    const { scene, store } = await document.querySelector('synthetica-linkage').workbench;
    const { motion } = store.result;
    const seen = scene.size.centre.clone().fromArray(motion.pose, 7 * store.view.frame).project(scene.camera);
    const { x, y, width, height } = scene.canvas.getBoundingClientRect();
    return { x: x + ((seen.x + 1) / 2) * width, y: y + ((1 - seen.y) / 2) * height };
  });
  await drag(at, 30, -40, { release: false });
  await byHand(true);
  await page.keyboard.press('Escape');
  await byHand(false);
  await page.mouse.up();
  await drag(at, 30, -40);
  await byHand(true);
  await page.locator('.drag-bar strong', { hasText: 'workpiece' }).waitFor();
});

test('a finger drags the workpiece', async () => {
  await pieceInHand({ viewport: { width: 390, height: 844 }, isMobile: true, hasTouch: true });
  const at = await hand();
  const devtools = await page.context().newCDPSession(page);
  const touch = (type, points) => devtools.send('Input.dispatchTouchEvent', { type, touchPoints: points });
  await touch('touchStart', [at]);
  for (let i = 1; i <= 5; i++) await touch('touchMove', [{ x: at.x + 8 * i, y: at.y - 6 * i }]);
  await touch('touchEnd', []);
  await byHand(true);
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), 'nothing sticks out');
});

test('a posture becomes a key frame or the start', async () => {
  await pieceInHand();
  await page.keyboard.press('PageUp');
  await byHand(true);
  await page.getByRole('button', { name: 'Add key frame here' }).click();
  await page.locator('#labels [data-place="motion.key_frames[3]"]').waitFor();
  await page.getByRole('tab', { name: 'Motion', exact: true }).click();
  await cell(page, 'motion.key_frames[3].z').waitFor();
  await page.keyboard.press('Control+z');
  await cell(page, 'motion.key_frames[3].z').waitFor({ state: 'detached' });
  await byHand(false);
});

for (const [sample, count] of [['', 3], ['four-bar.json', 1]]) {
  test(`${sample || '3rps.json'}: as many freedoms are offered as there are, and each moves the workpiece`, async () => {
    await pieceInHand({ viewport: { width: 1280, height: 800 } }, sample);
    // Every way to move is chosen by the key that its tooltip names.
    for (const mode of ['Turn', 'Move', 'Freedoms']) {
      const button = page.getByRole('toolbar', { name: 'Drag' }).getByRole('button', { name: mode, exact: true });
      await page.keyboard.press(/\((\w)\)$/.exec(await button.getAttribute('title'))[1].toLowerCase());
      assert.equal(await button.getAttribute('aria-pressed'), 'true', mode);
    }
    const freedoms = page.locator('.freedoms [data-freedom]');
    await freedoms.first().waitFor();
    // The same words on the handles' buttons and in the info panel.
    const words = await freedoms.evaluateAll((all) => all.map(({ title }) => title));
    assert.deepEqual(
      await page.locator('.why-freedoms li').evaluateAll((all) => all.map(({ textContent }) => textContent.charAt(0).toLowerCase() + textContent.slice(1))),
      words,
    );
    assert.equal(await freedoms.count(), count);
    for (let i = 0; i < count; i++) {
      await freedoms.nth(i).getByRole('button', { name: /^Forwards/ }).focus();
      const where = await text(page, 'canvas-text');
      await page.keyboard.press('ArrowRight');
      await byHand(true);
      await page.waitForFunction((old) => page$('#canvas-text').textContent !== old, where);
      assert.ok(number(await text(page, 'closure')) <= 1e-10);
    }
    await page.getByRole('button', { name: 'Back to the motion' }).click();
    await byHand(false);
    await page.waitForFunction((wanted) => page$$('.freedoms [data-freedom]').length === wanted, count);

    // The first freedom's handle, taken by the arrow's head, where its name stands.
    await atRest('.hand-labels span');
    const tip = await page.locator('.hand-labels span').first().boundingBox();
    const from = { x: tip.x + tip.width / 2, y: tip.y + tip.height / 2 };
    const to = await hand();
    const still = await text(page, 'canvas-text');
    await drag(from, (to.x - from.x) * 0.5, (to.y - from.y) * 0.5);
    await byHand(true);
    await page.waitForFunction((old) => page$('#canvas-text').textContent !== old, still);
    assert.ok(number(await text(page, 'closure')) <= 1e-10);
  });
}

test('another document that comes while a key frame is dragged is not changed by the hand, nor by Escape', async () => {
  for (const key of ['', 'Escape']) {
    // Anew: in the other document the names may lie one over the other.
    await keyInHand();
    const from = await placeOf(KEY);
    await drag(from, 40, -30, { release: false });
    await page.evaluate(async (name) => {
      const element = document.querySelector('synthetica-linkage');
      const { store } = await element.workbench;
      window.other = { ...store.doc, name, motion: { ...store.doc.motion, key_frames: store.doc.motion.key_frames.map((one) => ({ ...one, x: 0.01, y: 0.02 })) } };
      store.open(window.other, { title: '', handle: null, saved: window.other });
    }, `other ${key}`);
    await page.mouse.move(from.x + 60, from.y - 60);
    if (key) await page.keyboard.press(key);
    await page.mouse.up();
    const same = await page.evaluate(async () => (await document.querySelector('synthetica-linkage').workbench).store.doc === window.other);
    assert.ok(same, `after ${key || 'a move'}`);
  }
});

// Phone, dark scheme, keyboard, reduced motion.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { cell, metricBecomes, openBrowser, otherMetric, scrubTo, text } from './browser.mjs';

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

const PHONE = { viewport: { width: 390, height: 844 }, isMobile: true, hasTouch: true };

const overflow = (page) => page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);

test('on a phone nothing sticks out, and every panel can be reached', async () => {
  const { page, problems } = await browser.openPage(PHONE);
  for (const name of ['Mechanism', 'Motion', 'Info']) {
    await page.getByRole('tab', { name, exact: true }).tap();
    assert.ok(await page.getByRole('tabpanel', { name, exact: true }).isVisible(), name);
    assert.equal(await overflow(page), 0, name);
  }
  assert.ok(await page.locator('#gap-translation').isVisible());
  const view = await page.locator('#canvas').boundingBox();
  assert.ok(view.width === 390 && view.y < 844 / 3, 'the view is on top');
  assert.deepEqual(problems, []);
});

test('on a phone every tab is whole, and what is focused does not lie under the view', async () => {
  const { page } = await browser.openPage(PHONE);
  for (const tab of await page.getByRole('tab').all()) {
    if (!(await tab.isVisible())) continue;
    const box = await tab.boundingBox();
    assert.ok(box.x >= 0 && box.x + box.width <= 390, `${await tab.textContent()}: ${JSON.stringify(box)}`);
  }
  // From below upwards, which brings things to the upper edge, where the view is.
  await cell(page, 'chains[2].joints[2].rows[0].alpha').focus();
  const under = [];
  for (let i = 0; i < 40; i++) {
    await page.keyboard.press('Shift+Tab');
    const found = await page.evaluate(() => {
      const at = pageFocus();
      if (!at.closest('#tables, #tabs')) return null;
      const below = page$('#stage').getBoundingClientRect().bottom;
      return at.getBoundingClientRect().top < below - 1 ? at.outerHTML.slice(0, 120) : '';
    });
    if (found === null) break;
    if (found) under.push(found);
  }
  assert.deepEqual(under, []);
});

test('the first stop of the Tab key leads past everything to the tables', async () => {
  const { page } = await browser.openPage();
  await page.keyboard.press('Tab');
  assert.equal(await page.evaluate(() => pageFocus().id), 'skip');
  assert.ok((await page.locator('#skip').boundingBox()).y >= 0, 'it is seen while it has the focus');
  await page.keyboard.press('Enter');
  assert.ok(await page.evaluate(() => pageFocus().matches('#mechanism *')));
  await page.getByRole('tab', { name: 'Motion', exact: true }).click();
  await page.locator('#motion input').first().waitFor();
  await page.locator('#skip').focus();
  await page.keyboard.press('Enter');
  assert.ok(await page.evaluate(() => pageFocus().matches('#motion *')));
});

test('in forced colours the chosen tab differs from the others', async () => {
  const { page } = await browser.openPage({ forcedColors: 'active' });
  const line = (name) => page.getByRole('tab', { name, exact: true }).evaluate((tab) => getComputedStyle(tab).borderBottomColor);
  await page.getByRole('tab', { name: 'Motion', exact: true }).click();
  await page.mouse.move(400, 300);
  assert.notEqual(await line('Motion'), await line('Mechanism'));
  assert.equal(await line('Teach'), await line('Mechanism'));
});

test('what cannot be chosen in a menu is reached by the keys and says why', async () => {
  const { page } = await browser.openPage();
  await page.getByRole('button', { name: 'Actions of chain 1', exact: true }).focus();
  await page.keyboard.press('Enter');
  const item = page.getByRole('menuitem', { name: /^Move up/ });
  assert.ok(await item.evaluate((entry) => entry === pageFocus()));
  assert.equal(await item.getAttribute('aria-disabled'), 'true');
  assert.match(await item.textContent(), /It is the first/);
  const before = await page.evaluate(() => document.querySelector('synthetica-linkage').parts.store.doc);
  await page.keyboard.press('Enter');
  assert.ok(await item.isVisible(), 'the menu stays');
  assert.deepEqual(await page.evaluate(() => document.querySelector('synthetica-linkage').parts.store.doc), before);
});

for (const [width, height] of [[1280, 800], [800, 600], [844, 390], [640, 400]]) {
  test(`nothing sticks out at ${width} × ${height}`, async () => {
    const { page } = await browser.openPage({ viewport: { width, height } });
    assert.equal(await overflow(page), 0);
    const view = await page.locator('#canvas').boundingBox();
    assert.ok(view.width > 150 && view.height > 150, 'the view has room');
  });
}

test('the dark scheme is dark, the view too', async () => {
  const lightness = async (colorScheme) => {
    const { page, problems } = await browser.openPage({ colorScheme });
    const image = await page.locator('#canvas').screenshot();
    const shades = await page.evaluate(async (bytes) => {
      const bitmap = await createImageBitmap(new Blob([new Uint8Array(bytes)]));
      const { width, height } = bitmap;
      const context = new OffscreenCanvas(width, height).getContext('2d');
      context.drawImage(bitmap, 0, 0);
      const { data } = context.getImageData(0, 0, width, height);
      let sum = 0;
      const seen = new Set();
      for (let i = 0; i < data.length; i += 4) {
        sum += data[i] + data[i + 1] + data[i + 2];
        seen.add((data[i] << 16) | (data[i + 1] << 8) | data[i + 2]);
      }
      return { mean: sum / (width * height * 3 * 255), colours: seen.size };
    }, [...image]);
    assert.ok(shades.colours > 100, 'something is drawn');
    assert.deepEqual(problems, []);
    return shades.mean;
  };
  assert.ok((await lightness('dark')) < 0.35);
  assert.ok((await lightness('light')) > 0.65);
});

test('an edit by keyboard only: find the cell, type, go on, undo', async () => {
  const { page } = await browser.openPage();
  await scrubTo(page, 60);
  const old = await text(page, 'metric');
  const place = () => page.evaluate(() => pageFocus().dataset.path);
  await page.locator('#scrub').focus();
  const wanted = 'chains[0].joints[0].rows[0].alpha';
  for (let i = 0; i < 40 && (await place()) !== wanted; i++) await page.keyboard.press('Tab');
  assert.equal(await place(), wanted);
  await page.keyboard.type('12');
  await otherMetric(page, old);
  await page.keyboard.press('Enter');
  assert.equal(await place(), 'chains[0].joints[1].rows[0].alpha', 'Enter goes down');
  await page.keyboard.press('ArrowUp');
  assert.equal(await place(), wanted, 'the arrow goes up');
  const outline = await cell(page, wanted).evaluate((field) => getComputedStyle(field).outlineStyle);
  assert.notEqual(outline, 'none', 'the focus can be seen');
  await page.keyboard.press('Control+z');
  await metricBecomes(page, old);
});

test('reduced motion: nothing moves before it is asked to', async () => {
  const { page } = await browser.openPage();
  assert.equal(await page.locator('#play').getAttribute('aria-label'), 'Play');
  assert.match(await text(page, 'frame-number'), /^1 \//);
  await page.locator('#play').click();
  await page.waitForFunction(() => page$('#scrub').value !== '0');
});

test('the view has a text, and the status is spoken when the motion rests', async () => {
  const { page } = await browser.openPage();
  await scrubTo(page, 30);
  await page.locator('#live').filter({ hasText: /Frame 31 of \d+: .* from the goal/ }).waitFor();
  assert.match(await text(page, 'canvas-text'), /3 chains \(RPS, RPS, RPS\).*Frame 31/);
});

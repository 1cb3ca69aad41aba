// Cells show every digit, follow what is shown, and are seen when they are gone to.
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { after, afterEach, before, test } from 'node:test';
import { cell, openBrowser } from './browser.mjs';

const PHONE = { viewport: { width: 390, height: 844 }, isMobile: true, hasTouch: true };
/** With rows; those of makers have expressions and axes in their cells. */
const samples = readdirSync('www/mechanisms').filter((file) => file !== 'index.json' && !JSON.parse(readFileSync(`www/mechanisms/${file}`, 'utf8')).parameters);

let browser;
let problems;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());
afterEach(() => assert.deepEqual(problems, []));

/** A sample in millimetres with three decimals, as a CAD program gives them. */
function inMillimetres(file) {
  const doc = JSON.parse(readFileSync(`www/mechanisms/${file}`, 'utf8'));
  const scale = (holder, keys) => {
    for (const key of keys) if (holder?.[key]) holder[key] = Number((holder[key] * 1000 + 0.123).toFixed(3));
  };
  for (const chain of doc.chains) {
    scale(chain.base, ['x', 'y', 'z']);
    scale(chain.gripper, ['x', 'y', 'z']);
    for (const joint of chain.joints) {
      for (const row of joint.rows) scale(row, ['a', 'd']);
      if (joint.type === 'P') for (const limit of joint.limits ?? []) scale(limit, ['min', 'max']);
    }
    delete chain.start;
  }
  for (const key of doc.motion.key_frames) scale(key, ['x', 'y', 'z']);
  delete doc.motion.radius;
  doc.motion.reference = [-1234.123, 0, 1234.123];
  return { ...doc, name: `${file} in mm`, length_unit: 'mm' };
}

for (const [name, options] of [['a desktop', {}], ['a phone', PHONE]]) {
  test(`no cell cuts a digit of a sample in millimetres on ${name}`, async () => {
    const opened = await browser.openPage(options);
    ({ problems } = opened);
    const { page } = opened;
    for (const file of samples) {
      const doc = inMillimetres(file);
      await page.locator('#file').setInputFiles({ name: file, mimeType: 'application/json', buffer: Buffer.from(JSON.stringify(doc)) });
      await page.waitForFunction((wanted) => page$('[data-path="name"]').value === wanted, doc.name);
      for (const panel of ['Mechanism', 'Motion']) {
        await page.getByRole('tab', { name: panel, exact: true }).click();
        await page.waitForFunction(() => page$$('.panel.shown input.cell:not(.text)').length > 15);
        const { cut, count } = await page.evaluate(() => {
          for (const fold of page$$('.chain details')) fold.open = true;
          const numbers = page$$('.panel.shown input.cell:not(.text)').filter((field) => field.clientWidth);
          return { cut: numbers.filter((field) => field.scrollWidth > field.clientWidth).map((field) => `${field.dataset.path}: ${field.value}`), count: numbers.length };
        });
        assert.ok(count > 15, `${count} cells in ${panel}`);
        assert.deepEqual(cut, [], `${file}, ${panel}`);
      }
      await page.getByRole('tab', { name: 'Mechanism' }).click();
      const constant = cell(page, 'chains[0].joints[0].rows[0].theta');
      await constant.fill('-180.125');
      assert.ok(await constant.evaluate((field) => field.scrollWidth <= field.clientWidth), 'nor what is being typed');
    }
  });
}

test('Enter on a phone goes to a cell below the view, not under it', async () => {
  const opened = await browser.openPage(PHONE);
  ({ problems } = opened);
  const { page } = opened;
  const first = cell(page, 'chains[1].joints[0].rows[0].alpha');
  const stage = await page.locator('#stage').evaluate((node) => node.offsetHeight);
  // Both rows under the view that stays, as they are after scrolling on.
  await first.evaluate((field) => field.focus({ preventScroll: true }));
  await first.evaluate((field, height) => window.scrollBy(0, field.getBoundingClientRect().top - height / 2), stage);
  await page.keyboard.press('Enter');
  const [box, view] = [await page.locator('[data-path="chains[1].joints[1].rows[0].alpha"]').boundingBox(), await page.locator('#stage').boundingBox()];
  assert.equal(await page.evaluate(() => pageFocus().dataset.path), 'chains[1].joints[1].rows[0].alpha');
  assert.equal(view.y, 0, 'the view stays on top');
  assert.ok(box.y >= view.y + view.height, `the cell at ${box.y} is below the view, which ends at ${view.y + view.height}`);
});

test('the joint values beside start values follow a linkage that is moved by hand', async () => {
  const opened = await browser.openPage();
  ({ problems } = opened);
  const { page } = opened;
  await page.locator('.chain details summary').first().click();
  const now = page.locator('.start .now output').first();
  const planned = await now.textContent();
  assert.match(planned, /\d/);
  await page.getByRole('tab', { name: 'Teach' }).click();
  const slider = page.locator('#teach input[type=range]').first();
  await slider.focus();
  await page.keyboard.press('ArrowRight');
  await page.locator('#by-hand').waitFor();
  const posed = await page.waitForFunction((old) => page$('.start .now output').textContent !== old && page$('.start .now output').textContent, planned);
  assert.notEqual(await posed.jsonValue(), planned);
  await page.locator('#back-to-motion').click();
  await page.waitForFunction((old) => page$('.start .now output').textContent === old, planned);
});

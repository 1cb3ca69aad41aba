// Charts: the motion's numbers, the playhead, scrubbing, series, tables; the dock that holds them.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { cell, number, openBrowser, otherMetric, scrubTo, text, unfoldCharts } from './browser.mjs';

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

const PHONE = { viewport: { width: 390, height: 844 }, isMobile: true, hasTouch: true };

const chart = (page, name) => page.getByRole('region', { name, exact: true });

/** The dock is folded at first. */
async function openCharts(options) {
  const { page, problems } = await browser.openPage(options);
  assert.equal(await page.locator('#charts').isVisible(), false, 'folded until it is wanted');
  await page.getByRole('tab', { name: 'Charts' }).click();
  await chart(page, 'Translation gap').waitFor();
  return { page, problems };
}

/** The table of a chart: its rows as numbers. */
async function tableOf(page, name) {
  const details = chart(page, name).locator('details');
  await details.locator('summary').click();
  await details.locator('tbody tr').first().waitFor();
  const rows = await details.locator('tbody tr').evaluateAll((all) => all.map((row) => [...row.cells].map((one) => one.textContent)));
  return rows.map((row) => row.map(number));
}

/** Where the playhead's line stands in a chart, from 0 to 1. */
const playhead = (page, name) =>
  chart(page, name).locator('.playhead').evaluate((line) => {
    const [at, within] = [line.getBoundingClientRect(), line.parentElement.getBoundingClientRect()];
    return (at.left + at.width / 2 - within.left) / within.width;
  });

const near = (a, b, within, what) => assert.ok(Math.abs(a - b) <= within, `${what}: ${a} is not ${b}`);

test('the charts are loaded when they are first seen, without a complaint', async () => {
  const { page, problems } = await browser.blankPage();
  const asked = [];
  page.on('request', (request) => asked.push(request.url()));
  await page.goto(browser.address);
  await page.waitForFunction(() => (page$('#closure')?.textContent ?? '–') !== '–');
  assert.ok(!asked.some((url) => /charts/.test(url)));
  await page.getByRole('tab', { name: 'Charts' }).click();
  await chart(page, 'Translation gap').waitFor();
  assert.ok(asked.some((url) => /charts.*\.js/.test(url)));
  assert.deepEqual(problems, []);
});

test('tables hold the numbers of every frame, and the charts say the same in words', async () => {
  const { page } = await openCharts({ viewport: { width: 1000, height: 600 } });
  const rows = await tableOf(page, 'Translation gap');
  const frames = Number(await page.getAttribute('#scrub', 'max')) + 1;
  assert.deepEqual(rows.map(([frame]) => frame), Array.from({ length: frames }, (_, i) => i + 1));
  for (const frame of [0, 30, 64, frames - 1]) {
    await scrubTo(page, frame);
    assert.equal(rows[frame].at(-1), number(await text(page, 'gap-translation')), `frame ${frame + 1}`);
  }
  const largest = Math.max(...rows.map((row) => row.at(-1)));
  const words = await chart(page, 'Translation gap').getByRole('img').getAttribute('aria-label');
  assert.match(words, new RegExp(`^Translation gap: 0 to ${largest} m, largest at frame \\d+\\.$`));
  assert.equal(rows[Number(words.match(/frame (\d+)/)[1]) - 1].at(-1), largest);
  const table = chart(page, 'Translation gap').getByRole('table', { name: /Translation gap, all 129 frames/ });
  assert.ok(await table.isVisible());
  assert.equal(await table.locator('thead th[scope=col]').count(), 3);
});

test('the playhead moves through the charts, and a click or a drag in one moves the playhead', async () => {
  const { page } = await openCharts();
  await scrubTo(page, 32);
  near(await playhead(page, 'Translation gap'), 0.25, 0.01, 'at a quarter');
  assert.equal(await chart(page, 'Translation gap').locator('.value').textContent(), await text(page, 'gap-translation'));
  const over = chart(page, 'Rotation gap').locator('.u-over');
  await over.scrollIntoViewIfNeeded();
  const box = await over.boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + 20);
  await page.locator('.reading').filter({ hasText: /under the pointer: frame 6[456]/ }).waitFor();
  assert.match(await text(page, 'frame-number'), /^33 \//, 'the pointer only reads');
  await page.mouse.down();
  assert.match(await text(page, 'frame-number'), /^6[456] \//);
  await page.mouse.move(box.x + box.width * 0.75, box.y + 20);
  assert.match(await text(page, 'frame-number'), /^9[678] \//);
  await page.mouse.up();
  await page.mouse.move(box.x + 4, box.y - 200);
  await page.locator('.reading').filter({ hasText: /^at frame 9[678]/ }).waitFor();
  near(await playhead(page, 'Rotation gap'), 0.75, 0.02, 'at three quarters');
});

test('an edit comes into the charts', async () => {
  const { page } = await openCharts();
  await scrubTo(page, 60);
  const value = chart(page, 'Translation gap').locator('.value');
  const [old, metric] = [await value.textContent(), await text(page, 'metric')];
  await page.getByRole('tab', { name: 'Mechanism' }).click();
  await cell(page, 'chains[0].gripper.x').fill('0.7');
  await otherMetric(page, metric);
  await page.waitForFunction(() => page$('[aria-label="Translation gap"] .value').textContent === page$('#gap-translation').textContent);
  assert.notEqual(await value.textContent(), old);
});

test('charts are chosen, series hidden and shown', async () => {
  const { page } = await openCharts({ viewport: { width: 1000, height: 690 } });
  const joints = chart(page, 'chain 1, angles');
  await joints.scrollIntoViewIfNeeded();
  const series = joints.getByRole('button', { name: 'θ₁' });
  const drawn = () => joints.locator('canvas').evaluate((canvas) => canvas.toDataURL());
  const settled = (old) => page.waitForFunction(([before]) => page$('[aria-label="chain 1, angles"] canvas').toDataURL() !== before, [old]);
  const before = await drawn();
  await series.click();
  assert.equal(await series.getAttribute('aria-pressed'), 'false');
  await settled(before);
  const without = await drawn();
  await series.click();
  await settled(without);
  assert.equal(await drawn(), before);

  await page.getByRole('button', { name: 'Choose charts' }).click();
  await page.getByRole('checkbox', { name: 'Joint variables' }).uncheck();
  await page.getByRole('checkbox', { name: 'Iterations' }).check();
  await page.keyboard.press('Escape');
  await joints.waitFor({ state: 'detached' });
  await chart(page, 'Iterations').waitFor();
  const rows = await tableOf(page, 'Iterations');
  await scrubTo(page, 20);
  assert.equal(rows[20].at(-1), number(await text(page, 'iterations')));
});

test('over time instead of frames', async () => {
  const { page } = await openCharts();
  await page.selectOption('#charts select', 'time');
  await scrubTo(page, 64);
  near(await playhead(page, 'Translation gap'), 0.5, 0.01, 'half of the time');
});

test('the dock is folded and made higher by keyboard and by pointer, and stays so', async () => {
  const { page } = await openCharts({ viewport: { width: 800, height: 690 } });
  const panel = page.locator('#charts');
  const height = async () => (await panel.boundingBox()).height;
  const handle = page.getByRole('separator', { name: 'Height of the charts' });
  const first = await height();
  await handle.focus();
  await page.keyboard.press('ArrowUp');
  assert.equal(await height(), first + 24);
  const box = await handle.boundingBox();
  await page.mouse.move(box.x + 20, box.y + 4);
  await page.mouse.down();
  await page.mouse.move(box.x + 20, box.y + 64);
  await page.mouse.up();
  near(await height(), first - 36, 1, 'dragged down');
  const kept = await height();
  await page.reload();
  await panel.waitFor();
  assert.equal(await height(), kept);
  await page.getByRole('button', { name: 'Charts and algorithm' }).click();
  assert.equal(await panel.isVisible(), false);
  assert.ok((await page.locator('#canvas').boundingBox()).height > 300);
  await page.getByRole('button', { name: 'Charts and algorithm' }).click();
  await page.setViewportSize({ width: 800, height: 480 });
  assert.equal(await page.evaluate(() => document.documentElement.scrollHeight), 480, 'a low window holds both');
  assert.ok((await page.locator('#canvas').boundingBox()).height >= 160);
  assert.ok((await height()) >= 90);
});

test('dark: the charts are drawn anew in the other colours', async () => {
  const { page } = await openCharts();
  const canvas = page.locator('.chart canvas').first();
  // Green of what is drawn, on the average: ink is dark on light and light on dark.
  const lightness = () =>
    canvas.evaluate((drawn) => {
      const { data } = drawn.getContext('2d').getImageData(0, 0, drawn.width, drawn.height);
      let [sum, count] = [0, 0];
      for (let i = 0; i < data.length; i += 4) if (data[i + 3] > 200) [sum, count] = [sum + data[i + 1], count + 1];
      return sum / count;
    });
  await page.waitForFunction(() => page$('.chart .value').textContent !== '');
  const [before, picture] = [await lightness(), await canvas.evaluate((drawn) => drawn.toDataURL())];
  await page.emulateMedia({ colorScheme: 'dark' });
  await page.waitForFunction((old) => page$('.chart canvas').toDataURL() !== old, picture);
  assert.ok(Math.abs((await lightness()) - before) > 20, `${await lightness()} and ${before}`);
  const dark = await canvas.evaluate((drawn) => drawn.toDataURL());
  await page.evaluate(() => {
    document.documentElement.dataset.theme = 'light';
    window.dispatchEvent(new Event('synthetica-theme'));
  });
  await page.waitForFunction((old) => page$('.chart canvas').toDataURL() !== old, dark);
  near(await lightness(), before, 8, 'light again');
});

test('on a phone the charts are a tab among the others', async () => {
  const { page, problems } = await browser.openPage(PHONE);
  await page.getByRole('tab', { name: 'Charts' }).tap();
  await chart(page, 'Translation gap').waitFor();
  assert.equal(await page.getByRole('tab', { selected: true }).count(), 1);
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth), 0);
  const over = chart(page, 'Translation gap').locator('.u-over');
  const box = await over.boundingBox();
  await page.touchscreen.tap(box.x + box.width / 2, box.y + 30);
  assert.match(await text(page, 'frame-number'), /^6[456] \//);
  await page.setViewportSize({ width: 1000, height: 844 });
  await unfoldCharts(page);
  await page.locator('#dock').getByRole('tabpanel', { name: 'Charts' }).waitFor();
  assert.ok(await page.locator('#mechanism').isVisible(), 'the tables are back');
  assert.deepEqual(problems, []);
});

test('with forced colours the curves of a chart are still told apart, and the bands of the strip', async () => {
  const { page } = await openCharts({ viewport: { width: 1000, height: 690 } });
  const joints = chart(page, 'chain 1, angles');
  await joints.scrollIntoViewIfNeeded();
  await page.waitForFunction(() => page$('[aria-label="chain 1, angles"] .value').textContent !== '');
  await page.emulateMedia({ forcedColors: 'active' });
  // As a canvas writes them.
  const inks = () =>
    joints.evaluate((section) => {
      const canvas = section.querySelector('canvas');
      const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
      const seen = new Map();
      for (let i = 0; i < data.length; i += 4) {
        if (data[i + 3] < 250) continue;
        const colour = `rgb(${data[i]}, ${data[i + 1]}, ${data[i + 2]})`;
        seen.set(colour, (seen.get(colour) ?? 0) + 1);
      }
      const probe = section.appendChild(document.createElement('i'));
      const system = ['CanvasText', 'LinkText', 'VisitedText'].map((name) => {
        probe.style.color = name;
        return getComputedStyle(probe).color;
      });
      probe.remove();
      return system.map((colour) => seen.get(colour) ?? 0);
    });
  const series = await joints.locator('li').count();
  assert.ok(series >= 3, `${series} curves`);
  for (let tries = 0; tries < 50 && (await inks()).some((count) => count < 20); tries++) await page.evaluate(() => new Promise(requestAnimationFrame));
  assert.ok((await inks()).every((count) => count >= 20), `each curve in a colour of the system: ${await inks()}`);
  const fills = await page.evaluate(() => ['reached', 'closest'].map((name) => getComputedStyle(page$(`#strip .band.${name}`)).fill));
  assert.notEqual(fills[0], fills[1]);
  assert.ok(!fills.includes(await page.evaluate(() => getComputedStyle(document.documentElement).backgroundColor)), 'nor is a band lost in the ground');
});

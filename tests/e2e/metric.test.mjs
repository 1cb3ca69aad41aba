// The metric: its settings, the length in use, both metrics side by side, and the bounds beside the numbers.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { cell, faultBeside, metricBecomes, noFault, number, openBrowser, openSample, otherMetric, scrubTo, text } from './browser.mjs';

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

const comparison = (page) => page.getByRole('group', { name: 'Largest gaps of this motion in either metric' });
const gaps = async (page) => {
  // It comes when its place comes into view.
  await page.locator('.comparison-place').scrollIntoViewIfNeeded();
  await page.waitForFunction(() => page$('.comparison') && !page$('.comparison').matches('.waiting, [aria-busy]'));
  return comparison(page).locator('output').allTextContents();
};
const inUse = (page) => comparison(page).locator('dt', { hasText: 'in use' }).textContent();

async function openMotion() {
  const { page, problems } = await browser.openPage({ viewport: { width: 1280, height: 800 } });
  await page.getByRole('tab', { name: 'Motion', exact: true }).click();
  return { page, problems };
}

test('the metric is chosen, both gaps are shown, and the motion is that of the chosen one', async () => {
  const { page, problems } = await openMotion();
  await scrubTo(page, 60);
  const both = await gaps(page);
  for (const shown of both) assert.match(shown, /^\d[\d.]* m, \d[\d.]*°$/);
  assert.notEqual(both[0], both[1]);
  assert.match(await inUse(page), /^dual quaternion/);
  assert.match(await text(page, 'motion-metric'), /^Metric: dual quaternion about \(0, 0, 0\) m; a shift by 1 m \(as the document says\)/);
  assert.ok(await cell(page, 'planner.metric_origin[0]').isVisible());
  // The info panel names the same two maxima as the comparison, each as a way to its frame.
  const largest = async () => {
    const texts = await page.locator('#motion-summary button').allTextContents();
    return texts.map((shown) => shown.split(', frame '));
  };
  const agree = (inPanel, inComparison) => {
    const [shift, turn] = inComparison.split(', ');
    assert.equal(inPanel[0][0], shift);
    assert.equal(number(inPanel[1][0]).toFixed(1), number(turn).toFixed(1));
  };
  const [shift, turn] = await largest();
  agree([shift, turn], both[1]);
  for (const [i, [value, frame]] of [shift, turn].entries()) {
    await page.locator('#motion-summary button').nth(i).click();
    assert.match(await text(page, 'frame-number'), new RegExp(`^${frame} /`));
    assert.equal(await text(page, ['gap-translation', 'gap-rotation'][i]), value);
  }
  await scrubTo(page, 60);

  const old = await text(page, 'metric');
  await cell(page, 'planner.metric').selectOption('pose');
  await otherMetric(page, old);
  assert.ok(await cell(page, 'planner.metric_origin[0]').isHidden(), 'pose measures about no point of the fixed frame');
  assert.deepEqual(await gaps(page), both, 'the same two motions');
  assert.match(await inUse(page), /^pose/);
  assert.match(await text(page, 'motion-metric'), /^Metric: pose; /);
  agree(await largest(), both[0]);

  // Empty: a length of the mechanism, which the cell and the note beside it say.
  await cell(page, 'planner.metric_length').fill('');
  await cell(page, 'planner.metric_length').blur();
  await page.getByText(/In use: [\d.]+ m, the mechanism’s size\./).waitFor();
  const hint = Number(await cell(page, 'planner.metric_length').getAttribute('placeholder'));
  assert.ok(hint > 1, String(hint));
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  await metricBecomes(page, old);
  assert.deepEqual(problems, []);
});

test('points are typed by their coordinates; a fault stands beside its cell', async () => {
  const { page, problems } = await openMotion();
  await scrubTo(page, 60);
  const old = await text(page, 'metric');
  const origin = (axis) => cell(page, `planner.metric_origin[${axis}]`);
  await origin(0).fill('3');
  await otherMetric(page, old);
  await origin(0).blur();
  assert.deepEqual(await Promise.all([0, 1, 2].map((axis) => origin(axis).inputValue())), ['3', '0', '0']);
  assert.match(await text(page, 'motion-metric'), /about \(3, 0, 0\)/);
  await origin(1).fill('1e30');
  await origin(1).blur();
  assert.match(await faultBeside(page, 'planner.metric_origin[1]'), /length/);
  await origin(2).fill('');
  await origin(2).blur();
  await noFault(page);
  await metricBecomes(page, old);

  await cell(page, 'planner.dimension_tolerance').fill('2');
  await cell(page, 'planner.dimension_tolerance').blur();
  assert.match(await faultBeside(page, 'planner.dimension_tolerance'), /share of the size/);
  await page.keyboard.press('Control+z');
  await noFault(page);

  const reference = (axis) => cell(page, `motion.reference[${axis}]`);
  await reference(0).fill('');
  await reference(0).blur();
  assert.equal(await reference(2).inputValue(), '', 'a point is given whole or not at all');
  assert.ok(Number(await reference(0).getAttribute('placeholder')) > 0.2, 'the mean of the key frames');
  assert.deepEqual(problems, []);
});

test('bounds stand beside the numbers of the frame; a misfit only where there is one', async () => {
  const { page, problems } = await browser.openPage({ viewport: { width: 1280, height: 800 } });
  await page.locator('#certificate summary').click();
  await scrubTo(page, 60);
  for (const name of ['closure', 'gradient']) {
    const bound = (await text(page, `${name}-bound`)).replace('at most ', '');
    assert.ok(number(await text(page, name)) <= number(bound), `${name}: ${await text(page, name)}, at most ${bound}`);
  }
  assert.ok(await page.locator('#misfit-row').isHidden());
  await page.locator('#curvature-bound').filter({ hasText: 'at least −' }).waitFor();
  assert.ok(number(await text(page, 'curvature')) >= number((await text(page, 'curvature-bound')).replace('at least ', '')));
  await openSample(page, 'bennett.json');
  // One of its twists rounded: the constraints that it has too many of contradict each other.
  await cell(page, 'chains[0].joints[1].rows[0].alpha').fill('30.001');
  await page.locator('#misfit-row').waitFor();
  assert.ok(number(await text(page, 'misfit')) <= number((await text(page, 'misfit-bound')).replace('at most ', '')));
  assert.deepEqual(problems, []);
});

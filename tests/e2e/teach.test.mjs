// Joints driven by hand: the others follow with closed loops, and what stops them is said.
import assert from 'node:assert/strict';
import { after, afterEach, before, beforeEach, test } from 'node:test';
import { number, openBrowser, openSample, scrubTo, text } from './browser.mjs';

let browser;
let page;
let problems;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());
beforeEach(async () => {
  ({ page, problems } = await browser.openPage());
  await scrubTo(page, 60);
  await page.getByRole('tab', { name: 'Teach' }).click();
  await page.locator('.teach-row').first().waitFor();
});
afterEach(() => assert.deepEqual(problems, []));

const row = (index) => page.locator(`.teach-row[data-variable="${index}"]`);
const slider = (index) => row(index).locator('input[type=range]');
const field = (index) => row(index).locator('input[type=text]');
const values = () => page.locator('.teach-row input[type=text]').evaluateAll((fields) => fields.map((f) => Number(f.value)));
const moved = (old) => page.waitForFunction((before) => [...page$$('.teach-row input[type=text]')].some((f, i) => Number(f.value) !== before[i]), old);

test('every joint variable has a slider and a number, named with its unit', async () => {
  assert.equal(await page.locator('.teach-row').count(), 15);
  await page.getByRole('slider', { name: 'chain 2, d₂ in m' }).waitFor();
  await page.getByRole('slider', { name: 'chain 1, θ₁ in degrees' }).waitFor();
  const before = await values();
  await scrubTo(page, 100);
  await moved(before);
});

test('a slider drives its joint; the others follow, every loop stays closed', async () => {
  const before = await values();
  const wanted = before[1] + 0.1;
  await slider(1).evaluate((input, value) => {
    input.value = value;
    input.dispatchEvent(new Event('input', { bubbles: true }));
  }, wanted);
  await moved(before);
  const after = await values();
  assert.ok(Math.abs(after[1] - wanted) < 2e-3, 'the driven joint is where the slider is');
  assert.ok(after.filter((value, i) => value !== before[i]).length > 5, 'the others follow');
  assert.equal(await text(page, 'frame-word'), 'Driven');
  assert.ok(number(await text(page, 'closure')) <= 1e-10);
  // A joint that is driven has no goal: nothing is said of one, of a gap, or of what holds the workpiece back.
  await page.waitForFunction(() => /driven/.test(page$('#live').textContent) && page$('#why-title')?.textContent === 'What is free here' && !page$('#why').matches('.waiting, .unsaid, [hidden]'));
  const said = await page.evaluate(() => {
    const parts = ['#info > section:first-child', '#certificate', '#why', '#live', '#canvas-text', '#by-hand'].map((id) => page$(id).cloneNode(true));
    for (const part of parts) for (const gone of part.querySelectorAll('[hidden]')) gone.remove();
    return [...parts.map((part) => part.textContent), page$('#scrub').getAttribute('aria-valuetext')].join(' ');
  });
  assert.match(said, /Driven/);
  assert.doesNotMatch(said, /goal|gap|metric|gradient|holds|closer|certified/i);
  await page.getByRole('tab', { name: 'Algorithm' }).click();
  const note = page.getByRole('tabpanel', { name: 'Algorithm' });
  await note.getByRole('button', { name: 'Go back to the motion' }).waitFor();
  assert.doesNotMatch(await note.locator('p').first().textContent(), /goal|gap/i);
  await page.getByRole('tabpanel', { name: 'Teach' }).getByRole('button', { name: 'Back to the motion' }).click();
  await page.waitForFunction((d) => Number(page$('.teach-row[data-variable="1"] input[type=text]').value) === d, before[1]);
  assert.notEqual(await text(page, 'frame-word'), 'Driven');
});

test('by keyboard: an arrow moves the slider, a number is driven to', async () => {
  const before = await values();
  await slider(1).focus();
  await page.keyboard.press('ArrowRight');
  await moved(before);
  await field(1).fill('1.2');
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => page$('.teach-row[data-variable="1"] input[type=range]').getAttribute('aria-valuetext') === '1.2 m');
});

test('where the linkage cannot follow it says why, and goes as far as it can', async () => {
  await openSample(page, 'four-bar.json');
  await page.waitForFunction(() => page$$('.teach-row').length === 4);
  // The rocker cannot turn round.
  const rocker = 2;
  const [old] = [await field(rocker).inputValue()];
  await field(rocker).fill(String(Number(old) + 170));
  await page.keyboard.press('Enter');
  const note = row(rocker).getByRole('status');
  await note.filter({ hasText: /loops cannot close with θ₁ of rocker above/ }).waitFor();
  const reached = Number(await field(rocker).inputValue());
  assert.ok(reached > Number(old) && reached < Number(old) + 170);
  assert.ok(number(await text(page, 'closure')) <= 1e-10);
  // From there it comes back.
  await field(rocker).fill(old);
  await page.keyboard.press('Enter');
  await note.waitFor({ state: 'hidden' });
  assert.equal(await field(rocker).inputValue(), old);
});

test('a number beyond a limit, or none, is refused in words; nothing moves', async () => {
  await openSample(page, 'scara.json');
  await page.waitForFunction(() => page$$('.teach-row').length === 4);
  const before = await values();
  for (const bad of ['9999', 'abc']) {
    await field(0).fill(bad);
    await page.keyboard.press('Enter');
    await row(0).getByRole('status').filter({ hasText: /takes a number.*degrees/ }).waitFor();
    assert.equal(await field(0).getAttribute('aria-invalid'), 'true');
    assert.equal(await field(0).inputValue(), bad, 'kept as typed');
    await page.keyboard.press('Escape');
    assert.deepEqual(await values(), before);
  }
});

test('a posture becomes the start or a key frame, and undo takes it back', async () => {
  await field(1).fill('1.25');
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => page$('#frame-word').textContent === 'Driven');
  const panel = page.getByRole('tabpanel', { name: 'Teach' });
  await panel.getByRole('button', { name: 'Add key frame here' }).click();
  await page.getByRole('tab', { name: 'Motion', exact: true }).click();
  await page.locator('[data-path="motion.key_frames[3].x"]').waitFor();
  await page.keyboard.press('Control+z');
  await page.locator('[data-path="motion.key_frames[3].x"]').waitFor({ state: 'detached' });

  await page.getByRole('tab', { name: 'Teach' }).click();
  await field(1).fill('1.25');
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => page$('#frame-word').textContent === 'Driven');
  await panel.getByRole('button', { name: 'Use as start' }).click();
  await page.getByRole('tab', { name: 'Mechanism' }).click();
  const start = page.locator('[data-path="chains[0].start[1]"]');
  await page.waitForFunction(() => Number(page$('[data-path="chains[0].start[1]"]').value) === 1.25);
  await page.keyboard.press('Control+z');
  await page.waitForFunction(() => Number(page$('[data-path="chains[0].start[1]"]').value) !== 1.25);
  assert.notEqual(await start.inputValue(), '1.25');
});

test('a field keeps its node, the focus and what is being typed when the motion is planned anew', async () => {
  await field(1).focus();
  await page.keyboard.type('1.3');
  const low = await slider(1).getAttribute('min');
  await page.evaluate(() => {
    window.before = pageFocus();
    const { store } = document.querySelector('synthetica-linkage').parts;
    window.motion = store.result.motion;
    // Another range of every slider, and a frame more to be shown.
    store.setView({ frame: 61 });
    store.setResult({ motion: { ...store.result.motion, joints: store.result.motion.joints.map((value) => 1.1 * value) } });
  });
  assert.notEqual(await slider(1).getAttribute('min'), low, 'the panel has followed');
  assert.ok(await page.evaluate(() => pageFocus() === window.before && window.before.isConnected));
  assert.equal(await field(1).inputValue(), '1.3');
  await page.keyboard.press('Escape');
  assert.notEqual(await field(1).inputValue(), '1.3');
});

test('on a phone the panel fits', async () => {
  await page.setViewportSize({ width: 390, height: 844 });
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth), 0);
});

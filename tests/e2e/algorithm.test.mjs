// The planner's own iterations at one frame: steps, the matrix [A], convergence, the linkage that steps along.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { cell, number, openBrowser, scrubTo, text } from './browser.mjs';

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

const panel = (page) => page.getByRole('tabpanel', { name: 'Algorithm' });

async function openAlgorithm(frame, options) {
  const { page, problems } = await browser.openPage(options);
  await scrubTo(page, frame);
  await page.getByRole('tab', { name: 'Algorithm' }).click();
  await panel(page).locator('.matrix rect').first().waitFor();
  await panel(page).getByText(`Frame ${frame + 1} of`).waitFor();
  return { page, problems };
}

/** A number of the table of the iterate, by its name. */
const value = async (page, name) => number(await panel(page).locator('dl div').filter({ hasText: name }).locator('output').textContent());
const heading = (page) => panel(page).getByRole('region', { name: 'Iteration' }).locator('h2');
const press = (page, name) => panel(page).getByRole('button', { name }).click();

test('the gradient steps from the answer before to the minimum, in words, equations and numbers', async () => {
  const { page, problems } = await openAlgorithm(60);
  await heading(page).filter({ hasText: 'The start: the answer of frame 60.' }).waitFor();
  const start = [await value(page, 'f = '), await value(page, 'f − f*')];
  assert.ok(start[1] > 0);
  const words = await panel(page).locator('.flow').textContent();
  for (const equation of ['[A] Δr = E (21–25)', '(g − q) (31)', '[A]⁺E (28)']) assert.ok(words.includes(equation), equation);
  await press(page, 'Next iterate');
  await heading(page).filter({ hasText: /^Iterate 1 of \d+/ }).waitFor();
  assert.ok((await value(page, 'f − f*')) < start[1], 'f falls');
  await press(page, 'Last iterate');
  await panel(page).getByText('No direction comes nearer any more: stop.').waitFor();
  assert.ok((await value(page, 'f − f*')) < 1e-8);
  assert.ok((await value(page, '‖a‖')) <= 1e-7);
  assert.ok((await value(page, 'Closure')) < 1e-10);
  await press(page, 'Previous iterate');
  await press(page, 'First iterate');
  assert.equal(await value(page, 'f = '), start[0]);
  assert.ok(await panel(page).getByRole('button', { name: 'First iterate' }).isDisabled());
  assert.deepEqual(problems, []);
});

test('Newton takes few steps and ends lower or alike; a sentence says why', async () => {
  const { page } = await openAlgorithm(60);
  await press(page, 'Last iterate');
  const gradient = await value(page, 'f − f*');
  await panel(page).getByRole('radio', { name: /Newton/ }).check();
  await heading(page).filter({ hasText: 'The start' }).waitFor();
  await press(page, 'Last iterate');
  await panel(page).getByText('a certified minimum').waitFor();
  assert.ok((await value(page, 'f − f*')) <= gradient);
  const [, newton, many] = /took (\d+) steps?, the gradient (\d+) steps/.exec(await panel(page).locator('.why-few').textContent());
  assert.ok(Number(newton) < 10 && Number(many) > 20 * Number(newton), `${newton} against ${many}`);
});

test('the slider goes by keyboard; steps play and stop', async () => {
  const { page } = await openAlgorithm(60);
  const slider = panel(page).getByRole('slider', { name: 'Iterate' });
  await slider.focus();
  await page.keyboard.press('ArrowRight');
  await heading(page).filter({ hasText: 'Iterate 1 of' }).waitFor();
  assert.match(await slider.getAttribute('aria-valuetext'), /iterate 1 of \d+/);
  await page.keyboard.press('Home');
  await heading(page).filter({ hasText: 'The start' }).waitFor();
  await press(page, 'Play steps');
  // It goes on while one looks: an iterate may have passed before it is seen.
  await page.waitForFunction(() => Number(page$('.steps input[type=range]').value) >= 3);
  await press(page, 'Stop');
  await panel(page).getByRole('button', { name: 'Play steps' }).waitFor();
});

test('the linkage in the view is the iterate once one is chosen, not before, and the frame comes back on leaving', async () => {
  const { page } = await openAlgorithm(60, { viewport: { width: 1120, height: 700 } });
  const byHand = page.locator('#by-hand-text');
  assert.ok(await byHand.isHidden(), 'opening the panel leaves the pose as it was');
  assert.equal(await text(page, 'frame-title'), 'This frame', 'and the certificate');
  await press(page, 'Next iterate');
  await byHand.filter({ hasText: /Iterate 1 of \d+, gradient/ }).waitFor();
  assert.equal(await text(page, 'frame-title'), 'This posture');
  await page.getByRole('tab', { name: 'Charts' }).click();
  await byHand.waitFor({ state: 'hidden' });
  await page.getByRole('tab', { name: 'Algorithm' }).click();
  await heading(page).filter({ hasText: 'Iterate 1 of' }).waitFor();
  assert.ok(await byHand.isHidden(), 'nor does coming back');
});

test('one number is called projected gradient, in the panel and in the certificate', async () => {
  const { page } = await openAlgorithm(60, { viewport: { width: 1120, height: 700 } });
  assert.equal(await panel(page).locator('dt', { hasText: /projected gradient/i }).count(), 0, 'the gradient’s ‖a‖ is another measure');
  await panel(page).getByRole('radio', { name: /Newton/ }).check();
  const slider = panel(page).getByRole('slider', { name: 'Iterate' });
  await slider.focus();
  for (const key of ['End', 'Home']) {
    await page.keyboard.press(key);
    // The start is closed and not at a minimum: a number that says something.
    await page.waitForFunction(([at]) => page$('.steps input[type=range]').value === at, [key === 'Home' ? '0' : await slider.getAttribute('max')]);
  }
  await page.waitForFunction(() => {
    const own = [...page$$('.algorithm dl div')].find((row) => row.querySelector('dt').textContent === 'Projected gradient');
    return Number(own.querySelector('output').textContent.replaceAll('−', '-')) > 1e-3 && own.querySelector('output').textContent === page$('#gradient').textContent;
  });
});

test('the keyboard keeps its place when the iterates end', async () => {
  const { page } = await openAlgorithm(60);
  const last = panel(page).getByRole('button', { name: 'Last iterate' });
  await last.focus();
  await page.keyboard.press('Enter');
  await panel(page).getByText('No direction comes nearer any more: stop.').waitFor();
  assert.equal(await page.evaluate(() => pageFocus().getAttribute('aria-label')), 'Last iterate');
});

test('[A] has its blocks, its singular values and its rank in words and as a table', async () => {
  const { page } = await openAlgorithm(60);
  const matrix = panel(page).getByRole('region', { name: 'Matrix [A]' });
  await matrix.getByText('20 equations in 23 unknowns, rank 20: the null space has 23 − 20 = 3 directions.').waitFor();
  assert.equal(await matrix.locator('.sigmas .sigma').count(), 20);
  assert.equal(await matrix.locator('.sigmas .threshold').count(), 1);
  for (const label of ['θ₁', 'θ₃', 'q', 'chain 1', '|q| = 1']) assert.ok((await matrix.locator('text').allTextContents()).includes(label), label);
  // Chain 1's joints move the rows of chain 1 only: nothing of its colour stands beside or below its block.
  const boxes = await matrix.locator('.chain-0').evaluateAll((all) => all.map((cell) => [Number(cell.getAttribute('x')), Number(cell.getAttribute('y'))]));
  const other = await matrix.locator('.chain-1').evaluateAll((all) => all.map((cell) => [Number(cell.getAttribute('x')), Number(cell.getAttribute('y'))]));
  assert.ok(boxes.length > 10 && Math.max(...boxes.map(([x]) => x)) < Math.min(...other.map(([x]) => x)));
  assert.ok(Math.max(...boxes.map(([, y]) => y)) < Math.min(...other.map(([, y]) => y)));
  await matrix.locator('summary').click();
  await matrix.locator('table').first().waitFor();
  assert.equal(await matrix.locator('table').first().locator('tbody tr').count(), 20);
  assert.equal(await matrix.locator('table').first().locator('tbody tr').first().locator('td').count(), 23);
});

test('both curves have a table; a click on a curve chooses the iterate', async () => {
  const { page } = await openAlgorithm(60);
  const convergence = panel(page).getByRole('region', { name: 'Convergence', exact: true });
  for (const summary of await convergence.locator('summary').all()) await summary.click();
  const columns = await convergence.locator('table').evaluateAll((all) => all.map((table) => [...table.querySelectorAll('tbody tr')].map((row) => row.cells[2].textContent)));
  for (const column of columns) assert.ok(number(column.at(-1)) < number(column[0]), 'the projected gradient falls');
  await convergence.locator('.uplot').nth(1).scrollIntoViewIfNeeded();
  const plot = await convergence.locator('.u-over').nth(1).boundingBox();
  await page.mouse.click(plot.x + plot.width - 2, plot.y + 20);
  await heading(page).filter({ hasText: /^Iterate (\d+) of \1\./ }).waitFor();
  assert.ok(await panel(page).getByRole('radio', { name: /Newton/ }).isChecked());
});

test('another frame or document has its own iterations; while the motion plays there are none', async () => {
  const { page, problems } = await openAlgorithm(60);
  await scrubTo(page, 90);
  await panel(page).getByText('Frame 91 of').waitFor();
  await page.locator('#play').click();
  await panel(page).getByText('to look into the iterations of one frame').waitFor();
  await panel(page).getByRole('button', { name: 'Pause' }).click();
  await heading(page).waitFor();
  assert.equal(await page.locator('#play').getAttribute('aria-label'), 'Play');
  await page.waitForFunction(() => pageFocus().getAttribute('aria-label') === 'Iterate', undefined, { timeout: 5000 });
  await cell(page, 'chains[0].joints[1].rows[0].alpha').fill('80');
  await panel(page).locator('.matrix rect').first().waitFor();
  assert.deepEqual(problems, []);
});

test('on a phone nothing sticks out', async () => {
  const { page } = await browser.openPage({ viewport: { width: 390, height: 844 }, isMobile: true, hasTouch: true });
  await page.getByRole('tab', { name: 'Algorithm' }).tap();
  await panel(page).locator('.matrix rect').first().waitFor();
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth), 0);
});

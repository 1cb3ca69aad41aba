// Why the workpiece does not come closer: certificate, shares of the chains, gap and freedoms in words.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { cell, openBrowser, scrubTo } from './browser.mjs';

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

/** The info panel stands beside the view. */
const WIDE = { viewport: { width: 1280, height: 700 } };
const why = (page) => page.getByRole('region', { name: 'Why not closer' });
const percent = (shown) => Number(/(\d+) %/.exec(shown)[1]);

async function openAt(frame) {
  const { page, problems } = await browser.openPage(WIDE);
  await scrubTo(page, frame);
  await why(page).locator('.shares li').first().waitFor();
  return { page, problems };
}

test('a frame with a gap: certified, the shares sum to 100 %, the chain that holds most is named', async () => {
  const { page, problems } = await openAt(60);
  await why(page).getByText('Certified closest: no small motion of the linkage comes nearer').waitFor();
  const shares = (await why(page).locator('.shares strong').allTextContents()).map(percent);
  assert.equal(shares.length, 3);
  assert.equal(shares.reduce((sum, share) => sum + share), 100);
  const sentence = await why(page).locator('.why-sentence').textContent();
  assert.match(sentence, /chain \d/i);
  assert.equal(percent(sentence), Math.max(...shares));
  assert.match(sentence, /it allows no (shift|turn|motion)/);
  assert.match(await why(page).locator('.shares small').first().textContent(), /withstands a (force|moment)/);
  await why(page).getByText('What is left of the gap').click();
  assert.match(await why(page).locator('.why-gap dd').first().textContent(), /a shift of [\d.]+ m along \(.*\) and a turn of [\d.]+° about \(.*\)/);
  await why(page).getByText('Freedoms here: 3').click();
  assert.equal(await why(page).locator('.why-freedoms li').count(), 3);
  assert.deepEqual(problems, []);
});

test('pointing at a chain there highlights it, by pointer and keyboard; a click selects it', async () => {
  const { page } = await openAt(60);
  const second = why(page).locator('.shares li').nth(1);
  await second.locator('button').hover();
  await why(page).locator('.shares li.pointed').waitFor();
  assert.ok(await second.evaluate((item) => item.classList.contains('pointed')));
  await page.mouse.move(5, 5);
  await why(page).locator('.shares li.pointed').waitFor({ state: 'detached' });
  await second.locator('button').focus();
  await why(page).locator('.shares li.pointed').waitFor();
  await page.keyboard.press('Enter');
  await why(page).locator('.shares button[aria-pressed="true"]').waitFor();
  assert.equal(await second.locator('button').getAttribute('aria-pressed'), 'true');
  await page.keyboard.press('Enter');
  await why(page).locator('.shares button[aria-pressed="true"]').waitFor({ state: 'detached' });
});

test('a goal that is met is held back by nothing', async () => {
  const { page } = await openAt(60);
  await scrubTo(page, 0);
  await why(page).getByText('The goal is met; nothing holds it back.').waitFor();
  assert.ok(await why(page).locator('.shares').isHidden());
});

test('at a limit the joint and its chain are named', async () => {
  const { page } = await openAt(60);
  await page.locator('#mechanism summary', { hasText: 'limits' }).first().click();
  await cell(page, 'chains[0].joints[1].limits[0].max').fill('1.3');
  await page.waitForFunction(() => /limit/i.test(page$('#motion-summary').textContent));
  const frame = await page.evaluate(() => Number(page$('#scrub').max));
  for (let at = 0; at <= frame && !(await page.locator('#frame-status[data-status="at_limit"]').count()); at += 4) await scrubTo(page, at);
  await why(page).getByText(/of chain 1 is at its largest value, 1.3 m/).waitFor();
});

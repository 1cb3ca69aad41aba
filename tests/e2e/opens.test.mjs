// The page opens on a moving linkage, plays it, and shows closed loops only.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { number, openBrowser, openSample, scrubTo, text } from './browser.mjs';

const samples = JSON.parse(readFileSync(new URL('../../www/mechanisms/index.json', import.meta.url), 'utf8'));

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

/** What every frame of the shown motion says of itself. */
const eachFrame = (page) =>
  page.evaluate(() => {
    const scrub = page$('#scrub');
    const frames = [];
    for (let frame = 0; frame <= Number(scrub.max); frame++) {
      scrub.value = String(frame);
      scrub.dispatchEvent(new Event('input'));
      const shown = (id) => page$(`#${id}`).textContent;
      frames.push({ number: shown('frame-number'), closure: shown('closure'), status: shown('frame-word') });
    }
    return frames;
  });

test('opens by itself, without a complaint or a word to another host, and moves', async () => {
  const { page, problems } = await browser.openPage({ reducedMotion: 'no-preference' });
  const canvas = page.locator('#canvas');
  const first = await canvas.screenshot();
  const from = await page.inputValue('#scrub');
  await page.waitForFunction((frame) => page$('#scrub').value !== frame, from);
  await page.getByRole('button', { name: 'Pause' }).click();
  await scrubTo(page, 60);
  assert.notDeepEqual(await canvas.screenshot(), first, 'the picture has changed');
  assert.deepEqual(problems, []);
});

test('keeps a strict content policy: no script but its own files, no eval', async () => {
  const { page, problems } = await browser.openPage();
  const policy = await page.locator('meta[http-equiv="Content-Security-Policy"]').getAttribute('content');
  const rules = Object.fromEntries(policy.split(';').map((rule) => rule.trim().split(/ (.*)/s)));
  assert.equal(rules['script-src'], "'self' 'wasm-unsafe-eval'");
  assert.equal(rules['default-src'], "'self'");
  assert.deepEqual(problems, [], 'nothing of the page breaks it');
  // The browser enforces it.
  const broken = await page.evaluate(
    () =>
      new Promise((resolve) => {
        document.addEventListener('securitypolicyviolation', (event) => resolve(event.effectiveDirective));
        const script = document.createElement('script');
        script.textContent = 'window.ran = true';
        document.body.append(script);
      }),
  );
  assert.match(broken, /^script-src/);
  assert.equal(await page.evaluate(() => window.ran), undefined);
});

test('every sample: every frame is closed, and its numbers are shown', async () => {
  const { page, problems } = await browser.openPage();
  assert.ok(samples.length >= 8);
  for (const { file: sample, mobility } of samples) {
    await openSample(page, sample);
    await page.waitForFunction((rank) => page$('#mobility-rank').textContent === rank, String(mobility));
    const frames = await eachFrame(page);
    assert.ok(frames.length >= 2, sample);
    frames.forEach((frame, index) => {
      assert.ok(frame.number.startsWith(`${index + 1} /`), `${sample}: ${frame.number}`);
      assert.ok(number(frame.closure) <= 1e-10, `${sample}, frame ${frame.number}: ${frame.closure}`);
      assert.notEqual(frame.status, 'Closure lost', `${sample}, frame ${frame.number}`);
    });
  }
  assert.deepEqual(problems, []);
});

test('mobility is told by count, by n − m and by rank, and a difference is put into words', async () => {
  const { page } = await browser.openPage();
  const told = () => Promise.all(['mobility-count', 'mobility-difference', 'mobility-rank'].map((id) => text(page, id)));
  assert.deepEqual(await told(), ['3', '23 − 20 = 3', '3']);
  assert.match(await text(page, 'mobility-sentence'), /as the count says/);
  await openSample(page, 'four-bar.json');
  await page.waitForFunction(() => page$('#mobility-rank').textContent === '1');
  assert.deepEqual(await told(), ['−2', '12 − 14 = −2', '1']);
  assert.match(await text(page, 'mobility-sentence'), /repeat each other/);
});

test('steps, scrubs and plays from the keyboard', async () => {
  const { page } = await browser.openPage();
  await page.getByRole('button', { name: 'One frame on' }).click();
  assert.match(await text(page, 'frame-number'), /^2 \//);
  await page.locator('#scrub').focus();
  await page.keyboard.press('ArrowRight');
  assert.match(await text(page, 'frame-number'), /^3 \//);
  await page.keyboard.press('End');
  const [at, of] = (await text(page, 'frame-number')).split(' / ');
  assert.equal(at, of);
  await page.keyboard.press('Space');
  await page.getByRole('button', { name: 'Pause' }).waitFor();
  await page.waitForFunction((end) => page$('#scrub').value !== end, String(Number(of) - 1));
  await page.keyboard.press('Space');
  await page.getByRole('button', { name: 'Play' }).waitFor();
});

test('turns, zooms and fits the view from the keyboard', async () => {
  const { page } = await browser.openPage();
  const canvas = page.locator('#canvas');
  const pictures = [await canvas.screenshot()];
  await canvas.focus();
  for (const key of ['ArrowLeft', '+', 'Shift+ArrowUp']) {
    await page.keyboard.press(key);
    await page.evaluate(() => new Promise((drawn) => requestAnimationFrame(() => requestAnimationFrame(drawn))));
    pictures.push(await canvas.screenshot());
    assert.notDeepEqual(pictures.at(-1), pictures.at(-2), key);
  }
});

test('a lost graphics context is told, and the view comes back with it', async () => {
  const { page } = await browser.openPage();
  const loss = await page.evaluateHandle(() => page$('.drawn').getContext('webgl2').getExtension('WEBGL_lose_context'));
  await loss.evaluate((extension) => extension.loseContext());
  await page.locator('#view-note').filter({ hasText: 'interrupted' }).waitFor();
  await loss.evaluate((extension) => extension.restoreContext());
  await page.locator('#view-note').waitFor({ state: 'hidden' });
  const before = await page.locator('#canvas').screenshot();
  await scrubTo(page, 60);
  await page.evaluate(() => new Promise((drawn) => requestAnimationFrame(() => requestAnimationFrame(drawn))));
  assert.notDeepEqual(await page.locator('#canvas').screenshot(), before, 'the view is drawn again');
});

test('says so when the planner cannot be loaded', async () => {
  const { page } = await browser.blankPage();
  await page.route(/\.wasm$|worker/, (route) => route.abort());
  await page.goto(browser.address);
  await page.locator('#trouble').filter({ hasText: /planner (could not be loaded|failed)/ }).waitFor();
});

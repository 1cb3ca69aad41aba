// A plan that takes long: how far it is, Stop, what there is so far, and on from there.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { violations } from './axe.mjs';
import { cell, metricBecomes, openBrowser, otherMetric, scrubTo, text } from './browser.mjs';

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

const FRAMES = 10_000;
const sample = JSON.parse(readFileSync(new URL('../../www/mechanisms/3rps.json', import.meta.url), 'utf8'));
/** The paper's own method takes a minute and more for this. */
const long = JSON.stringify({ ...sample, motion: { ...sample.motion, frames: FRAMES }, planner: { ...sample.planner, method: 'gradient' } });

const openLong = (page) => page.locator('#file').setInputFiles({ name: 'long.json', mimeType: 'application/json', buffer: Buffer.from(long) });
const says = (page, pattern) => page.locator('#planning-text').filter({ hasText: pattern }).waitFor();
const frames = (page) => page.evaluate(() => window.document.querySelector('synthetica-linkage').trajectory.frames);
/** Where a line stands in what holds it, from 0 to 1. */
const share = (line) =>
  line.evaluate((node) => {
    const [at, within] = [node.getBoundingClientRect(), node.parentElement.getBoundingClientRect()];
    return (at.left + at.width / 2 - within.left) / within.width;
  });
const PLACE = 'chains[0].base.x';
/** Edits a number and waits for its motion. */
async function edited(page, value) {
  await cell(page, PLACE).fill(value);
  await page.keyboard.press('Enter');
  await page.waitForFunction((wanted) => {
    const { result, doc } = window.document.querySelector('synthetica-linkage').parts.store;
    return doc.chains[0].base.x === Number(wanted) && result.doc === doc;
  }, value);
}
const frameOf = (sentence) => Number(sentence.match(/frame (\d+) of 10000/)[1]);

test('a long plan says how far it is; Stop, by the keyboard, shows what there is so far, and it goes on from there', async () => {
  const { page, problems } = await browser.openPage();
  assert.equal(await page.locator('#planning').isVisible(), false, 'a short plan says nothing');
  await openLong(page);
  await says(page, /^Planning frame \d+ of 10000\.$/);
  const first = frameOf(await text(page, 'planning-text'));
  await page.waitForFunction((old) => Number(page$('#planning-text').textContent.match(/\d+/)[0]) > old, first);
  assert.match(await text(page, 'live'), /^Planning frame \d+ of 10000\. Stop shows/);
  assert.equal(await page.locator('#live').getAttribute('aria-live'), 'polite');
  assert.equal(await frames(page), 129, 'the last good motion is still there');
  assert.deepEqual(await violations(page), []);

  const stop = page.getByRole('button', { name: 'Stop', exact: true });
  await stop.focus();
  await page.keyboard.press('Enter');
  await says(page, /^Planned to frame \d+ of 10000: the rest is not planned\.$/);
  const planned = await frames(page);
  assert.equal(frameOf(await text(page, 'planning-text')), planned);
  assert.ok(planned > first && planned < FRAMES, `${planned}`);
  assert.match(await page.locator('#strip').getAttribute('aria-label'), /the rest is not planned/);
  assert.ok((await page.locator('#strip .unplanned').count()) === 1);
  assert.match(await text(page, 'motion-summary'), /the rest is not planned/);
  assert.equal(await page.locator('#scrub').getAttribute('max'), String(planned - 1));
  assert.equal(await page.evaluate(() => pageFocus().id), 'planning-on', 'the focus stays');
  assert.deepEqual(await violations(page), []);

  // Clock, strip and charts go over the same frames: all of the goal motion.
  await scrubTo(page, planned - 1);
  assert.equal(await text(page, 'frame-number'), `${planned} / ${FRAMES}`);
  await page.getByRole('tab', { name: 'Charts' }).click();
  const chart = page.getByRole('region', { name: 'Translation gap', exact: true });
  await chart.locator('.playhead').waitFor();
  const wanted = (planned - 1) / (FRAMES - 1);
  assert.ok(Math.abs((await share(chart.locator('.playhead'))) - wanted) < 0.02, 'in the chart');
  assert.ok(Math.abs((await share(page.locator('#strip-playhead'))) - wanted) < 0.02, 'on the strip');

  await page.locator('#planning-on').focus();
  await page.keyboard.press('Enter');
  await says(page, /^Planning frame/);
  assert.ok(frameOf(await text(page, 'planning-text')) > planned);
  assert.equal(await page.evaluate(() => pageFocus().id), 'planning-stop');
  assert.deepEqual(problems, []);
});

test('while a plan goes on the page answers: another frame is explained, and an edit takes the plan’s place', async () => {
  const { page, problems } = await browser.openPage();
  await openLong(page);
  await says(page, /^Planning frame/);
  const metric = await text(page, 'metric');
  await scrubTo(page, 20);
  await otherMetric(page, metric);
  await page.keyboard.press('Control+z');
  await page.locator('#planning').waitFor({ state: 'hidden' });
  await page.waitForFunction(() => window.document.querySelector('synthetica-linkage').document.motion.frames === 129);
  assert.equal(await frames(page), 129);
  await scrubTo(page, 0);
  await metricBecomes(page, metric);
  assert.deepEqual(problems, []);
});

test('of two linkages one is planned while the other takes long', async () => {
  const { page, problems } = await browser.blankPage();
  const body = '<!doctype html><script type="module" src="./element.js"></script><synthetica-linkage></synthetica-linkage><synthetica-linkage></synthetica-linkage>';
  await page.route(`${browser.address}two.html`, (route) => route.fulfill({ contentType: 'text/html', body }));
  await page.goto(`${browser.address}two.html`);
  const answer = await page.evaluate(
    async ([slow, quick]) => {
      const [one, two] = document.querySelectorAll('synthetica-linkage');
      await customElements.whenDefined('synthetica-linkage');
      one.document = slow;
      const ready = new Promise((resolve) => two.addEventListener('ready', resolve, { once: true }));
      two.document = quick;
      await ready;
      return [one.trajectory, two.trajectory.frames];
    },
    [long, JSON.stringify(sample)],
  );
  assert.deepEqual(answer, [null, 129]);
  assert.deepEqual(problems, []);
});

test('a linkage that is taken out is planned no more, and is when it is put back', async () => {
  const { page, problems } = await browser.blankPage();
  const body = '<!doctype html><script type="module" src="./element.js"></script><synthetica-linkage></synthetica-linkage>';
  await page.route(`${browser.address}one.html`, (route) => route.fulfill({ contentType: 'text/html', body }));
  await page.goto(`${browser.address}one.html`, { waitUntil: 'commit' });
  await page.evaluate(async (slow) => {
    await customElements.whenDefined('synthetica-linkage');
    window.element = document.querySelector('synthetica-linkage');
    const { store } = element.parts;
    window.progress = () => new Promise((resolve) => {
      const leave = store.subscribe('planning', () => {
        if (!store.planning) return;
        leave();
        resolve(store.planning.done);
      });
    });
    element.document = slow;
    await progress();
    element.remove();
  }, long);
  await page.waitForFunction(() => element.parts.store.planning === null);
  // The worker is free for others, and says nothing more of the plan.
  const more = page.evaluate(() => progress().then(() => 'progress'));
  const other = page.evaluate((text) => {
    const element = document.body.appendChild(document.createElement('synthetica-linkage'));
    element.document = text;
    return new Promise((resolve) => element.addEventListener('ready', () => resolve('ready')));
  }, JSON.stringify(sample));
  assert.equal(await Promise.race([more, other]), 'ready');
  await page.evaluate(() => document.body.append(element));
  assert.equal(await more, 'progress');
  assert.equal(page.workers().length, 1);
  assert.deepEqual(problems, []);
});

for (const [how, script] of [['where there are locks at once', ''], ['without locks by the next question', "Object.defineProperty(navigator, 'locks', { value: undefined });\n"]]) {
  test(`a worker that was ended from outside is noticed, ${how}: the next edit is planned`, async () => {
    const { page, problems } = await browser.blankPage({ serviceWorkers: 'block' });
    await page.context().route(/assets\/worker-.*\.js/, async (route) => {
      const answer = await route.fetch();
      await route.fulfill({ response: answer, body: script + (await answer.text()) });
    });
    await page.goto(browser.address);
    await page.waitForFunction(() => (page$('#closure')?.textContent ?? '–') !== '–');
    await page.evaluate(() => {
      window.locks = async () => {
        const { held, pending } = await navigator.locks.query();
        return [...held.map(({ name }) => [name, 'held']), ...pending.map(({ name }) => [name, 'pending'])].filter(([name]) => name.startsWith('synthetica-planner')).map(([, how]) => how);
      };
    });
    if (!script) await page.waitForFunction(async () => (await locks()).join() === 'held,pending');
    const [worker] = page.workers();
    const closed = new Promise((resolve) => worker.once('close', resolve));
    await worker.evaluate(() => self.close()).catch(() => {});
    await closed;
    // Its lock is given to the page, which lets it go.
    if (!script) await page.waitForFunction(async () => !(await locks()).length);
    await edited(page, '0.1');
    if (!script) await page.waitForFunction(async () => (await locks()).join() === 'held,pending');

    // The planner's file is not there for a while: that is said, and not kept.
    if (!script) {
      let isThere = false;
      await page.context().route('**/*.wasm', (route) => (isThere ? route.continue() : route.fulfill({ status: 503, body: '' })));
      await page.workers()[0].evaluate(() => self.close()).catch(() => {});
      await cell(page, PLACE).fill('0.2');
      await page.keyboard.press('Enter');
      await page.waitForFunction(() => window.document.querySelector('synthetica-linkage').error !== null);
      isThere = true;
      await edited(page, '0.3');
      assert.equal(await page.evaluate(() => window.document.querySelector('synthetica-linkage').error), null);
    }
    // The browser's own words.
    assert.deepEqual(problems.filter((text) => !/503|Service Worker/.test(text)), []);
  });
}

test('a slow network makes the first motion late, and breaks nothing', async () => {
  const { page, problems } = await browser.blankPage();
  // Longer than a question that hangs is waited for.
  await page.context().route('**/*.wasm', async (route) => {
    await new Promise((resolve) => setTimeout(resolve, 6000));
    await route.continue();
  });
  let loads = 0;
  page.context().on('request', (request) => (loads += Number(request.url().endsWith('.wasm'))));
  await page.goto(browser.address);
  await says(page, /^Loading the planner\.$/);
  assert.equal(await page.getByRole('button', { name: /^(Stop|Plan the rest)$/ }).count(), 0);
  await page.waitForFunction(() => (page$('#closure')?.textContent ?? '–') !== '–');
  assert.equal(await page.locator('#planning').isVisible(), false);
  assert.deepEqual([loads, problems], [1, []]);
});

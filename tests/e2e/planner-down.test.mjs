// The planner comes late, not at first, or not at all: that is said, nothing kept is lost, and trying again helps.
import assert from 'node:assert/strict';
import { readdirSync, statSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { cell, nameIs, openBrowser } from './browser.mjs';

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

const WASM = /\.wasm$/;
const [WHOLE] = readdirSync('www/dist/assets')
  .filter((file) => file.endsWith('.wasm'))
  .sort((a, b) => statSync(`www/dist/assets/${b}`).size - statSync(`www/dist/assets/${a}`).size)
  .map((file) => `**/${file}`);
const motion = (page) => page.waitForFunction(() => (page$('#closure')?.textContent ?? '–') !== '–');
const kept = (page) => page.evaluate(() => localStorage.getItem('synthetica.work.1'));
/** What goes wrong in the page's own code; the browser itself says that a request was aborted. */
const ofThePage = (problems) => problems.filter((problem) => !/ERR_FAILED|Failed to load resource|Service Worker registration blocked/.test(problem));

/** A page that has kept a document of its own and is nowhere now. */
async function withKeptWork() {
  const { page, problems } = await browser.openPage({ viewport: { width: 1280, height: 800 }, serviceWorkers: 'block' });
  await cell(page, 'name').fill('Kept');
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => localStorage.getItem('synthetica.work.1')?.includes('Kept'));
  const work = await kept(page);
  return { page, problems, work };
}

test('kept work waits for a planner that comes late, and its loading is said', async () => {
  const { page, problems, work } = await withKeptWork();
  let release;
  const released = new Promise((resolve) => (release = resolve));
  await page.route(WASM, async (route) => {
    await released;
    await route.continue();
  });
  await page.reload();
  await page.getByRole('status').filter({ hasText: 'Loading the planner' }).waitFor({ state: 'attached' });
  assert.ok(await page.locator('#planning').isVisible());
  await page.evaluate(() => {
    window.said = [];
    new MutationObserver(() => said.push(page$('#planning-text').textContent)).observe(page$('#planning-text'), { childList: true, characterData: true, subtree: true });
  });
  // Longer than an element waits for its document.
  await page.waitForFunction(() => performance.now() > 2500);
  assert.ok(await page.locator('#trouble').isHidden());
  release();
  await nameIs(page, 'Kept');
  await motion(page);
  const said = await page.evaluate(() => window.said);
  assert.ok(said.some((text) => /^Loading the planner … \d+ %$/.test(text)), said.join());
  assert.equal(await kept(page), work);
  assert.equal(await page.locator('#notices p').count(), 0);
  assert.deepEqual(ofThePage(problems), []);
});

test('a planner that does not come is told, nothing kept is moved, and trying again starts the page; what is asked later says so too', async () => {
  const { page, problems, work } = await withKeptWork();
  await page.route(WASM, (route) => route.fulfill({ status: 503 }));
  await page.reload();
  const banner = page.getByRole('alert').filter({ hasText: 'The planner could not be loaded' });
  await banner.waitFor();
  await page.getByRole('button', { name: 'Try again' }).click();
  await banner.waitFor();
  assert.equal(await kept(page), work);
  // Nothing can be clicked that would not answer.
  const takesFocus = () =>
    page.evaluate(() => {
      const examples = document.getElementById('examples');
      examples.focus();
      return document.activeElement === examples;
    });
  assert.equal(await takesFocus(), false);
  await page.unroute(WASM);
  // The whole package, which is loaded when a hand comes, does not come from the beginning: what is there cannot be gone.
  await page.route(WHOLE, (route) => route.abort());
  await page.getByRole('button', { name: 'Try again' }).click();
  await nameIs(page, 'Kept');
  await motion(page);
  assert.equal(await takesFocus(), true);
  await page.locator('#trouble').waitFor({ state: 'hidden' });
  assert.equal(await page.locator('#notices p').count(), 0);
  assert.equal(await page.evaluate(() => localStorage.getItem('synthetica.earlier.1')), null);

  // Now with everything there, and the planner gone.
  await page.getByRole('button', { name: 'Share', exact: true }).click();
  const link = await page.getByRole('textbox', { name: 'Link' }).inputValue();
  await page.keyboard.press('Escape');
  await page.route(WASM, (route) => route.abort());
  const gone = /planner could not be loaded/;
  const notice = (words) => page.locator('#notices p').filter({ hasText: words }).filter({ hasText: gone });

  await page.getByRole('button', { name: 'New', exact: true }).click();
  await page.getByRole('dialog').getByRole('alert').filter({ hasText: gone }).waitFor();
  await page.getByRole('tab', { name: 'A type and sizes' }).click();
  await page.getByRole('dialog').getByRole('status').filter({ hasText: 'The linkage was not made' }).filter({ hasText: gone }).waitFor();
  await page.keyboard.press('Escape');

  await page.getByRole('tab', { name: 'Types' }).click();
  await page.getByRole('tabpanel', { name: 'Types' }).getByRole('alert').filter({ hasText: gone }).waitFor();

  await page.getByRole('button', { name: 'Share', exact: true }).click();
  await notice('No link was made').waitFor();
  await page.evaluate((hash) => {
    location.hash = hash;
  }, new URL(link).hash);
  await notice('This link was not opened').waitFor();

  await page.getByRole('button', { name: 'Export', exact: true }).click();
  await page.getByRole('menuitem', { name: /^Table \(CSV\)/ }).click();
  await notice('The file could not be made').waitFor();

  await page.getByRole('tab', { name: 'Algorithm' }).click();
  await page.getByRole('tabpanel', { name: 'Algorithm' }).getByText(gone).waitFor();
  await page.getByRole('tab', { name: 'Motion', exact: true }).click();
  await page.locator('.comparison-place').scrollIntoViewIfNeeded();
  await page.locator('.comparison').getByText(gone).waitFor();

  // It is there again.
  await page.unroute(WASM);
  await page.unroute(WHOLE);
  await page.getByRole('tab', { name: 'Algorithm' }).click();
  await page.getByRole('tabpanel', { name: 'Algorithm' }).getByRole('button', { name: 'Try again' }).click();
  await page.locator('.algorithm .flow').waitFor();
  assert.deepEqual(ofThePage(problems), []);
});

test('the late answer to an older address does not take the place of a newer one', async () => {
  const { page, problems } = await withKeptWork();
  const hashOf = async (name) => {
    await cell(page, 'name').fill(name);
    await page.keyboard.press('Enter');
    await page.getByRole('button', { name: 'Share', exact: true }).click();
    const link = await page.getByRole('textbox', { name: 'Link' }).inputValue();
    await page.keyboard.press('Escape');
    return new URL(link).hash;
  };
  const [older, newer] = [await hashOf('Older'), await hashOf('Newer')];
  await cell(page, 'name').fill('Present');
  await page.keyboard.press('Enter');
  await page.evaluate((hash) => {
    const { parts: linkage } = document.querySelector('synthetica-linkage');
    const { whole } = linkage;
    const release = new Promise((resolve) => (window.release = resolve));
    const late = new Promise((resolve) => {
      linkage.whole = async (text) => {
        const read = await whole(text);
        if (!text.includes('Older')) return read;
        setTimeout(() => (window.held = true));
        await release;
        setTimeout(resolve);
        return read;
      };
    });
    window.late = late;
    location.hash = hash;
  }, older);
  await page.waitForFunction(() => window.held);
  await page.evaluate((hash) => {
    location.hash = hash;
  }, newer);
  await nameIs(page, 'Newer');
  await page.evaluate(() => {
    window.release();
    return window.late;
  });
  assert.equal(await page.locator('#document-name').textContent(), 'Newer');
  assert.deepEqual(ofThePage(problems), []);
});

// After one visit the page works without its server.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { chromium } from 'playwright-core';
import { preview } from 'vite';
import { LAUNCH } from './browser.mjs';

const opened = (page) => page.locator('#closure').filter({ hasText: /\d/ }).waitFor({ state: 'attached' });

test('works offline after the first load, every lazily loaded part included', async () => {
  const server = await preview({ configFile: 'tools/vite.config.js', preview: { port: 0 } });
  const [address] = server.resolvedUrls.local;
  const browser = await chromium.launch(LAUNCH);
  try {
    const page = await (await browser.newContext({ reducedMotion: 'reduce', viewport: { width: 800, height: 600 } })).newPage();
    await page.goto(address);
    await opened(page);
    // Ready when every file is kept.
    await page.evaluate(() => navigator.serviceWorker.ready.then(() => true));
    await server.close();
    await assert.rejects(fetch(address), 'the server is gone');

    const problems = [];
    page.on('pageerror', (error) => problems.push(String(error)));
    page.on('requestfailed', (request) => problems.push(request.url()));
    await page.goto(`${address}?from=a-bookmark`);
    await opened(page);
    // What was never loaded before is there too.
    const missing = await page.evaluate(async () => {
      const names = (await caches.keys()).filter((name) => name.startsWith('synthetica-'));
      const kept = await (await caches.open(names[0])).keys();
      const scripts = kept.map((request) => request.url).filter((url) => url.endsWith('.js'));
      const answers = await Promise.all(scripts.map((url) => fetch(url).then((answer) => answer.ok, () => false)));
      return { caches: names.length, scripts: scripts.length, failed: answers.filter((ok) => !ok).length };
    });
    assert.equal(missing.caches, 1);
    assert.ok(missing.scripts >= 2, 'scripts are kept');
    assert.equal(missing.failed, 0);
    assert.deepEqual(problems.filter((url) => !url.endsWith('service-worker.js')), []);

    // So are the pages beside the applet, and what they show.
    await page.goto(`${address}gallery.html?from=a-bookmark`);
    await page.getByRole('heading', { name: '3RPS' }).scrollIntoViewIfNeeded();
    await page.waitForFunction(() => document.images[1].naturalWidth > 0);
    await page.getByRole('link', { name: 'Method' }).click();
    await page.getByRole('heading', { name: 'The method' }).waitFor();
  } finally {
    await browser.close();
    await server.close().catch(() => {});
  }
});

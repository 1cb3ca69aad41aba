// What a first visit loads, after gzip: page, styles, code with the 3D library, planner, pictures.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { gzipSync } from 'node:zlib';
import { openBrowser } from './browser.mjs';

/** Bytes after gzip. */
const BUDGET = 286_000;

test('the page with all that its first view needs is within its budget', async () => {
  const browser = await openBrowser();
  try {
    const { page } = await browser.blankPage({ viewport: { width: 1280, height: 800 }, serviceWorkers: 'block' });
    /** @type {Map<string, Promise<number>>} */
    const sizes = new Map();
    page.on('response', (response) => {
      if (response.status() === 200 && !sizes.has(response.url())) {
        sizes.set(response.url(), response.body().then((body) => gzipSync(body, { level: 9 }).length));
      }
    });
    await page.goto(browser.address);
    await page.waitForFunction(() => (page$('#closure')?.textContent ?? '–') !== '–');
    await page.waitForLoadState('networkidle');
    const all = await Promise.all([...sizes].map(async ([url, size]) => [new URL(url).pathname, await size]));
    assert.ok(all.some(([path]) => path.endsWith('.wasm')) && all.some(([path]) => path.includes('linkage')), 'planner and 3D view are counted');
    // Pieces that are kept out of the first view are not in it.
    assert.ok(!all.some(([path]) => /html-|gallery|algorithm|new-dialog|chart|plot|holds/.test(path)), 'what is seen later is loaded later');
    const total = all.reduce((sum, [, size]) => sum + size, 0);
    console.log(`first load: ${total} bytes after gzip`);
    assert.ok(total <= BUDGET, JSON.stringify(all.sort((a, b) => b[1] - a[1]), null, 1));
  } finally {
    await browser.close();
  }
});

// Somebody else's site for tests: a plain server that sends no header but the type, a browser, pages that are written in the test.
import { readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname } from 'node:path';
import { chromium } from 'playwright-core';
import { LAUNCH } from '../e2e/browser.mjs';

/** What is published. */
export const dist = new URL('../../dist/', import.meta.url);

const TYPES = { '.html': 'text/html', '.js': 'text/javascript', '.json': 'application/json', '.wasm': 'application/wasm', '.css': 'text/css', '.svg': 'image/svg+xml', '.jpg': 'image/jpeg', '.webp': 'image/webp', '.txt': 'text/plain; charset=utf-8' };

/**
 * @param {Record<string, string | URL>} files texts by path, or a folder whose files lie below a path that ends with a slash
 * @param {Record<string, string>} [headers] of every answer
 */
export async function serve(files, headers = {}) {
  const server = createServer((request, response) => {
    const pathname = new URL(request.url, 'http://site').pathname.replace(/\/$/, '/index.html');
    const folder = Object.keys(files).find((path) => path.endsWith('/') && pathname.startsWith(path));
    try {
      // Browsers ask for it by themselves.
      const body = pathname === '/favicon.ico' ? '' : files[pathname] ?? readFileSync(new URL(pathname.slice(folder.length), files[folder]));
      for (const [name, value] of Object.entries(headers)) response.setHeader(name, value);
      response.setHeader('content-type', TYPES[extname(pathname)] ?? 'text/plain');
      response.end(body);
    } catch {
      response.statusCode = 404;
      response.end();
    }
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  return { address: `http://127.0.0.1:${server.address().port}`, close: () => server.close() };
}

/** A page of a course. @param {string} head @param {string} [body] */
export const course = (head, body = '<synthetica-linkage type="3RPS" controls panels="mechanism info"></synthetica-linkage>') =>
  `<!doctype html><html lang="en"><head><meta charset="utf-8"><title>A course</title>${head}</head><body>${body}</body></html>`;

export const openBrowser = () => chromium.launch(LAUNCH);

/** @param {import('playwright-core').Browser} browser @param {string} address */
export async function open(browser, address) {
  const page = await (await browser.newContext({ viewport: { width: 800, height: 600 }, reducedMotion: 'reduce' })).newPage();
  // Other suites may run at the same time.
  page.setDefaultTimeout(60_000);
  const problems = [];
  const requests = [];
  // Chromium remarks on its own screenshots of a canvas.
  page.on('console', (message) => ['error', 'warning'].includes(message.type()) && !message.text().includes('GPU stall') && problems.push(message.text()));
  page.on('pageerror', (error) => problems.push(String(error)));
  page.on('request', (request) => /^https?:(?!.*favicon)/.test(request.url()) && requests.push(request.url()));
  await page.goto(address);
  return { page, problems, requests };
}

/** Waits until the linkage is planned, drawn and in its panels; gives its motion's number of frames. @param {import('playwright-core').Page} page */
export async function alive(page) {
  await page.waitForFunction(() => document.querySelector('synthetica-linkage')?.trajectory);
  await page.waitForFunction(() => document.querySelector('synthetica-linkage').shadowRoot.querySelector('canvas')?.dataset.draws > 0);
  await page.locator('[data-path="chains[0].base.x"]').waitFor();
  return page.evaluate(() => document.querySelector('synthetica-linkage').trajectory.frames);
}

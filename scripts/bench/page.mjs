// The built page in a browser, for the measurements beside this file: served from this machine, with an empty cache.
import { existsSync } from 'node:fs';
import { setTimeout as pause } from 'node:timers/promises';
import { chromium } from 'playwright-core';
import { preview } from 'vite';
import { LAUNCH, lookInside } from '../../tests/e2e/browser.mjs';

export { pause };

/** @typedef {Awaited<ReturnType<typeof openBench>>} Bench */
/** @typedef {import('playwright-core').Page} Page */

/** @param {number[]} values @param {number} share */
export const quantile = (values, share) => values.toSorted((a, b) => a - b)[Math.min(values.length - 1, Math.floor(values.length * share))];
/** @param {number[]} values */
export const median = (values) => quantile(values, 0.5);

/** In the page, before its scripts: notes how long each call of the worker takes, and when the linkage first moves. @param {boolean} moving */
function watch(moving) {
  const noted = { moved: 0, calls: /** @type {{call: string, ms: number, planning?: number}[]} */ ([]), open: 0 };
  Object.assign(globalThis, { noted });
  let first = '';
  const look = () => {
    const now = page$('#frame-number')?.textContent ?? '';
    if (/^\d/.test(now)) first ||= now;
    if (first && now !== first) {
      noted.moved = performance.now();
      console.debug('the linkage has moved');
    } else requestAnimationFrame(look);
  };
  // A linkage that does not move would be looked at for ever, which is script too.
  if (moving) requestAnimationFrame(look);
  const Plain = Worker;
  globalThis.Worker = class extends Plain {
    sent = new Map();
    constructor(/** @type {[any, any]} */ ...args) {
      super(...args);
      this.addEventListener('message', ({ data }) => {
        // What is said before the answer, and what is no answer.
        const { call, at } = this.sent.get(data.id) ?? {};
        if (!call || ['received', 'begun', 'progress'].includes(data.kind)) return;
        this.sent.delete(data.id);
        noted.calls.push({ call, ms: performance.now() - at, planning: data.value?.milliseconds });
        noted.open -= 1;
      });
    }
    postMessage(/** @type {any} */ message) {
      if (message.kind !== 'ask') return super.postMessage(message);
      noted.open += 1;
      this.sent.set(message.id, { call: message.call, at: performance.now() });
      super.postMessage(message);
    }
  };
}

export async function openBench() {
  if (!existsSync('www/dist/index.html')) throw new Error('no page in www/dist: build it first (scripts/dev.sh build)');
  const server = await preview({ configFile: 'tools/vite.config.js', preview: { port: 0 } });
  const browser = await chromium.launch(LAUNCH);
  const address = server.resolvedUrls?.local[0] ?? '';
  return {
    /** A visit that has just begun. @param {import('playwright-core').BrowserContextOptions} [options] @param {number} [settled] ms that its window is open before */
    async load(options, settled = 0) {
      const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, serviceWorkers: 'block', ...options });
      const page = await context.newPage();
      /** @type {{file: string, at: number}[]} */
      const asked = [];
      // Told by the page: to ask it, Playwright would bring a large script into it while it starts.
      const moved = new Promise((resolve) => page.on('console', (message) => message.text() === 'the linkage has moved' && resolve(null)));
      context.on('request', (request) => asked.push({ file: new URL(request.url()).pathname.slice(1) || 'index.html', at: Date.now() }));
      await page.addInitScript(lookInside);
      const still = options?.reducedMotion === 'reduce';
      await page.addInitScript(watch, !still);
      // Who works with the page has seen its first minute, which would lie over the tables.
      if (still) await page.addInitScript(() => localStorage.setItem('synthetica.first-minute', 'in a measurement'));
      await pause(settled);
      await page.goto(address);
      return { context, page, asked, moved };
    },
    async close() {
      await browser.close();
      await server.close();
    },
  };
}

/** What is the same for the page and for what it asks of the worker. @param {Page} page */
export const noted = (page) => page.evaluate(() => /** @type {any} */ (globalThis).noted);

/** The first motion is planned. @param {Page} page */
export const planned = (page) => page.waitForFunction(() => (page$('#closure')?.textContent ?? '–') !== '–');

/**
 * Chromium's own counters of a page (DevTools protocol, Performance.getMetrics).
 * @param {Page} page
 */
export async function countersOf(page) {
  const devtools = await page.context().newCDPSession(page);
  await devtools.send('Performance.enable');
  const metric = async (/** @type {string} */ wanted) => {
    const { metrics } = await devtools.send('Performance.getMetrics');
    return metrics.find(({ name }) => name === wanted)?.value ?? 0;
  };
  return {
    devtools,
    /** ms of script on the page's own thread */
    script: async () => (await metric('ScriptDuration')) * 1000,
    /** @param {number} rate how many times slower the page's own thread is */
    throttle: (rate) => devtools.send('Emulation.setCPUThrottlingRate', { rate }),
  };
}

// Prints what the built page costs: bytes, time to the first animated frame, script time per pointer move while
// something is dragged. Run by `scripts/dev.sh bench` after a build; fails only where the bytes are over their budget.
//
// - Bytes: the files of www/dist that the page and its worker ask for without being asked to by a person, after
//   gzip -9: until the linkage moves, and after that. What is left is loaded when it is wanted.
// - First animated frame: from the navigation's start until the playhead has moved and been drawn, by the page's own
//   clock; each load with an empty cache, from a server on this machine.
// - Script per move: the growth of Chromium's own ScriptDuration (DevTools protocol, Performance.getMetrics: all
//   script on the page's main thread, so handlers, store, tables, drawing commands and the answers of the worker) from
//   one pointer move until all that it caused is done. CPU throttling by Emulation.setCPUThrottlingRate, which slows
//   the main thread. The picture itself is computed outside the main thread and is not counted.
// - Round trip: from a message to the planner's worker to its answer's arrival on the main thread, so with the wait for
//   a picture that is being drawn. Planning alone: what the worker says that a plan took, which throttling spares.
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { extname } from 'node:path';
import { gzipSync } from 'node:zlib';
import { setTimeout as pause } from 'node:timers/promises';
import { chromium } from 'playwright-core';
import { preview } from 'vite';
import { lookInside } from '../tests/e2e/browser.mjs';

const BUDGET = 410_000; // bytes after gzip, before and after the linkage moves
const LOADS = 7;
const MOVES = 60;
const RATES = [1, 4];
const FRAME = 1000 / 60; // ms

process.chdir(new URL('..', import.meta.url).pathname);
if (!existsSync('www/dist/index.html')) throw new Error('no page in www/dist: build it first (scripts/dev.sh build)');

/** @param {number[]} values @param {number} share */
const quantile = (values, share) => values.toSorted((a, b) => a - b)[Math.min(values.length - 1, Math.floor(values.length * share))];
/** @param {number[]} values */
const both = (values) => `${quantile(values, 0.5).toFixed(1).padStart(7)} ${quantile(values, 0.95).toFixed(1).padStart(7)}`;
const kilobytes = (/** @type {number} */ bytes) => `${(bytes / 1000).toFixed(1).padStart(7)} kB`;

const server = await preview({ configFile: 'tools/vite.config.js', preview: { port: 0 } });
const address = server.resolvedUrls?.local[0] ?? '';
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM || '/usr/bin/chromium', args: ['--no-sandbox'] });

/** In the page, before its scripts: notes when the linkage first moves, and how long each call of the worker takes. */
function watch() {
  const noted = { moved: 0, calls: /** @type {{call: string, ms: number, planning?: number}[]} */ ([]), open: 0 };
  Object.assign(globalThis, { noted });
  let first = '';
  const look = () => {
    const now = page$('#frame-number')?.textContent ?? '';
    if (/^\d/.test(now)) first ||= now;
    if (first && now !== first) noted.moved = performance.now();
    else requestAnimationFrame(look);
  };
  requestAnimationFrame(look);
  const Plain = Worker;
  globalThis.Worker = class extends Plain {
    sent = new Map();
    constructor(/** @type {[any, any]} */ ...args) {
      super(...args);
      this.addEventListener('message', ({ data }) => {
        // What is said before the answer.
        if (data.kind === 'begun' || data.kind === 'progress') return;
        const { call, at } = this.sent.get(data.id) ?? {};
        if (call) noted.calls.push({ call, ms: performance.now() - at, planning: data.value?.milliseconds });
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

/** @param {import('playwright-core').BrowserContextOptions} [options] */
async function load(options) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, serviceWorkers: 'block', ...options });
  const page = await context.newPage();
  /** @type {{file: string, at: number}[]} */
  const asked = [];
  context.on('request', (request) => asked.push({ file: new URL(request.url()).pathname.slice(1) || 'index.html', at: Date.now() }));
  await page.addInitScript(lookInside);
  await page.addInitScript(watch);
  await page.goto(address);
  return { context, page, asked };
}

/** What is the same for the page and for what it asks of the worker. @param {import('playwright-core').Page} page */
const noted = (page) => page.evaluate(() => /** @type {any} */ (globalThis).noted);

async function bytes() {
  const { context, page, asked } = await load();
  await page.waitForFunction(() => /** @type {any} */ (globalThis).noted.moved > 0);
  const moving = await page.evaluate(() => performance.timeOrigin + /** @type {any} */ (globalThis).noted.moved);
  await page.waitForLoadState('networkidle');
  await pause(2000);
  const size = (/** @type {string} */ file) => gzipSync(readFileSync(`www/dist/${file}`), { level: 9 }).length;
  const files = readdirSync('www/dist', { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => `${entry.parentPath}/${entry.name}`.slice('www/dist/'.length));
  const when = (/** @type {string} */ file) => asked.find((request) => request.file === file)?.at ?? Infinity;
  const groups = { first: 'until the linkage moves', after: 'after that, unasked', wanted: 'when wanted' };
  /** @type {Record<string, Record<string, number>>} */
  const sums = { first: {}, after: {}, wanted: {} };
  for (const file of files) {
    const group = sums[when(file) <= moving ? 'first' : when(file) < Infinity ? 'after' : 'wanted'];
    const type = extname(file).slice(1);
    group[type] = (group[type] ?? 0) + size(file);
  }
  const total = (/** @type {Record<string, number>} */ group) => Object.values(group).reduce((sum, value) => sum + value, 0);
  console.log('\ntransfer, after gzip');
  for (const [key, name] of Object.entries(groups)) {
    const types = Object.entries(sums[key]).sort((a, b) => b[1] - a[1]).map(([type, value]) => `${type} ${(value / 1000).toFixed(1)}`);
    console.log(`  ${name.padEnd(26)} ${kilobytes(total(sums[key]))}   ${types.join(', ')}`);
  }
  const all = total(sums.first) + total(sums.after);
  console.log(`  ${'first load'.padEnd(26)} ${kilobytes(all)}   at most ${BUDGET / 1000}`);
  await context.close();
  return all;
}

async function firstFrame() {
  /** @type {number[]} */
  const times = [];
  for (let i = 0; i < LOADS; i += 1) {
    const { context, page } = await load();
    await page.waitForFunction(() => /** @type {any} */ (globalThis).noted.moved > 0);
    times.push((await noted(page)).moved);
    await context.close();
  }
  console.log(`\nfirst animated frame: ${quantile(times, 0.5).toFixed(0)} ms (median of ${LOADS} loads, ${Math.min(...times).toFixed(0)} to ${Math.max(...times).toFixed(0)})`);
}

/** Selects a thing with the keyboard, as a person may: ] goes through the things. @param {import('playwright-core').Page} page @param {string} place */
async function select(page, place) {
  await page.locator('#canvas').focus();
  const pointed = page.locator(`#canvas[data-hovered="${place}"]`);
  for (let i = 0; i < 60 && !(await pointed.count()); i += 1) await page.keyboard.press(']');
  await page.keyboard.press('Enter');
  await page.locator(`#canvas[data-hand]`).waitFor();
  const [x, y] = (await page.locator('#canvas').getAttribute('data-hand') ?? '').split(' ').map(Number);
  const box = await page.locator('#canvas').boundingBox();
  return { x: (box?.x ?? 0) + x, y: (box?.y ?? 0) + y };
}

/** @param {string} what @param {string} place @param {string} call */
async function drag(what, place, call) {
  for (const rate of RATES) {
    const { context, page } = await load({ reducedMotion: 'reduce' });
    await page.waitForFunction(() => (page$('#closure')?.textContent ?? '–') !== '–');
    const at = await select(page, place);
    const devtools = await context.newCDPSession(page);
    await devtools.send('Performance.enable');
    await devtools.send('Emulation.setCPUThrottlingRate', { rate });
    const script = async () => {
      const { metrics } = await devtools.send('Performance.getMetrics');
      return (metrics.find(({ name }) => name === 'ScriptDuration')?.value ?? 0) * 1000;
    };
    await page.mouse.move(at.x, at.y);
    await page.mouse.down();
    await page.mouse.move(at.x + 8, at.y);
    await pause(500);
    const { calls: earlier } = await noted(page);
    /** @type {number[]} */
    const times = [];
    for (let i = 0; i < MOVES; i += 1) {
      const angle = (i / MOVES) * 4 * Math.PI;
      const before = await script();
      await page.mouse.move(at.x + 8 + 30 * Math.sin(angle), at.y + 30 * (1 - Math.cos(angle)));
      await pause(60 * rate);
      times.push((await script()) - before);
    }
    const { calls } = await noted(page);
    await page.mouse.up();
    /** @type {{call: string, ms: number, planning?: number}[]} */
    const done = calls.slice(earlier.length).filter((/** @type {{call: string}} */ answer) => answer.call === call);
    const planning = done.map((answer) => answer.planning ?? NaN);
    const own = Number.isNaN(planning[0]) ? ' '.repeat(15) : both(planning);
    console.log(`  ${what.padEnd(12)} ${rate}×  ${both(times)}   ${both(done.map(({ ms }) => ms))}   ${own}`);
    await context.close();
  }
}

let size = 0;
try {
  size = await bytes();
  await firstFrame();
  console.log(`\nper pointer move, ms (median, 95th percentile); a display frame is ${FRAME.toFixed(1)}\n  dragged  throttle  script            round trip        planning alone`);
  await drag('key frame', 'motion.key_frames[1]', 'plan');
  await drag('workpiece', 'workpiece', 'pull');
} finally {
  await browser.close();
  await server.close();
}
process.exitCode = size > BUDGET ? 1 : 0;

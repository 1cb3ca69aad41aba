// Prints how long a plan takes as WebAssembly in Chromium against natively, and the size of the package.
// Run by `scripts/dev.sh bench`, which builds the package and names the browser in CHROMIUM.
import { execFileSync } from 'node:child_process';
import { readdirSync, readFileSync } from 'node:fs';
import { gzipSync } from 'node:zlib';
import { chromium } from 'playwright-core';

// The two take turns, and the medians of all turns are compared: a machine that is slow for a while is slow for both.
const ROUNDS = 5;

process.chdir(new URL('..', import.meta.url).pathname);
const folder = 'www/mechanisms';
const documents = readdirSync(folder).filter((name) => name.endsWith('.json') && name !== 'index.json');
if (documents.length === 0) throw new Error(`no documents in ${folder}`);

/** @param {number[]} values */
const median = (values) => values.toSorted((a, b) => a - b)[values.length >> 1];

/** Microseconds of one plan, text to columns, by examples/time.rs; it measures as `inBrowser` does. @param {string} file */
function natively(file) {
  const command = ['run', '--release', '--quiet', '--locked', '--example', 'time', '--', file];
  return JSON.parse(execFileSync('cargo', command, { encoding: 'utf8' })).microseconds;
}

/** The same, by the package: the median of samples, each a batch long enough for the browser's coarse clock. @param {string} text */
async function inBrowser(text) {
  // @ts-ignore: an address of the page, not of this file
  const { default: init, Session } = await import('/pkg-first/synthetica.js');
  await init();
  const plan = () => {
    const session = Session.open(text);
    session.plan();
    session.free();
  };
  const SAMPLES = 15;
  const BATCH = 20; // ms
  const WARM_UP = 500; // ms, in which the browser's optimising compiler replaces its first, quick one
  const begin = performance.now();
  let runs = 0;
  while (performance.now() - begin < WARM_UP) {
    plan();
    runs += 1;
  }
  const batch = Math.max(1, Math.ceil((runs * BATCH) / WARM_UP));
  const samples = [];
  for (let s = 0; s < SAMPLES; s += 1) {
    const start = performance.now();
    for (let r = 0; r < batch; r += 1) plan();
    samples.push(((performance.now() - start) / batch) * 1000);
  }
  return samples.sort((a, b) => a - b)[SAMPLES >> 1];
}

const browser = await chromium.launch({ executablePath: process.env.CHROMIUM, args: ['--no-sandbox'] });
try {
  const page = await browser.newPage();
  // The page and the package, without a server.
  await page.route('http://bench.test/**', (route) => {
    const { pathname } = new URL(route.request().url());
    return pathname === '/'
      ? route.fulfill({ contentType: 'text/html', body: '<!doctype html>' })
      : route.fulfill({ path: `www${pathname}` });
  });
  await page.goto('http://bench.test/');

  console.log(`${'document'.padEnd(24)} native µs   wasm µs   ratio`);
  for (const name of documents) {
    const file = `${folder}/${name}`;
    const text = readFileSync(file, 'utf8');
    const native = [];
    const wasm = [];
    for (let round = 0; round < ROUNDS; round += 1) {
      native.push(natively(file));
      wasm.push(await page.evaluate(inBrowser, text));
    }
    const ratio = median(wasm) / median(native);
    const columns = [median(native).toFixed(1).padStart(9), median(wasm).toFixed(1).padStart(9), ratio.toFixed(2).padStart(7)];
    console.log(`${name.padEnd(24)} ${columns.join(' ')}`);
  }
} finally {
  await browser.close();
}

const size = gzipSync(readFileSync('www/pkg-first/synthetica_bg.wasm'), { level: 9 }).length;
console.log(`WebAssembly that is loaded first: ${size} bytes after gzip`);

// Prints how long a plan takes as WebAssembly in Chromium against natively, and the size of the package, each with its bar
// and whether it holds. Times depend on the machine: a bar that is missed is said, and is no error.
// Run by `scripts/dev.sh bench`, which builds the package and names the browser in CHROMIUM.
import { execFileSync } from 'node:child_process';
import { readdirSync, readFileSync } from 'node:fs';
import { gzipSync } from 'node:zlib';
import { chromium } from 'playwright-core';

// The two take turns, and the median of the turns' comparisons counts: a machine that is slow for a while is slow for both.
const ROUNDS = 5;

/** The package that reads a document as the page asks for it: the whole one only where the first cannot. */
const PACKAGES = { plain: '/pkg-first/synthetica.js', typed: '/pkg/synthetica.js' };

// What the package may take: so many times the native time for plans that take longer than LONG natively, at most so
// much more for the shorter ones, which are made of reading and copying.
const LONG = 1000; // µs
const MOST_TIMES = 1.35;
const MOST_MORE = 400; // µs
const MOST_BYTES = 110_000; // after gzip

process.chdir(new URL('..', import.meta.url).pathname);
const folder = 'www/mechanisms';
const documents = readdirSync(folder).filter((name) => name.endsWith('.json') && name !== 'index.json');
if (documents.length === 0) throw new Error(`no documents in ${folder}`);

/** @param {number[]} values */
const median = (values) => values.toSorted((a, b) => a - b)[values.length >> 1];

/**
 * Microseconds of one plan, text to columns, by examples/time.rs, which measures as `inBrowser` does; and the reader that
 * the document needs.
 * @param {string} file @returns {{microseconds: number, reader: 'plain' | 'typed'}}
 */
function natively(file) {
  const command = ['run', '--release', '--quiet', '--locked', '--example', 'time', '--', file];
  return JSON.parse(execFileSync('cargo', command, { encoding: 'utf8' }));
}

/**
 * The same, by a package: the median of samples, each a batch long enough for the browser's coarse clock.
 * @param {{text: string, address: string}} of
 */
async function inBrowser({ text, address }) {
  const { default: init, Session } = await import(address);
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

  console.log('plan in the browser against native, text to columns');
  console.log(`${'document'.padEnd(24)} native µs   wasm µs   ratio   difference   bar`);
  for (const name of documents) {
    const file = `${folder}/${name}`;
    const text = readFileSync(file, 'utf8');
    const turns = [];
    for (let round = 0; round < ROUNDS; round += 1) {
      const { microseconds: native, reader } = natively(file);
      const wasm = await page.evaluate(inBrowser, { text, address: PACKAGES[reader] });
      turns.push({ native, wasm, ratio: wasm / native, more: wasm - native });
    }
    /** @param {'native' | 'wasm' | 'ratio' | 'more'} of */
    const middle = (of) => median(turns.map((turn) => turn[of]));
    const [native, wasm, ratio, more] = [middle('native'), middle('wasm'), middle('ratio'), middle('more')];
    const isLong = native > LONG;
    const bar = isLong ? `at most ${MOST_TIMES} times` : `at most ${MOST_MORE} µs more`;
    const holds = isLong ? ratio <= MOST_TIMES : more <= MOST_MORE;
    const columns = [native.toFixed(1).padStart(9), wasm.toFixed(1).padStart(9), ratio.toFixed(2).padStart(7), more.toFixed(0).padStart(12)];
    console.log(`${name.padEnd(24)} ${columns.join(' ')}   ${bar}: ${holds ? 'holds' : 'missed'}`);
  }
} finally {
  await browser.close();
}

const size = gzipSync(readFileSync('www/pkg-first/synthetica_bg.wasm'), { level: 9 }).length;
console.log(`WebAssembly that is loaded first: ${size} bytes after gzip, at most ${MOST_BYTES}: ${size <= MOST_BYTES ? 'holds' : 'missed'}`);

// Bytes of the first load: the files of www/dist that the page and its worker ask for without being asked to by a person,
// preloads counted, until the network is idle, after gzip -9. What is left is loaded when it is wanted.
import { readdirSync, readFileSync } from 'node:fs';
import { extname } from 'node:path';
import { gzipSync } from 'node:zlib';
import { LIMITS } from './limits.mjs';
import { pause } from './page.mjs';
import { kilobytes } from './print.mjs';

/** After the network's first rest, in ms: what a page asks for when it has nothing else to do. */
const QUIET = 2000;

/** @param {import('./page.mjs').Bench} bench @returns {Promise<import('./print.mjs').Bar[]>} */
export async function transfer(bench) {
  const { context, page, asked } = await bench.load();
  await page.waitForFunction(() => /** @type {any} */ (globalThis).noted.moved > 0);
  const moving = await page.evaluate(() => performance.timeOrigin + /** @type {any} */ (globalThis).noted.moved);
  await page.waitForLoadState('networkidle');
  await pause(QUIET);
  await page.waitForLoadState('networkidle');
  await context.close();
  const files = readdirSync('www/dist', { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => `${entry.parentPath}/${entry.name}`.slice('www/dist/'.length));
  const when = (/** @type {string} */ file) => asked.find((request) => request.file === file)?.at ?? Infinity;
  const groups = { first: 'until the linkage moves', after: 'after that, unasked', wanted: 'when wanted' };
  /** Bytes by the type of the file. @type {Record<string, Record<string, number>>} */
  const sums = { first: {}, after: {}, wanted: {} };
  for (const file of files) {
    const group = sums[when(file) <= moving ? 'first' : when(file) < Infinity ? 'after' : 'wanted'];
    const type = extname(file).slice(1);
    group[type] = (group[type] ?? 0) + gzipSync(readFileSync(`www/dist/${file}`), { level: 9 }).length;
  }
  const total = (/** @type {Record<string, number>} */ group) => Object.values(group).reduce((sum, value) => sum + value, 0);
  for (const [key, name] of Object.entries(groups)) {
    const types = Object.entries(sums[key]).sort((a, b) => b[1] - a[1]).map(([type, value]) => `${type} ${(value / 1000).toFixed(1)}`);
    console.log(`  ${name.padEnd(46)} ${kilobytes(total(sums[key])).padStart(10)}   ${types.join(', ')}`);
  }
  return [
    { what: 'first load, after gzip', value: total(sums.first) + total(sums.after), limit: LIMITS.firstLoad, write: kilobytes },
    { what: 'of it wasm', value: (sums.first.wasm ?? 0) + (sums.after.wasm ?? 0), limit: LIMITS.firstWasm, write: kilobytes },
  ];
}

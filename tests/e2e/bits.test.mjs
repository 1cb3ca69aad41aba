// One document, one motion: planned natively, by the wasm packages in Node and by the element in Chromium, every column
// is the same to the last bit.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { text } from 'node:stream/consumers';
import { openBrowser } from './browser.mjs';
import { COLUMNS, digests } from './digest.mjs';

const at = (path) => new URL(`../../${path}`, import.meta.url);
const samples = JSON.parse(readFileSync(at('www/mechanisms/index.json'), 'utf8'));

/** The paper's gradient takes thousands of steps a frame. */
const GRADIENT_FRAMES = 9;

/** Every sample, by both methods; a document is one line. */
const documents = samples.flatMap(({ file }) => {
  const document = JSON.parse(readFileSync(at(`www/mechanisms/${file}`), 'utf8'));
  const { planner, motion } = document;
  const typed = 'parameters' in document;
  const slow = { ...document, motion: { ...motion, frames: GRADIENT_FRAMES }, planner: { ...planner, method: 'gradient' } };
  return [
    { name: `${file}, newton`, text: JSON.stringify(document), inFirst: !typed && !motion.drivers },
    // What is driven has no goals to descend to.
    ...(motion.drivers ? [] : [{ name: `${file}, gradient`, text: JSON.stringify(slow), inFirst: false }]),
  ];
});

/** As this machine's own code has it. */
async function native() {
  const run = spawn('cargo', ['run', '--quiet', '--locked', '--all-features', '--example', 'digest'], { cwd: at('.'), stdio: ['pipe', 'pipe', 'inherit'] });
  run.stdin.end(documents.map((document) => `${document.text}\n`).join(''));
  const [out, code] = await Promise.all([text(run.stdout), new Promise((end) => run.on('close', end))]);
  assert.equal(code, 0);
  return out.trim().split('\n').map((line) => JSON.parse(line));
}

const expected = native();
expected.catch(() => {});

/** @param {Record<string, string>[]} found @param {typeof documents} [of] */
async function same(found, of = documents) {
  const all = await expected;
  assert.equal(all.length, documents.length);
  assert.equal(found.length, of.length);
  of.forEach((document, index) => {
    const { name } = document;
    const wanted = all[documents.indexOf(document)];
    for (const column of COLUMNS) assert.ok(Number.parseInt(wanted[column]) > 0, `${name}: ${column} is there`);
    assert.deepEqual(found[index], wanted, name);
  });
}

for (const folder of ['pkg', 'pkg-first']) {
  test(`in Node, www/${folder}`, async () => {
    const { initSync, Session } = await import(at(`www/${folder}/synthetica.js`));
    initSync({ module: readFileSync(at(`www/${folder}/synthetica_bg.wasm`)) });
    // Opened once and asked twice: in one go, and frame by frame.
    const read = documents.filter(({ inFirst }) => folder === 'pkg' || inFirst);
    assert.ok(read.length >= 8);
    for (const { name, text, inFirst } of documents) if (folder !== 'pkg' && !inFirst) assert.throws(() => Session.open(text), (error) => error === null, name);
    const sessions = read.map((document) => Session.open(document.text));
    await same(sessions.map((session) => digests(session.plan())), read);
    for (const session of sessions) while (session.advance_plan(0));
    await same(sessions.map((session) => digests(session.plan_so_far())), read);
    for (const session of sessions) session.free();
  });
}

test('in Chromium, as the element plans it in its worker', async () => {
  const browser = await openBrowser();
  try {
    const { page } = await browser.blankPage();
    const serve = (name, contentType, body) => page.route(`${browser.address}${name}`, (route) => route.fulfill({ contentType, body }));
    await serve('bits.html', 'text/html', '<!doctype html><script type="module" src="./element.js"></script><synthetica-linkage></synthetica-linkage>');
    await serve('digest.mjs', 'text/javascript', readFileSync(new URL('digest.mjs', import.meta.url), 'utf8'));
    await page.goto(`${browser.address}bits.html`);
    const found = await page.evaluate(async (texts) => {
      const { digests } = await import('./digest.mjs');
      const element = document.querySelector('synthetica-linkage');
      const all = [];
      for (const one of texts) {
        const planned = new Promise((resolve, reject) => {
          element.addEventListener('ready', resolve, { once: true });
          element.addEventListener('error', () => reject(new Error(element.error.message)), { once: true });
        });
        element.document = one;
        await planned;
        all.push(digests(element.trajectory));
      }
      return all;
    }, documents.map((document) => document.text));
    await same(found);
  } finally {
    await browser.close();
  }
});

test('another last bit anywhere is another digest', () => {
  const motion = () => Object.fromEntries(COLUMNS.map((name) => [name, name === 'iterations' ? Uint32Array.of(1, 2, 3) : Float64Array.of(0.1, -0.2, 0)]));
  const plain = digests(motion());
  for (const name of COLUMNS.filter((column) => column !== 'iterations')) {
    for (let index = 0; index < 3; index++) {
      const other = motion();
      new BigUint64Array(other[name].buffer)[index] ^= 1n;
      assert.notEqual(digests(other)[name], plain[name]);
    }
  }
});

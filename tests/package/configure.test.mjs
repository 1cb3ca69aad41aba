// The planner's two files elsewhere than the package's code looks for them: said by configure, before the first question.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { copyFileSync, mkdtempSync, readFileSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { course, dist, open, openBrowser, serve } from './site.mjs';

/** The scripts of the package in a folder without its worker and its wasm, as a bundler leaves them that does not know of those. */
const scripts = mkdtempSync(join(tmpdir(), 'scripts-'));
for (const name of readdirSync(dist).filter((name) => /\.js$/.test(name) && !/^(worker|wasm-text)/.test(name))) copyFileSync(new URL(name, dist), join(scripts, name));
after(() => rmSync(scripts, { recursive: true }));
const lost = Object.fromEntries(readdirSync(scripts).map((name) => [`/lost/${name}`, readFileSync(join(scripts, name), 'utf8')]));
const sample = readFileSync(new URL('samples/3rps.json', dist), 'utf8');

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

/** A page beside the scripts, with the two files in another folder, and what it asked for of them. */
async function pageWith(head, body = '') {
  const site = await serve({
    ...lost,
    '/configure.js': 'import { configure } from "/lost/index.js"; configure({ wasm: "files/synthetica.wasm", worker: new URL("/files/worker.js", location.href) });',
    '/sub/page.html': course(head, body),
    '/sub/files/': dist,
    '/files/': dist,
  });
  after(() => site.close());
  const { page, problems, requests } = await open(browser, `${site.address}/sub/page.html`);
  const files = () => requests.map((address) => address.replace(site.address, '')).filter((path) => /\/worker\.js$|\.wasm$/.test(path));
  return { page, problems, files };
}

test('an element and a program plan in workers from where they were said to be, relative to the page; nothing else is asked for', async () => {
  const { page, problems, files } = await pageWith('<script type="module">import "/configure.js"; import "/lost/element.js"; import { plan } from "/lost/index.js"; window.plan = plan;</script>', '<synthetica-linkage type="3RPS" controls></synthetica-linkage>');
  await page.waitForFunction(() => document.querySelector('synthetica-linkage').trajectory);
  assert.equal(await page.evaluate(async (text) => (await window.plan(text)).frames, sample), 129);
  assert.deepEqual(page.workers().map((worker) => new URL(worker.url()).pathname), ['/files/worker.js', '/files/worker.js']);
  assert.deepEqual([...new Set(files())].sort(), ['/files/worker.js', '/sub/files/synthetica.wasm']);
  assert.deepEqual(problems, []);
});

test('without it the files are not found there, which a question says', async () => {
  const { page } = await pageWith('');
  assert.equal(await page.evaluate(async (text) => (await import('/lost/index.js')).plan(text).catch(({ name }) => name), sample), 'PlannerNotLoaded');
});

for (const [what, code] of [
  ['bytes', '(await (await fetch("/files/synthetica.wasm")).arrayBuffer())'],
  ['a view of bytes', 'new Uint8Array(await (await fetch("/files/synthetica.wasm")).arrayBuffer())'],
  ['a Response', '(await fetch("/files/synthetica.wasm"))'],
  ['a module', '(await WebAssembly.compileStreaming(fetch("/files/synthetica.wasm")))'],
]) {
  test(`the wasm may be ${what}`, async () => {
    const { page, problems, files } = await pageWith('');
    const frames = await page.evaluate(
      `(async () => { const { configure, open, plan } = await import('/lost/index.js'); configure({ wasm: ${code}, worker: '/files/worker.js' }); return [(await plan(${JSON.stringify(sample)})).frames, (await open(${JSON.stringify(sample)})) && 1]; })()`,
    );
    assert.deepEqual(frames, [129, 1]);
    assert.equal(page.workers().length, 1);
    assert.deepEqual(files(), ['/files/synthetica.wasm', '/files/worker.js']);
    assert.deepEqual(problems, []);
  });
}

test('a Response that is none fails the question, and says why', async () => {
  const { page } = await pageWith('');
  const message = await page.evaluate(async (text) => {
    const { configure, plan } = await import('/lost/index.js');
    configure({ wasm: await fetch('/nowhere.wasm'), worker: '/files/worker.js' });
    return plan(text).catch(({ name, message }) => `${name}: ${message}`);
  }, sample);
  assert.match(message, /^PlannerNotLoaded: .*could not be loaded: 404/);
});

test('from another origin, where the worker is started by one of the page’s own', async () => {
  const other = await serve({ '/': dist }, { 'access-control-allow-origin': '*' });
  after(() => other.close());
  const { page, problems } = await pageWith('');
  const frames = await page.evaluate(
    async ([text, address]) => {
      const { configure, plan } = await import('/lost/index.js');
      configure({ wasm: `${address}/synthetica.wasm`, worker: `${address}/worker.js` });
      return (await plan(text)).frames;
    },
    [sample, other.address],
  );
  assert.equal(frames, 129);
  assert.match(page.workers()[0].url(), /^blob:/);
  assert.deepEqual(problems, []);
});

/** Runs a program beside the scripts; gives its lines. @param {string} code */
const run = (code) => execFileSync('node', ['--input-type=module', '-e', `import { configure, plan } from './index.node.js'; const sample = ${JSON.stringify(sample)}; let threads = 0; process.on('worker', () => (threads += 1)); ${code}`], { cwd: scripts, encoding: 'utf8' }).trim().split('\n');
const file = (name) => fileURLToPath(new URL(name, dist));

for (const [what, wasm] of [
  ['a path', JSON.stringify(file('synthetica.wasm'))],
  ['a URL', `new URL(${JSON.stringify(new URL('synthetica.wasm', dist).href)})`],
  ['bytes', `(await import('node:fs')).readFileSync(${JSON.stringify(file('synthetica.wasm'))})`],
  ['a module', `await WebAssembly.compile((await import('node:fs')).readFileSync(${JSON.stringify(file('synthetica.wasm'))}))`],
]) {
  test(`in Node the wasm may be ${what}; the worker’s file is a path or a URL`, () => {
    for (const worker of [JSON.stringify(file('worker.node.js')), `new URL(${JSON.stringify(new URL('worker.node.js', dist).href)})`]) {
      assert.deepEqual(run(`configure({ wasm: ${wasm}, worker: ${worker} }); console.log((await plan(sample)).frames, threads);`), ['129 1']);
    }
    // On the thread that asks, where there is no worker.
    assert.deepEqual(run(`configure({ wasm: ${wasm} }); console.log((await plan(sample)).frames);`), ['129']);
  });
}

test('too late, or of the wrong kind, it says so', () => {
  const said = (code) => run(`try { ${code} } catch (error) { console.log(error.name, error.message); }`)[0];
  assert.match(said(`configure({ wasm: ${JSON.stringify(file('synthetica.wasm'))} }); await plan(sample); configure({ worker: 'x' });`), /^Error configure was called after the first question .*Accepted: a call before the first question/);
  assert.match(said('configure();'), /^TypeError The argument of configure is undefined\. Accepted: an object with wasm, worker\./);
  assert.match(said('configure({ wams: "x" });'), /^TypeError configure: wams is unknown\. Accepted: wasm, worker\./);
  assert.match(said('configure({ wasm: 5 });'), /^TypeError configure: wasm is the number 5\. Accepted: an address .*bytes.*Response.*Module/);
  assert.match(said('configure({ worker: new Uint8Array(4) });'), /^TypeError configure: worker is an object \(Uint8Array\)\. Accepted: an address/);
});

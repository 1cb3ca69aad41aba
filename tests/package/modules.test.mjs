// The package's modules from plain servers, without a bundler.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { alive, course, dist, open, openBrowser, serve } from './site.mjs';

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

const serving = async (...site) => {
  const server = await serve(...site);
  after(() => server.close());
  return server.address;
};

test('a module script; worker and wasm lie beside it', async () => {
  const address = await serving({ '/course.html': course('<script type="module" src="/some/folder/element.js"></script>'), '/some/folder/': dist });
  const { page, problems, requests } = await open(browser, `${address}/course.html`);
  assert.equal(await alive(page), 129);
  assert.equal(page.workers().length, 1);
  assert.equal(page.workers()[0].url(), `${address}/some/folder/worker.js`);
  assert.ok(requests.includes(`${address}/some/folder/synthetica.wasm`));
  assert.match(await page.evaluate(() => document.querySelector('synthetica-linkage').toCSV()), /^frame,/);
  assert.deepEqual(problems, []);
});

test('the pages of the README live', async () => {
  const pages = [...readFileSync(new URL('README.md', dist), 'utf8').matchAll(/```html\n([\s\S]*?)```/g)].map(([, html]) => html);
  assert.equal(pages.length, 2);
  const address = await serving({ '/0.html': course('', pages[0]), '/1.html': course('', pages[1]), '/node_modules/synthetica/': dist });
  for (const name of ['0.html', '1.html']) {
    const { page, problems } = await open(browser, `${address}/${name}`);
    assert.equal(await alive(page), 129);
    assert.deepEqual(problems, []);
  }
});

test('from another origin, planned in a worker too', async () => {
  const other = await serving({ '/': dist }, { 'access-control-allow-origin': '*' });
  const address = await serving({ '/course.html': course(`<script type="module" src="${other}/element.js"></script>`) });
  const { page, problems } = await open(browser, `${address}/course.html`);
  assert.equal(await alive(page), 129);
  assert.equal(page.workers().length, 1);
  assert.match(page.workers()[0].url(), /^blob:/);
  assert.deepEqual(problems, []);
});

test('under a strict content policy, without a single violation', async () => {
  const policy = "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; connect-src 'self'; worker-src 'self'; img-src 'self' data:";
  const address = await serving(
    {
      '/course.html': course('<script type="module" src="/element.js"></script>', '<synthetica-linkage type="3RPS" controls panels="mechanism motion teach types info charts algorithm"></synthetica-linkage>'),
      '/': dist,
    },
    { 'content-security-policy': policy },
  );
  const { page, problems } = await open(browser, `${address}/course.html`);
  assert.equal(await alive(page), 129);
  assert.equal(page.workers().length, 1);
  for (const name of ['Motion', 'Teach', 'Types', 'Charts', 'Algorithm']) await page.getByRole('tab', { name, exact: true }).click();
  await page.getByRole('button', { name: 'Play', exact: true }).click();
  await page.waitForFunction(() => document.querySelector('synthetica-linkage').frame > 1);
  assert.equal(await page.evaluate(async () => (await document.querySelector('synthetica-linkage').toImage()).type), 'image/png');
  assert.deepEqual(problems, []);
});

test('the functions in a browser: a motion, a fault with its place, and an end when it is asked for', async () => {
  const address = await serving({ '/course.html': course('', ''), '/': dist });
  const { page, problems } = await open(browser, `${address}/course.html`);
  const answers = await page.evaluate(async () => {
    const { plan, DocumentFault } = await import('/index.js');
    const document = await (await fetch('/samples/3rps.json')).json();
    const motion = await plan(document);
    const fault = await plan({ ...document, version: 2 }).catch((error) => error);
    const ended = new AbortController();
    // The paper's own method takes a minute and more for this.
    const long = plan({ ...document, motion: { ...document.motion, frames: 10_000 }, planner: { method: 'gradient' } }, { signal: ended.signal }).catch((error) => error.name);
    const waiting = plan(document, { signal: ended.signal }).catch((error) => error.name);
    ended.abort();
    const after = await plan(document);
    return { rank: motion.report.mobility_rank, timed: motion.milliseconds > 0, fault: fault instanceof DocumentFault && [fault.code, fault.where], ended: [await long, await waiting], after: after.frames };
  });
  assert.deepEqual(answers, { rank: 3, timed: true, fault: ['unknown-version', 'version'], ended: ['AbortError', 'AbortError'], after: 129 });
  assert.deepEqual(problems, []);
});

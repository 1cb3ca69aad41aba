// The package's inline build: one script, by a tag, as a module or in the page itself, that asks for nothing.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { alive, course, dist, open, openBrowser, serve } from './site.mjs';

const script = readFileSync(new URL('inline.js', dist), 'utf8');

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

/** @param {string} head @param {Record<string, string>} [headers] */
async function visit(head, headers) {
  const site = await serve({ '/course.html': course(head), '/inline.js': script }, headers);
  after(() => site.close());
  const { page, problems, requests } = await open(browser, `${site.address}/course.html`);
  const frames = await alive(page);
  return { page, frames, problems, requests: requests.map((address) => address.replace(site.address, '')) };
}

for (const [how, head, asked] of [
  ['a plain script tag', '<script src="/inline.js"></script>', ['/course.html', '/inline.js']],
  ['a module', '<script type="module" src="/inline.js"></script>', ['/course.html', '/inline.js']],
  ['a script in the page', `<script>${script}</script>`, ['/course.html']],
]) {
  test(`${how} is all it needs; the planner has a worker`, async () => {
    const { page, frames, problems, requests } = await visit(head);
    assert.equal(frames, 129);
    assert.deepEqual(requests, asked);
    assert.equal(page.workers().length, 1);
    // What the page's own build asks of a second wasm package is in the one.
    assert.match(await page.evaluate(() => document.querySelector('synthetica-linkage').toCSV()), /^frame,/);
    assert.deepEqual(problems, []);
  });
}

test('as a plain script it leaves the functions of the package', async () => {
  const { page } = await visit('<script src="/inline.js"></script>');
  const names = Object.keys(await import(new URL('index.node.js', dist)));
  assert.deepEqual(await page.evaluate((all) => all.filter((name) => typeof synthetica[name] !== 'function'), [...names, 'SyntheticaLinkage']), []);
  const document = readFileSync(new URL('samples/2tpr.json', dist), 'utf8');
  assert.equal(await page.evaluate(async (text) => (await synthetica.plan(text)).frames, document), 129);
});

test('imported, it gives the functions, and leaves the same in the global', async () => {
  const site = await serve({ '/course.html': course(''), '/inline-module.js': readFileSync(new URL('inline-module.js', dist), 'utf8'), '/inline.js': script });
  after(() => site.close());
  const { page, problems, requests } = await open(browser, `${site.address}/course.html`);
  const text = readFileSync(new URL('samples/2tpr.json', dist), 'utf8');
  const told = await page.evaluate(async (document) => {
    const all = await import('/inline-module.js');
    return { frames: (await all.plan(document)).frames, names: Object.keys(all).sort(), same: Object.keys(all).every((name) => all[name] === globalThis.synthetica[name]), defined: customElements.get('synthetica-linkage') === all.SyntheticaLinkage };
  }, text);
  const names = Object.keys(await import(new URL('index.node.js', dist)));
  assert.deepEqual(told, { frames: 129, names: [...names, 'SyntheticaLinkage'].sort(), same: true, defined: true });
  assert.deepEqual(requests.slice(1).map((address) => address.replace(site.address, '')), ['/inline-module.js', '/inline.js']);
  assert.deepEqual(problems, []);
});

test('where a policy allows scripts and wasm, and nothing else, the page plans by itself', async () => {
  const { page, frames, problems } = await visit('<script src="/inline.js"></script>', { 'content-security-policy': "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'" });
  assert.equal(frames, 129);
  assert.equal(page.workers().length, 0);
  // One worker that does not start may have failed with the network; after two none is tried any more.
  assert.ok(problems.length > 0 && problems.length <= 2, problems.join('\n'));
  for (const problem of problems) assert.match(problem, /worker/i);
});

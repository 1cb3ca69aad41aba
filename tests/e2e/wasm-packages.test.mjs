// Which of the two wasm packages a page loads: the smaller one for what it can, the whole one alone where that is needed first.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readdirSync, readFileSync, statSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { openBrowser } from './browser.mjs';

/** Of the smaller package: bytes after gzip, as scripts/dev.sh counts them. */
const MOST = 110_000;

const assets = new URL('../../www/dist/assets/', import.meta.url);
const [small, whole] = readdirSync(assets)
  .filter((name) => name.endsWith('.wasm'))
  .sort((one, other) => statSync(new URL(one, assets)).size - statSync(new URL(other, assets)).size);

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

for (const [type, more, loaded] of [
  ['3RRS', '', [whole]],
  ['3RRS', 'controls panels="mechanism info"', [whole]],
  ['delta?base=400&amp;platform=50', '', [whole]],
  ['3RPS', 'controls panels="mechanism info"', [small]],
]) {
  test(`<synthetica-linkage type="${type}" ${more}> loads ${loaded.map((name) => (name === small ? 'the smaller' : 'the whole')).join(' and ')} package`, async () => {
    const { page } = await browser.blankPage();
    const asked = [];
    page.context().on('request', (request) => request.url().endsWith('.wasm') && asked.push(request.url().split('/').pop()));
    const address = `${browser.address}one.html`;
    await page.route(address, (route) =>
      route.fulfill({ contentType: 'text/html', body: `<!doctype html><script type="module" src="./element.js"></script><synthetica-linkage type="${type}" ${more}></synthetica-linkage>` }),
    );
    await page.goto(address);
    await page.waitForFunction(() => document.querySelector('synthetica-linkage').trajectory);
    // The tables need what new parts are made of, which is asked for last.
    if (more) await page.locator('[data-path="chains[0].base.x"]').waitFor();
    assert.deepEqual(asked, loaded);
  });
}

test('the smaller package is small', () => {
  const size = execFileSync('gzip', ['-9'], { input: readFileSync(new URL(small, assets)) }).length;
  console.log(`loaded first: ${size} bytes after gzip`);
  assert.ok(size <= MOST, `${size}`);
});

test('the page by itself plans, explains and fills its tables with the smaller package; a pointer over the view fetches the whole one', async () => {
  const { page } = await browser.blankPage({ viewport: { width: 1280, height: 800 }, serviceWorkers: 'block' });
  const asked = [];
  page.context().on('request', (request) => request.url().endsWith('.wasm') && asked.push(request.url().split('/').pop()));
  await page.goto(browser.address);
  await page.waitForFunction(() => (page$('#closure')?.textContent ?? '–') !== '–');
  await page.waitForFunction(() => page$('#why')?.textContent.includes('Freedoms here'));
  await page.waitForLoadState('networkidle');
  assert.deepEqual(asked, [small]);
  const comes = page.waitForRequest(/\.wasm$/);
  await page.locator('#canvas').hover();
  await comes;
  assert.deepEqual(asked, [small, whole]);
});

const plainly = readFileSync(new URL('../../www/mechanisms/3rps.json', import.meta.url), 'utf8');
for (const [about, text, packages, code, words] of [
  // Sound overconstrained linkages have it: another page is not to load four times as much for it.
  ['the mobility in its own words', readFileSync(new URL('../../www/mechanisms/bennett.json', import.meta.url), 'utf8'), [small], 'mobility-differs', /^Counting joints gives −2 degrees of freedom/],
  ['all else in the words of the whole one', plainly.replace('"metric_length": 1', '"metric_length": 1000'), [small, whole], 'metric-length', /1000/],
]) {
  test(`a motion that the smaller package planned is warned of: ${about}`, async () => {
    const { page } = await browser.blankPage();
    const asked = [];
    page.context().on('request', (request) => request.url().endsWith('.wasm') && asked.push(request.url().split('/').pop()));
    const address = `${browser.address}warned.html`;
    await page.route(address, (route) =>
      route.fulfill({ contentType: 'text/html', body: '<!doctype html><script type="module" src="./element.js"></script><synthetica-linkage src="warned.json"></synthetica-linkage>' }),
    );
    await page.route(`${browser.address}warned.json`, (route) => route.fulfill({ contentType: 'application/json', body: text }));
    await page.goto(address);
    const warnings = await page.waitForFunction(() => document.querySelector('synthetica-linkage').trajectory?.report.warnings);
    const [first] = await warnings.jsonValue();
    assert.deepEqual(asked, packages);
    assert.equal(first.code, code);
    assert.match(first.message, words);
  });
}

// Which of the two wasm packages a page loads: the smaller one for what it can, the whole one alone where that is needed first.
import assert from 'node:assert/strict';
import { readdirSync, statSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { openBrowser } from './browser.mjs';

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

// The pages beside the applet, from a plain server, below a folder of its own.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname } from 'node:path';
import { after, before, test } from 'node:test';
import { chromium } from 'playwright-core';
import { createServer as createDevServer } from 'vite';
import { violations } from './axe.mjs';
import { LAUNCH } from './browser.mjs';

const PREFIX = '/some/prefix/';
const TYPES = { '.html': 'text/html', '.css': 'text/css', '.js': 'text/javascript', '.json': 'application/json', '.svg': 'image/svg+xml', '.wasm': 'application/wasm', '.webp': 'image/webp' };
const dist = new URL('../../www/dist/', import.meta.url);
const read = (path) => readFileSync(new URL(`../../${path}`, import.meta.url), 'utf8');
const schema = JSON.parse(read('src/document/schema.json'));
const samples = JSON.parse(read('www/mechanisms/index.json')).map(({ file }) => file);

let server, browser, address, pages;
before(async () => {
  // No header but the type, no answer for what is not there.
  server = createServer((request, response) => {
    const { pathname } = new URL(request.url, 'http://site');
    try {
      const file = pathname.endsWith('/') ? `${pathname}index.html` : pathname;
      assert.ok(file.startsWith(PREFIX));
      const body = readFileSync(new URL(file.slice(PREFIX.length), dist));
      response.setHeader('content-type', TYPES[extname(file)]);
      response.end(body);
    } catch {
      response.statusCode = 404;
      response.end();
    }
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  address = `http://127.0.0.1:${server.address().port}${PREFIX}`;
  browser = await chromium.launch(LAUNCH);
  // Every page is in the navigation of every other.
  const { page } = await open('method.html');
  pages = await page.locator('header nav a').evaluateAll((links) => links.map((link) => link.getAttribute('href')).filter((href) => href !== './'));
  assert.ok(['./gallery.html', './course.html', './method.html', './reference.html'].every((name) => pages.includes(name)), pages.join());
});
after(async () => {
  await browser.close();
  server.close();
});

/** A page of the site, and what it complains about or asks of others. */
async function open(name, options) {
  const page = await (await browser.newContext({ reducedMotion: 'reduce', ...options })).newPage();
  const problems = [];
  // Chromium remarks on its own screenshots of a canvas.
  page.on('console', (message) => ['error', 'warning'].includes(message.type()) && !message.text().includes('GPU stall') && problems.push(message.text()));
  page.on('pageerror', (error) => problems.push(String(error)));
  page.on('request', (request) => /^(data|blob):/.test(request.url()) || request.url().startsWith(address) || problems.push(`asks for ${request.url()}`));
  await page.goto(new URL(name, address).href);
  return { page, problems };
}

test('every link within the site leads somewhere, its fragment too; nothing is asked of other hosts', async () => {
  const ids = new Map();
  const links = new Map();
  for (const name of pages) {
    const { page, problems } = await open(name);
    await page.waitForLoadState('networkidle');
    assert.deepEqual(problems, [], name);
    ids.set(new URL(name, address).pathname, await page.locator('[id]').evaluateAll((all) => all.map(({ id }) => id)));
    for (const href of await page.locator('a').evaluateAll((all) => all.map(({ href }) => href))) links.set(href, name);
    await page.close();
  }
  let within = 0;
  for (const [href, from] of links) {
    const url = new URL(href);
    if (url.origin !== new URL(address).origin) {
      assert.equal(url.protocol, 'https:', href);
      continue;
    }
    within++;
    assert.equal((await fetch(href)).status, 200, `${href} of ${from}`);
    if (url.hash) assert.ok(ids.get(url.pathname)?.includes(decodeURIComponent(url.hash.slice(1))), `${href} of ${from}`);
    if (url.searchParams.has('sample')) assert.ok(samples.includes(url.searchParams.get('sample')), href);
  }
  assert.ok(within > 30);
});

for (const [what, options] of [
  ['on a desktop', { viewport: { width: 1280, height: 800 } }],
  ['on a phone, dark', { viewport: { width: 390, height: 844 }, colorScheme: 'dark' }],
]) {
  test(`axe has no complaint ${what}, and nothing is wider than the window`, async () => {
    for (const name of pages) {
      const { page } = await open(name, options);
      // The tests' own script: the policy of the page is for the page.
      assert.deepEqual(await violations(page), [], name);
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), `${name} fits`);
      const levels = await page.locator('h1, h2, h3, h4').evaluateAll((all) => all.map(({ tagName }) => Number(tagName[1])));
      assert.equal(levels[0], 1);
      levels.forEach((level, i) => assert.ok(level <= (levels[i - 1] ?? 1) + 1 && (level > 1) === i > 0, `${name}: headings ${levels}`));
      // What scrolls on its own can be scrolled from the keyboard.
      const stuck = await page.locator('.scroller').evaluateAll((all) => all.filter((box) => box.scrollWidth > box.clientWidth + 1 && box.tabIndex < 0).map((box) => box.textContent));
      assert.deepEqual(stuck, [], name);
      await page.close();
    }
  });
}

test('the pages are read without scripts, and from the keyboard', async () => {
  for (const name of pages) {
    const { page, problems } = await open(name, { javaScriptEnabled: false });
    assert.ok((await page.locator('main').innerText()).length > 400, name);
    await page.keyboard.press('Tab');
    assert.ok(await page.getByRole('link', { name: 'To the text' }).isVisible(), `${name}: the first stop skips to the text`);
    await page.keyboard.press('Enter');
    assert.equal(new URL(page.url()).hash, '#content');
    assert.deepEqual(problems, []);
    await page.close();
  }
});

test('the formulas of the method are MathML, its equations have addresses', async () => {
  const { page } = await open('method.html');
  assert.ok((await page.locator('main math').count()) > 80);
  assert.equal(await page.getByText(/\$|\\tag|\\begin/).count(), 0, 'no TeX is left');
  for (const number of [7, 15, 21, 28, 29, 31]) await page.locator(`#eq-${number} math[display=block]`).waitFor();
  const drawn = await page.locator('.equation math').evaluateAll((all) => all.every((math) => math.getBoundingClientRect().width > 20));
  assert.ok(drawn);
});

test('schema and samples are where programs may count on them', async () => {
  const get = async (path) => (await fetch(address + path)).json();
  const published = await get('schema/document-1.json');
  assert.deepEqual(published, schema);
  assert.equal(published.$id, schema.$id);
  assert.ok(schema.$id);
  for (const file of samples) assert.deepEqual(await get(`mechanisms/${file}`), JSON.parse(read(`www/mechanisms/${file}`)));
});

test('the reference has every field of a document, and the whole document in it plans', async () => {
  const { page } = await open('reference.html');
  for (const [name, part] of [['Document', schema], ...Object.entries(schema.$defs)]) {
    if (!part.properties) continue;
    const fields = await page.locator(`#fields-${name} tbody th`).allTextContents();
    assert.deepEqual(fields.sort(), Object.keys(part.properties).sort(), name);
  }
  const document = await page.locator('code.language-json').first().textContent();
  const applet = await open('./');
  await applet.page.locator('#closure').filter({ hasText: /\d/ }).waitFor({ state: 'attached' });
  await applet.page.locator('#file').setInputFiles({ name: 'whole.json', mimeType: 'application/json', buffer: Buffer.from(document) });
  await applet.page.waitForFunction(() => window.document.querySelector('synthetica-linkage').shadowRoot.querySelectorAll('#chain-rows tr').length === 1);
  await applet.page.locator('#frame-word', { hasText: 'Reached' }).waitFor();
  assert.deepEqual(applet.problems, []);
});

test('the reference has every function of the package', async () => {
  const { page } = await open('reference.html');
  const named = (await page.locator('main td:first-child code').allTextContents()).map((text) => text.replace(/\(.*/, ''));
  const functions = [...read('www/planner/api.js').matchAll(/^export (?:async )?function (\w+)/gm)].map(([, name]) => name);
  assert.ok(functions.includes('plan'));
  for (const name of functions) assert.ok(named.includes(name), name);
});

test('the reference has every attribute, property, part and event of the element', async () => {
  const { page } = await open('course.html');
  const names = await page.evaluate(() => {
    const { observedAttributes, prototype } = customElements.get('synthetica-linkage');
    const own = [prototype, Object.getPrototypeOf(prototype)].flatMap((one) => Object.getOwnPropertyNames(one));
    return [...observedAttributes, ...own.filter((name) => name !== 'constructor' && !name.endsWith('Callback'))];
  });
  assert.ok(names.includes('src') && names.includes('currentTime'));
  const parts = [...read('www/element/canvas-area.html').matchAll(/part="(\w+)"/g)].map(([, part]) => part);
  const events = [...read('www/element/events.js').matchAll(/tell\('(\w+)'/g)].map(([, name]) => name);
  assert.ok(parts.length && events.length);
  await page.goto(`${address}reference.html`);
  const said = new Set((await page.locator('main code').allTextContents()).flatMap((code) => code.match(/[\w-]+/g) ?? []));
  // For the applet, which is built around the element.
  const inner = ['workbench', 'linkage'];
  for (const name of [...names, ...parts, ...events]) assert.ok(inner.includes(name) || said.has(name), name);
});

test('the reference of frames names all that they say and obey, and its script does what it says', async () => {
  const { page } = await open('reference.html');
  const said = new Set((await page.locator('main code').allTextContents()).flatMap((code) => code.match(/[\w-]+/g) ?? []));
  const protocol = read('www/embed/protocol.js');
  const lists = [/CHANGEABLE = .*?\[(.*?)\]/, /NAMES = \[(.*?)\]/].map((list) => (protocol + read('www/embed/address.js')).match(list)[1].match(/\w+/g));
  const told = [...protocol.matchAll(/(?:send|tell)\('(\w+)'/g)].map(([, name]) => name);
  assert.ok(told.includes('ready') && lists.every(({ length }) => length > 5));
  for (const name of [...told, ...lists.flat()]) assert.ok(said.has(name), name);

  const codes = await page.locator('#frames ~ pre code').allTextContents();
  const [frame, script] = [codes.find((code) => code.startsWith('<iframe')), codes.find((code) => code.includes('linkageFrame'))];
  const around = `<!doctype html><html lang="en"><title>Around</title><body>${frame}<script type="module">${script}</script></body></html>`;
  await page.route(`${address}around.html`, (route) => route.fulfill({ contentType: 'text/html', body: around }));
  const last = page.waitForEvent('console', (message) => message.text() === '128 true');
  await page.goto(`${address}around.html`);
  await last;
});

test('the gallery shows every sample and opens it in the applet', async () => {
  const { page } = await open('gallery.html');
  assert.equal(await page.locator('.samples li').count(), samples.length);
  for (const picture of await page.locator('.samples img').all()) {
    await picture.scrollIntoViewIfNeeded();
    await picture.evaluate((image) => image.decode());
  }
  await page.getByRole('link', { name: 'Open 2TPR in the applet' }).click();
  await page.waitForFunction(() => document.querySelector('#document-name')?.textContent === '2TPR');
});

test('the linkages of the course are alive, and move as its text says', async () => {
  const { page, problems } = await open('course.html', { viewport: { width: 1000, height: 700 } });
  const linkages = await page.locator('synthetica-linkage').all();
  assert.equal(linkages.length, 3);
  const found = [];
  for (const linkage of linkages) {
    await linkage.scrollIntoViewIfNeeded();
    await linkage.getByRole('button', { name: 'Play' }).waitFor();
    await page.waitForFunction((element) => element.trajectory !== null, await linkage.elementHandle());
    found.push(
      await linkage.evaluate(({ trajectory: { report, translation_gap, rotation_gap } }) => ({
        count: report.mobility_count,
        rank: report.mobility_rank,
        gap: `${Math.max(...translation_gap).toFixed(3)} m and ${((Math.max(...rotation_gap) * 180) / Math.PI).toFixed(1)}°`,
      })),
    );
  }
  assert.deepEqual(found.map(({ count, rank }) => [count, rank]), [[3, 3], [-2, 1], [2, 2]]);
  assert.ok((await page.locator('main').innerText()).includes(`up to ${found[0].gap}`), found[0].gap);
  await linkages[2].getByRole('button', { name: 'Play' }).click();
  await page.waitForFunction((element) => element.frame > 0, await linkages[2].elementHandle());
  await linkages[2].getByRole('button', { name: 'Pause' }).click();
  assert.deepEqual(await violations(page), []);
  assert.deepEqual(problems, []);
});

test('the development server has the pages, the schema and the samples', async () => {
  const dev = await createDevServer({ configFile: 'tools/vite.config.js', server: { port: 0 }, optimizeDeps: { noDiscovery: true } });
  try {
    await dev.listen();
    const [at] = dev.resolvedUrls.local;
    for (const name of pages) assert.match(await (await fetch(new URL(name, at))).text(), /<main[^]*<h1/, name);
    assert.equal((await (await fetch(`${at}schema/document-1.json`)).json()).$id, schema.$id);
    assert.ok((await (await fetch(`${at}mechanisms/3rps.json`)).json()).chains);
    // What the share dialog names there is there too.
    assert.match(await (await fetch(`${at}frame.js`)).text(), /host\.js/);
    const page = await browser.newPage();
    for (const script of ['<script type="module" src="./element.js">', '<script src="./inline.js">']) {
      await page.route(`${at}pasted.html`, (route) => route.fulfill({ contentType: 'text/html', body: `${script}</script><synthetica-linkage type="2TPR"></synthetica-linkage>` }));
      await page.goto(`${at}pasted.html`);
      await page.waitForFunction(() => document.querySelector('synthetica-linkage')?.trajectory?.frames === 129);
      await page.unroute(`${at}pasted.html`);
    }
  } finally {
    await dev.close();
  }
});

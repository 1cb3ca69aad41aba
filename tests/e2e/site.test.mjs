// The pages beside the applet, from a plain server, below a folder of its own.
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { chromium } from 'playwright-core';
import { createServer as createDevServer } from 'vite';
import { serve } from '../package/site.mjs';
import { violations } from './axe.mjs';
import { LAUNCH } from './browser.mjs';

const PREFIX = '/some/prefix/';
const dist = new URL('../../www/dist/', import.meta.url);
const read = (path) => readFileSync(new URL(`../../${path}`, import.meta.url), 'utf8');
const schema = JSON.parse(read('src/document/schema.json'));
const samples = JSON.parse(read('www/mechanisms/index.json')).map(({ file }) => file);

let server, browser, address, pages, parts;
before(async () => {
  server = await serve({ [PREFIX]: dist });
  address = `${server.address}${PREFIX}`;
  browser = await chromium.launch(LAUNCH);
  // Every page is in the navigation of every other.
  const { page } = await open('reference-document.html');
  const linked = (within) => page.locator(within).evaluateAll((links) => links.map((link) => link.getAttribute('href')).filter((href) => href !== './'));
  parts = await linked('nav[aria-label="Parts of the reference"] a');
  pages = [...(await linked('header nav a')), ...parts];
  assert.ok(['gallery', 'course', 'method', 'reference', 'get'].every((name) => pages.includes(`./${name}.html`)), pages.join());
  assert.equal(parts.length, readdirSync(new URL('../../www/pages/reference/', import.meta.url)).length);
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
    await page.waitForURL(/#content$/);
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
  const { page } = await open('reference-document.html');
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
  const { page } = await open('reference-javascript.html');
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
  await page.goto(`${address}reference-element.html`);
  const said = new Set((await page.locator('main code').allTextContents()).flatMap((code) => code.match(/[\w-]+/g) ?? []));
  // For the applet, which is built around the element.
  const inner = ['workbench', 'linkage'];
  for (const name of [...names, ...parts, ...events]) assert.ok(inner.includes(name) || said.has(name), name);
});

test('the reference of frames names all that they say and obey, and its script does what it says', async () => {
  const { page } = await open('reference-frames.html');
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

test('the parts of the reference lead to each other, and old addresses to what they were of', async () => {
  const { page } = await open('reference.html');
  for (const part of parts) assert.ok((await page.locator(`main h2 a[href^="${part}#"]`).count()) === 1, part);
  await page.getByRole('link', { name: 'Turn of a frame' }).click();
  assert.match(page.url(), /reference-tables\.html#turn-of-a-frame$/);
  const now = page.getByRole('navigation', { name: 'Parts of the reference' }).locator('[aria-current=page]');
  assert.equal(await now.textContent(), 'Tables');
  await page.getByRole('link', { name: /^Next: / }).click();
  assert.equal(await now.textContent(), 'Element');
  await page.getByRole('link', { name: 'Before: Tables' }).click();
  assert.equal(await page.getByRole('navigation', { name: 'Site' }).getByText('Reference').getAttribute('aria-current'), 'true');
  // As they stood in links while the reference was one page.
  for (const [id, name] of Object.entries({
    row: 'document', 'expressions-and-parameters': 'document', 'fields-RowEntry': 'document', 'unit-of-length': 'tables',
    element: 'element', attributes: 'element', javascript: 'javascript', frames: 'frames', messages: 'frames', 'command-line': 'command-line',
  })) {
    await page.goto(`${address}reference.html#${id}`);
    await page.waitForURL(`${address}reference-${name}.html#${id}`);
    await page.locator(`main [id="${id}"]`).waitFor();
    const plain = await open(`reference.html#${id}`, { javaScriptEnabled: false });
    await plain.page.locator('a:target').click();
    assert.equal(plain.page.url(), `${address}reference-${name}.html#${id}`, 'without scripts it is the link there');
    await plain.page.context().close();
  }
});

test('on a phone a row of a table is a block that says its columns, and nothing scrolls sideways', async () => {
  for (const name of pages) {
    const { page } = await open(name, { viewport: { width: 390, height: 844 } });
    const wrong = await page.locator('main table').evaluateAll((tables) =>
      tables.filter((table) => {
        const box = table.closest('.scroller') ?? table;
        const [cell, ...others] = table.querySelectorAll('tbody tr:first-child > *');
        const below = others.filter((other) => other.offsetHeight).every((other, i, all) => other.getBoundingClientRect().top >= (all[i - 1] ?? cell).getBoundingClientRect().bottom - 1);
        const named = others.every((other) => !other.offsetHeight || getComputedStyle(other, '::before').content.includes(other.dataset.column));
        return box.scrollWidth > box.clientWidth || !below || !named;
      }).map((table) => table.innerText.slice(0, 80)),
    );
    assert.deepEqual(wrong, [], name);
    // Rows and columns as before to who does not see them.
    if (await page.locator('main table').count()) {
      assert.ok((await page.getByRole('table').count()) > 0 && (await page.getByRole('columnheader').count()) > 1 && (await page.getByRole('cell').count()) > 1, name);
    }
    await page.context().close();
  }
});

test('wordmark and headings have one typeface, here and in the applet', async () => {
  const family = (locator) => locator.evaluate((element) => getComputedStyle(element).fontFamily);
  const { page } = await open('gallery.html');
  const [wordmark, heading, second] = await Promise.all(['header .home', 'main h1', 'main h3'].map((place) => family(page.locator(place).first())));
  const applet = await open('./');
  assert.equal(await family(applet.page.locator('header h1')), wordmark);
  assert.deepEqual([heading, second], [wordmark, wordmark]);
});

test('other sites are told title, sentence and picture of every page', async () => {
  const seen = new Set();
  for (const name of ['./', ...pages]) {
    const { page } = await open(name, { javaScriptEnabled: false });
    const told = (property) => page.locator(`meta[property="og:${property}"]`).getAttribute('content');
    const [title, description, image] = [await told('title'), await told('description'), await told('image')];
    assert.equal(title, await page.title());
    assert.equal(description, await page.locator('meta[name=description]').getAttribute('content'));
    assert.equal(await page.locator('meta[name="twitter:card"]').getAttribute('content'), 'summary_large_image');
    seen.add(title).add(description);
    const picture = new URL(image, page.url()).href;
    assert.equal((await fetch(picture)).headers.get('content-type'), 'image/jpeg', picture);
    await page.goto(picture);
    assert.deepEqual(await page.locator('img').evaluate((shown) => [shown.naturalWidth, shown.naturalHeight]), [1200, 630]);
    await page.context().close();
  }
  assert.equal(seen.size, 2 * (pages.length + 1), 'each its own');
  // They are for other sites: a reader's browser keeps every page, and not them.
  const kept = readFileSync(new URL('service-worker.js', dist), 'utf8');
  assert.ok(pages.every((name) => kept.includes(JSON.stringify(name))) && kept.includes('"./licences.txt"') && !kept.includes('cards/'));
});

test('the codes of the gallery work in pages of another origin', async () => {
  const { page } = await open('gallery.html', { permissions: ['clipboard-read', 'clipboard-write'] });
  assert.equal(await page.locator('.samples .embed').count(), samples.length);
  const card = page.locator('.samples li', { has: page.getByRole('heading', { name: 'Agile eye', exact: true }) });
  await card.locator('summary').click();
  const codes = {};
  for (const what of ['Frame', 'Element']) {
    await card.getByRole('button', { name: `Copy ${what} of Agile eye` }).click();
    await card.getByText('Copied.').first().waitFor();
    codes[what] = await page.evaluate(() => navigator.clipboard.readText());
    assert.ok(codes[what].includes(`"${address}`), codes[what]);
  }
  assert.deepEqual(await violations(page), []);
  const pageWith = (code) => `<!doctype html><title>Other</title>${code}`;
  const around = await serve({ '/frame.html': pageWith(codes.Frame), '/element.html': pageWith(codes.Element) });
  after(() => around.close());
  const other = await browser.newPage();
  await other.goto(`${around.address}/element.html`);
  await other.waitForFunction(() => document.querySelector('synthetica-linkage').trajectory?.frames > 1);
  await other.goto(`${around.address}/frame.html`);
  const frame = await (await other.locator('iframe').elementHandle()).contentFrame();
  await frame.waitForFunction(() => document.querySelector('synthetica-linkage')?.trajectory?.frames > 1);
  assert.match(await frame.evaluate(() => document.querySelector('synthetica-linkage').document.name), /agile eye/i);
});

test('the files that the page How to get it names suffice for what they are for', async () => {
  const { page } = await open('get.html');
  const rows = await page.locator('#files ~ div table').first().locator('tbody tr').evaluateAll((all) => all.map((row) => [...row.querySelectorAll('td:first-child code')].map((code) => code.textContent)));
  const bodies = { 'inline.js': '<script src="inline.js"></script><synthetica-linkage type="2TPR"></synthetica-linkage>', 'element.js': '<script type="module" src="element.js"></script><synthetica-linkage type="2TPR"></synthetica-linkage>', 'embed.html': '' };
  for (const [first, body] of Object.entries(bodies)) {
    const files = rows.find(([name]) => name === first);
    assert.ok(files, `${first} in ${rows}`);
    const context = await browser.newContext({ serviceWorkers: 'block' });
    const there = await context.newPage();
    await there.route(`${address}**`, (route) => {
      const path = new URL(route.request().url()).href.slice(address.length).replace(/[?#].*/, '');
      if (path === 'own.html') return route.fulfill({ contentType: 'text/html', body: `<!doctype html><title>Own</title>${body}` });
      return files.some((file) => path === file || (file.endsWith('/') && path.startsWith(file))) ? route.continue() : route.abort();
    });
    await there.goto(`${address}${body ? 'own.html' : 'embed.html?sample=2tpr.json'}`);
    await there.waitForFunction(() => document.querySelector('synthetica-linkage')?.trajectory?.frames === 129);
    await context.close();
  }
});

test('the method names tests that are there, with the bounds that they have', async () => {
  const { page } = await open('method.html');
  const rows = await page.locator('#what-the-tests-hold-it-to + div tbody tr').evaluateAll((all) =>
    all.map((row) => ({ powers: [...row.cells[1].querySelectorAll('msup')].map((power) => power.lastElementChild.textContent.replace('−', '-')), codes: [...row.cells[2].querySelectorAll('code')].map((code) => code.textContent) })),
  );
  assert.ok(rows.length >= 8);
  const closed = read('src/model/scaled.rs').match(/const CLOSED: f64 = (\S+);/)[1];
  for (const { powers, codes: [name, file] } of rows) {
    const text = read(file);
    const [, body] = text.match(new RegExp(`fn ${name}\\b([^]*?)\\n}\\n`)) ?? [];
    assert.ok(body, `${name} in ${file}`);
    const asked = [...body.matchAll(/\b[A-Z_]{4,}\b/g)].map(([constant]) => (constant === 'CLOSED' ? closed : text.match(new RegExp(`const ${constant}: f64 = (\\S+);`))?.[1]));
    for (const power of powers) assert.ok(body.includes(`1e${power}`) || asked.includes(`1e${power}`), `${name} has the bound 1e${power}`);
  }
  assert.ok(rows.filter(({ powers }) => powers.length).length >= 6);
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

test('the course is scrolled past its linkages, which are loaded when they come near', async () => {
  const { page } = await open('course.html', { viewport: { width: 1000, height: 700 } });
  const linkages = page.locator('synthetica-linkage');
  assert.deepEqual(await linkages.evaluateAll((all) => all.map(({ interaction, loading }) => [interaction, loading])), Array(3).fill(['ctrl', 'lazy']));
  const first = linkages.first();
  await first.scrollIntoViewIfNeeded();
  await page.waitForFunction(() => document.querySelector('synthetica-linkage').trajectory);
  assert.deepEqual(await linkages.evaluateAll((all) => all.map(({ trajectory }) => trajectory !== null)), [true, false, false]);
  const box = await first.boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 3);
  const from = await page.evaluate(() => scrollY);
  await page.mouse.wheel(0, 200);
  await page.waitForFunction((before) => scrollY > before + 150, from);
});

test('on paper every linkage of the course is a picture, also one that was never seen', async () => {
  const { page } = await open('course.html', { viewport: { width: 1000, height: 700 } });
  await page.waitForFunction(() => document.querySelector('synthetica-linkage').trajectory);
  await page.locator('#canvas[data-draws]').first().waitFor();
  await page.emulateMedia({ media: 'print' });
  const drawn = [];
  for (const linkage of await page.locator('synthetica-linkage').all()) {
    const picture = linkage.locator('.poster, #canvas[data-draws]').filter({ visible: true }).first();
    await picture.waitFor();
    const { width, height } = await picture.boundingBox();
    assert.ok(width > 200 && height > 120, `${width} × ${height}`);
    drawn.push(await picture.evaluate((shown) => (shown instanceof HTMLImageElement ? shown.decode().then(() => shown.src) : null)));
  }
  // The first is near the view, and draws itself; those further down were never loaded.
  assert.deepEqual(drawn.slice(1), ['four-bar', '2tpr'].map((name) => `${address}thumbnails/${name}.webp`));
  assert.equal(await page.locator('header.site, .contents').filter({ visible: true }).count(), 0);
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

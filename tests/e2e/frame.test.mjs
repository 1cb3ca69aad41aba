// The page for frames in somebody else's page: from another origin, in a sandbox, and what both say to each other.
import assert from 'node:assert/strict';
import { mkdtempSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { serve } from '../package/site.mjs';
import { violations } from './axe.mjs';
import { openBrowser } from './browser.mjs';

let browser;
let server;
/** The origin of the page around the frame. */
let around;
/** What it serves. */
const files = {};
before(async () => {
  browser = await openBrowser();
  server = await serve(files);
  around = server.address;
});
after(async () => {
  server.close();
  await browser.close();
});

/** A page with a frame in it, whose messages are kept in `heard`. */
async function pageAround(query, { attributes = '', referrer = '' } = {}) {
  files['/page.html'] = `<!doctype html><html lang="en"><title>Around</title>${referrer}<body><script>
      window.heard = [];
      addEventListener('message', ({ data, source }) => heard.push({ ...data, fromFrame: source === document.querySelector('iframe').contentWindow }));
    </script><iframe src="${browser.address}${query}" width="700" height="420" ${attributes}></iframe></body></html>`;
  const { page, problems } = await browser.blankPage();
  await page.goto(`${around}/page.html`);
  return { page, problems, frame: page.frameLocator('iframe') };
}

/** The number of the shown frame, all of it: “2 / 129” is in “42 / 129” too. */
const atFrame = (frame, text) => frame.locator('#frame-number', { hasText: new RegExp(`^${text}$`) }).waitFor();

const heard = (page, type) => page.waitForFunction((wanted) => window.heard.findLast((message) => message.type === wanted), type).then((found) => found.jsonValue());
const send = (page, message) => page.evaluate((one) => document.querySelector('iframe').contentWindow.postMessage(one, '*'), message);

test('tells its parent that it is ready, its document, its state and its height, in version 1', async () => {
  const { page } = await pageAround('embed.html?sample=2tpr');
  assert.deepEqual(await heard(page, 'ready'), { synthetica: 1, type: 'ready', version: 1, fromFrame: true });
  assert.equal((await heard(page, 'document')).document.name, '2TPR');
  const { state } = await heard(page, 'state');
  assert.deepEqual([state.frame, state.frames, state.paused, state.ended, state.loop, state.bounce, state.interaction], [0, 129, true, false, false, false, 'ctrl']);
  const { height } = await heard(page, 'height');
  assert.ok(height > 420 && height < 700, `${height}`);
});

test('shows what its parent says, and answers what it asks', async () => {
  const { page, frame } = await pageAround('embed.html?sample=2tpr');
  const { document } = await heard(page, 'document');
  await send(page, { synthetica: 1, type: 'state', state: { frame: 40, speed: 2, view: 'top', bounce: true, interaction: 'none' } });
  await atFrame(frame, '41 / 129');
  await page.waitForFunction(() => window.heard.some(({ type, state }) => type === 'state' && state.frame === 40 && state.speed === 2 && state.view === 'top' && state.bounce && state.interaction === 'none'));
  // Pages that were written when `loop` said how are understood.
  await send(page, { synthetica: 1, type: 'state', state: { frame: 120, loop: 'once', speed: 10, paused: false } });
  await page.waitForFunction(() => window.heard.some(({ type, state }) => type === 'state' && state.ended && state.frame === 128 && !state.bounce));
  await send(page, { synthetica: 1, type: 'get', what: 'trajectory', id: 7 });
  const answer = await page.waitForFunction(() => window.heard.find(({ id }) => id === 7));
  assert.equal(await answer.evaluate(({ type, trajectory }) => type === 'trajectory' && trajectory.closure.length), 129);
  assert.ok(await answer.evaluate(({ trajectory }) => trajectory.joints instanceof Float64Array));
  await send(page, { synthetica: 1, type: 'document', document: { ...document, name: 'Sent' } });
  await page.waitForFunction(() => window.heard.some(({ type, document: shown }) => type === 'document' && shown.name === 'Sent'));
});

test('refuses in words what it does not know', async () => {
  const { page } = await pageAround('embed.html?sample=2tpr');
  await heard(page, 'ready');
  for (const [message, words] of [
    [{ synthetica: 2, type: 'get', id: 1 }, /version 1, not 2/],
    [{ synthetica: 1, type: 'get', what: 'secrets', id: 2 }, /no “secrets”.*document, trajectory, state, height/],
    [{ synthetica: 1, type: 'dance', id: 3 }, /no message of type “dance”/],
    [{ synthetica: 1, type: 'state', state: { speed: 'fast' }, id: 4 }, /speed is “fast”/],
  ]) {
    await send(page, message);
    const error = await page.waitForFunction((wanted) => window.heard.find(({ id, type }) => id === wanted && type === 'error'), message.id);
    assert.match((await error.jsonValue()).error.message, words);
  }
  await send(page, { synthetica: 1, type: 'document', document: { version: 1 } });
  await page.waitForFunction(() => window.heard.some(({ type, error }) => type === 'error' && /chains/.test(error.message)));
});

test('an origin in the address must be the parent’s: nobody else hears a document or is obeyed', async () => {
  const { page, frame } = await pageAround('embed.html?sample=2tpr&origin=https://other.example');
  await atFrame(frame, '1 / 129');
  await send(page, { synthetica: 1, type: 'state', state: { frame: 40 } });
  await send(page, { synthetica: 1, type: 'get', what: 'document', id: 1 });
  await frame.locator('#scrub').press('ArrowRight');
  await atFrame(frame, '2 / 129');
  assert.deepEqual(await page.evaluate(() => window.heard), []);
});

test('a document, a state and a question of a parent of another origin than the address names change nothing', async () => {
  const { page, frame } = await pageAround(`embed.html?sample=2tpr&origin=${encodeURIComponent('https://other.example')}`);
  await atFrame(frame, '1 / 129');
  for (const message of [{ type: 'document', document: { version: 1 } }, { type: 'state', state: { frame: 40, view: 'top' } }, { type: 'hello' }]) await send(page, { synthetica: 1, ...message });
  const seen = await page.frames()[1].evaluate(() => new Promise((resolve) => {
    // Messages come in turn: what was sent before has been dealt with.
    addEventListener('message', ({ data }) => data === 'last' && requestAnimationFrame(() => resolve({ frame: document.querySelector('synthetica-linkage').frame, view: document.querySelector('synthetica-linkage').view, error: document.querySelector('synthetica-linkage').error })));
    window.postMessage('last', '*');
  }));
  assert.deepEqual(seen, { frame: 0, view: '', error: null });
  assert.deepEqual(await page.evaluate(() => window.heard), []);
});

test('the content policy allows what a frame needs and nothing else, and the browser holds to it', async () => {
  const { page, problems } = await browser.blankPage({ viewport: { width: 1200, height: 800 } });
  // Panels, a worker, a document from the site: nothing of the frame breaks it.
  await page.goto(`${browser.address}embed.html?src=mechanisms/2tpr.json&panels=info+charts`);
  await page.locator('.uplot').first().waitFor();
  const policy = await page.locator('meta[http-equiv="Content-Security-Policy"]').getAttribute('content');
  assert.deepEqual(policy.split('; '), [
    "default-src 'none'",
    "script-src 'self' 'wasm-unsafe-eval'",
    'worker-src blob:',
    "connect-src 'self'",
    "style-src 'self'",
    "img-src 'self' data:",
    "base-uri 'none'",
    "form-action 'none'",
  ]);
  assert.equal(page.workers().length, 1);
  assert.deepEqual(problems, []);
  const attempts = [
    ['script-src-elem', () => document.body.append(Object.assign(document.createElement('script'), { textContent: 'window.ran = true' }))],
    ['script-src', () => void setTimeout('window.ran = true')],
    ['script-src-elem', () => document.body.append(Object.assign(document.createElement('script'), { src: 'https://other.example/a.js' }))],
    ['img-src', () => document.body.append(Object.assign(new Image(), { src: 'https://other.example/a.png' }))],
    ['connect-src', () => void fetch('https://other.example/a.json').catch(() => {})],
    ['style-src-elem', () => document.head.append(Object.assign(document.createElement('style'), { textContent: 'body { display: none }' }))],
    ['frame-src', () => document.body.append(Object.assign(document.createElement('iframe'), { src: 'https://other.example/' }))],
    ['worker-src', () => void new Worker('./inline.js')],
    ['base-uri', () => document.head.append(Object.assign(document.createElement('base'), { href: 'https://other.example/' }))],
  ];
  await page.evaluate(() => {
    window.broken = [];
    document.addEventListener('securitypolicyviolation', ({ effectiveDirective }) => window.broken.push(effectiveDirective));
  });
  for (const [directive, attempt] of attempts) {
    await page.evaluate(attempt);
    await page.waitForFunction(() => window.broken.length > 0);
    assert.deepEqual(await page.evaluate(() => window.broken.splice(0)), [directive], `${attempt}`);
  }
  assert.equal(await page.evaluate(() => window.ran), undefined);
});

test('a window of the parent’s origin that is not the parent is not obeyed', async () => {
  const { page } = await pageAround('embed.html?sample=2tpr');
  await heard(page, 'ready');
  await page.evaluate(() => new Promise((done) => document.body.append(Object.assign(document.createElement('iframe'), { srcdoc: '<title>Beside</title>', onload: done }))));
  const [, embedded, beside] = page.frames();
  await embedded.evaluate(() => {
    window.got = [];
    addEventListener('message', ({ origin, source, data }) => window.got.push([origin, source === parent, data.state.frame]));
  });
  const jump = (to) => parent.frames[0].postMessage({ synthetica: 1, type: 'state', state: { frame: to } }, '*');
  await beside.evaluate(jump, 50);
  await embedded.waitForFunction(() => window.got.length === 1);
  // What came before it has been dealt with when the parent is answered.
  await send(page, { synthetica: 1, type: 'get', what: 'state', id: 1 });
  const answer = await page.waitForFunction(() => window.heard.find(({ id }) => id === 1));
  assert.equal((await answer.jsonValue()).state.frame, 0);
  // The same words from the parent are obeyed.
  await page.evaluate(jump, 30);
  await atFrame(page.frameLocator('iframe[src]'), '31 / 129');
  assert.deepEqual(await embedded.evaluate(() => window.got), [[around, false, 50], [around, true, 30]]);
  await page.waitForFunction(() => window.heard.some(({ type, state }) => type === 'state' && state.frame === 30));
  assert.ok(await page.evaluate(() => window.heard.every(({ state }) => state?.frame !== 50)), 'nobody went to frame 51');
});

test('without a known origin it tells only that it is ready and how high it is', async () => {
  const { page, frame } = await pageAround('embed.html?sample=2tpr', { attributes: 'referrerpolicy="no-referrer"' });
  await heard(page, 'ready');
  await send(page, { synthetica: 1, type: 'get', what: 'document', id: 1 });
  await frame.locator('#scrub').press('ArrowRight');
  await atFrame(frame, '2 / 129');
  await send(page, { synthetica: 1, type: 'hello' });
  await page.waitForFunction(() => window.heard.some(({ again }) => again));
  const told = await page.evaluate(() => window.heard);
  assert.deepEqual([...new Set(told.map(({ type }) => type))].sort(), ['height', 'hello', 'ready']);
  const { height, ...greeting } = told.find(({ again }) => again);
  assert.deepEqual(greeting, { synthetica: 1, type: 'hello', again: true, listens: false, ready: { version: 1 }, fromFrame: true });
  assert.ok(height > 400);
});

test('works in a sandbox: no storage, no origin, no worker of its own', async () => {
  for (const path of ['embed.html?sample=bennett&panels=info', '?embed&sample=bennett&panels=info']) {
    const { page, problems, frame } = await pageAround(path, { attributes: 'sandbox="allow-scripts"' });
    await heard(page, 'ready');
    await frame.locator('#play').click();
    await page.waitForFunction(() => window.heard.some(({ type, state }) => type === 'state' && state.frame > 2));
    // The address of older snippets is the applet's, which had begun to load itself before it gave way.
    const given = path.startsWith('?') ? /^asks for|CORS policy|net::ERR_FAILED/ : /^asks for/;
    assert.deepEqual(problems.filter((text) => !given.test(text)), []);
    await page.close();
  }
});

test('the helper for the page around: fits the height, gets, sets, hears', async () => {
  const { page } = await pageAround('embed.html?sample=2tpr');
  const result = await page.evaluate(async (address) => {
    const { linkageFrame } = await import(`${address}frame.js`);
    // Another one, which is loaded only when there is a listener: the first may have been ready before.
    const iframe = document.querySelector('iframe').cloneNode();
    const frame = linkageFrame(iframe, { fit: true });
    const ready = new Promise((resolve) => frame.on('ready', resolve));
    document.querySelector('iframe').replaceWith(iframe);
    await ready;
    const moved = new Promise((resolve) => frame.on('state', (state) => state.frame === 12 && resolve(state)));
    frame.setState({ frame: 12 });
    await moved;
    const refused = await frame.get('nothing').catch((error) => error.message);
    return { frames: (await frame.get('trajectory')).frames, height: iframe.style.height, refused };
  }, browser.address);
  assert.equal(result.frames, 129);
  assert.match(result.height, /^\d{3}px$/);
  assert.match(result.refused, /no “nothing”/);
});

test('fits a phone with panels under the view: all of it, and it rests there', async () => {
  const { page } = await pageAround('embed.html?sample=2tpr&panels=info');
  await page.evaluate(async (address) => {
    const { linkageFrame } = await import(`${address}frame.js`);
    const iframe = document.querySelector('iframe');
    iframe.width = 390;
    window.heights = [];
    const frame = linkageFrame(iframe, { fit: true });
    frame.on('height', (height) => window.heights.push(height));
    iframe.src += '&';
  }, browser.address);
  await page.frameLocator('iframe').locator('#gap-translation').filter({ hasText: /\d/ }).waitFor();
  await page.waitForFunction(() => window.heights.length > 0 && document.querySelector('iframe').offsetHeight > 500);
  // For twenty pictures no other height is told.
  await page.waitForFunction(async () => {
    const { length } = window.heights;
    for (let picture = 0; picture < 20; picture++) await new Promise(requestAnimationFrame);
    return window.heights.length === length;
  });
  const inside = await page.frames()[1].evaluate(() => [document.documentElement.scrollHeight, innerHeight]);
  assert.ok(Math.abs(inside[0] - inside[1]) <= 1, `${inside}`);
  const { length } = await page.evaluate(() => window.heights);
  assert.ok(length < 30, `${length} heights told`);
});

test('axe finds nothing in the page for frames, which has the name of its linkage', async () => {
  for (const [query, viewport] of [['sample=2tpr', { width: 800, height: 600 }], ['sample=2tpr&panels=info+mechanism', { width: 390, height: 844 }]]) {
    const { page } = await browser.blankPage({ viewport });
    await page.goto(`${browser.address}embed.html?${query}`);
    await page.waitForFunction(() => document.title === '2TPR – Synthetica');
    assert.deepEqual(await violations(page), [], query);
  }
});

test('the code of the share dialog works where it is pasted', async () => {
  const { page: applet } = await browser.openPage();
  await applet.getByRole('button', { name: 'Share', exact: true }).click();
  const dialog = applet.getByRole('dialog', { name: 'Share' });
  await dialog.getByLabel('Info').check();
  await dialog.getByLabel('Read only').check();
  const code = await dialog.getByLabel('Frame', { exact: true }).inputValue();
  const tag = await dialog.getByLabel('Element', { exact: true }).inputValue();
  files['/page.html'] = `<!doctype html><html lang="en"><title>Pasted</title><body>${code}${tag}</body></html>`;
  const { page } = await browser.blankPage();
  await page.goto(`${around}/page.html`);
  const frame = page.frameLocator('iframe');
  await atFrame(frame, '1 / 129');
  assert.equal(await frame.locator('synthetica-linkage').getAttribute('panels'), 'info');
  await page.waitForFunction(() => document.querySelector('synthetica-linkage').trajectory?.frames === 129);
  assert.equal(await page.evaluate(() => document.querySelector('synthetica-linkage').readonly), true);
});

test('the one file of the share dialog works from a disk: plays, and is planned anew when it is edited', async () => {
  const { page: applet } = await browser.openPage();
  await applet.getByRole('button', { name: 'Share', exact: true }).click();
  const dialog = applet.getByRole('dialog', { name: 'Share' });
  await dialog.getByLabel('Mechanism').check();
  const download = applet.waitForEvent('download');
  await dialog.getByRole('button', { name: 'Save the file' }).click();
  const path = join(mkdtempSync(join(tmpdir(), 'linkage-')), '3rps.html');
  await (await download).saveAs(path);
  const { page, problems } = await browser.blankPage();
  await page.goto(`file://${path}`);
  const element = page.locator('synthetica-linkage');
  await page.waitForFunction(() => document.querySelector('synthetica-linkage').trajectory?.frames === 129);
  await page.locator('[data-path="motion.frames"], [data-path="chains[0].base.x"]').first().fill('0.25');
  await page.waitForFunction(() => document.querySelector('synthetica-linkage').document.chains[0].base.x === 0.25);
  await page.locator('#play').click();
  await page.waitForFunction(() => document.querySelector('synthetica-linkage').frame > 2);
  assert.equal(await element.evaluate(({ error }) => error), null);
  assert.deepEqual(problems.filter((text) => !text.startsWith('asks for file:')), []);
});

// Frames and pasted code on a site whose server sends no special headers, in pages of another origin; and what a page around
// a frame learns of the files of that server.
import assert from 'node:assert/strict';
import { mkdtempSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { serve } from '../package/site.mjs';
import { openBrowser, ready } from './browser.mjs';

const SECRET = { version: 1, salary_of_the_dean: 'hunter2' };
const sitesFiles = {
  '/tools/': new URL('../../www/dist/', import.meta.url),
  '/secret.json': JSON.stringify(SECRET),
  '/tools/unreadable.json': JSON.stringify(SECRET, null, 2),
  '/tools/cut.json': '{"version": 1, "salary_of_the_dean": hunter2',
};
const coursesFiles = {};

let browser;
/** The site of the applet. */
let site;
/** The site of a course, of another origin. */
let course;
before(async () => {
  browser = await openBrowser();
  site = await serve(sitesFiles);
  course = await serve(coursesFiles);
});
after(async () => {
  site.close();
  course.close();
  await browser.close();
});

/** A page of the course; what frames say to it is kept in `heard`. */
async function openCourse(body, address = course.address) {
  coursesFiles['/page.html'] = `<!doctype html><html lang="en"><title>A course</title><body><script>
    window.heard = [];
    addEventListener('message', ({ data }) => heard.push(data));
  </script>${body}</body></html>`;
  sitesFiles['/page.html'] = coursesFiles['/page.html'];
  const { page, problems } = await browser.blankPage();
  await page.goto(`${address}/page.html`);
  return { page, problems: () => problems.filter((text) => !text.startsWith('asks for')) };
}

const frameOf = (query, attributes = '') => `<iframe src="${site.address}/tools/embed.html${query}" width="700" height="420" ${attributes}></iframe>`;
const hears = (page, type) => page.waitForFunction((wanted) => window.heard.findLast((message) => message.type === wanted), type).then((found) => found.jsonValue());

/** What the dialog Share of the site's applet writes. */
async function shared() {
  const { page } = await browser.blankPage();
  await page.goto(`${site.address}/tools/index.html?sample=2tpr`);
  await ready(page);
  await page.getByRole('button', { name: 'Share', exact: true }).click();
  const dialog = page.getByRole('dialog', { name: 'Share' });
  const code = (name) => dialog.getByLabel(name, { exact: true }).inputValue();
  return { frame: await code('Frame'), element: await code('Element'), words: await dialog.textContent() };
}

test('the server of these tests sends no header that lets other pages in', async () => {
  const answer = await fetch(`${site.address}/tools/inline.js`, { headers: { origin: course.address } });
  assert.equal(answer.headers.get('access-control-allow-origin'), null);
});

test('the code that Share writes for an element works in a page of another origin; what a module would need is said', async () => {
  const { element, words } = await shared();
  assert.match(element, /<script src="[^"]*\/tools\/inline\.js" async>/);
  assert.match(words, /module.*element\.js.*Access-Control-Allow-Origin/);
  const { page, problems } = await openCourse(element + element);
  await page.waitForFunction(() => [...document.querySelectorAll('synthetica-linkage')].every(({ trajectory }) => trajectory?.frames === 129));
  await page.waitForFunction(() => Number(document.querySelector('synthetica-linkage').shadowRoot.querySelector('canvas').dataset.draws) > 0);
  assert.equal(await page.evaluate(() => document.querySelector('synthetica-linkage').document.name), '2TPR');
  assert.deepEqual(problems(), []);
});

test('the code that Share writes for a frame works in a page of another origin, and in a sandbox', async () => {
  const { frame } = await shared();
  for (const code of [frame, frame.replace('<iframe', '<iframe sandbox="allow-scripts"')]) {
    const { page, problems } = await openCourse(code);
    await hears(page, 'ready');
    const inside = page.frameLocator('iframe');
    await inside.locator('#play').click();
    await page.waitForFunction(() => window.heard.some(({ type, state }) => type === 'state' && state.frame > 2));
    assert.equal((await hears(page, 'document')).document.name, '2TPR');
    assert.deepEqual(problems(), []);
  }
});

test('src of a frame: a document of the site’s own folder, asked for without cookies', async () => {
  const { page, problems } = await openCourse('');
  await page.context().addCookies([{ name: 'session', value: 'of-the-reader', url: `${site.address}/` }]);
  const asked = [];
  page.on('request', (request) => asked.push(request));
  coursesFiles['/page.html'] = coursesFiles['/page.html'].replace('</body>', `${frameOf('?src=mechanisms/2tpr.json&set=motion.frames:9')}</body>`);
  await page.reload();
  assert.equal((await hears(page, 'document')).document.name, '2TPR');
  await page.waitForFunction(() => window.heard.some(({ state }) => state?.frames === 9));
  const cookieOf = async (file) => (await asked.find((request) => new URL(request.url()).pathname.endsWith(file)).allHeaders()).cookie;
  // The page itself is asked for with it: it would go along.
  assert.equal(await cookieOf('embed.html'), 'session=of-the-reader');
  assert.equal(await cookieOf('2tpr.json'), undefined);
  assert.deepEqual(problems(), []);
});

test('src of a frame: nothing of the server beside the site is loaded', async () => {
  const { page } = await openCourse(['../secret.json', '/secret.json', 'x/..%252f..%252fsecret.json', 'https://other.example/a.json'].map((src) => frameOf(`?src=${src}`)).join(''));
  const asked = [];
  page.on('request', (request) => asked.push(request.url()));
  await page.reload();
  await page.waitForFunction(() => window.heard.filter(({ type }) => type === 'error').length === 4);
  const errors = await page.evaluate(() => window.heard.filter(({ type }) => type === 'error').map(({ error }) => error.message));
  for (const message of errors) assert.match(message, /^src is “.*(secret|other).*”, which a frame does not load\. Accepted: a document in the folder of this page/);
  await page.frameLocator('iframe >> nth=0').locator('#trouble', { hasText: 'does not load' }).waitFor();
  assert.equal(asked.filter((url) => url.includes('/embed.html')).length, 4);
  assert.deepEqual(asked.filter((url) => /secret\.json|other\.example/.test(url.replace(/\?.*/, ''))), []);
  assert.doesNotMatch(JSON.stringify(await page.evaluate(() => window.heard)), /hunter2|salary/);
});

test('src of a frame: what its own server sends on to another place is not loaded', async () => {
  const { page } = await openCourse('');
  await page.route(`${site.address}/tools/moved.json`, (route) => route.fulfill({ status: 302, headers: { location: `${site.address}/secret.json` } }));
  coursesFiles['/page.html'] = coursesFiles['/page.html'].replace('</body>', '') + frameOf('?src=moved.json');
  const asked = [];
  page.on('request', (request) => asked.push(new URL(request.url()).pathname));
  await page.reload();
  assert.match((await hears(page, 'error')).error.message, /moved\.json could not be loaded/);
  assert.ok(asked.includes('/tools/moved.json') && !asked.includes('/secret.json'), asked.join());
});

test('src of a frame: a page of another origin hears where and which fault, and no word of the file; one of the site hears all', async () => {
  for (const [file, code, all] of [['unreadable.json', 'unknown-field', /salary/], ['cut.json', 'syntax', /Line 1, column 38/]]) {
    const { page } = await openCourse(frameOf(`?src=${file}`));
    const { error } = await hears(page, 'error');
    assert.equal(error.code, code);
    assert.match(error.message, new RegExp(`src names cannot be shown \\(${code}`));
    // In the frame it is told, to the person in front of it.
    await page.frameLocator('iframe').locator('#fault-banner').waitFor();
    await page.evaluate(() => document.querySelector('iframe').contentWindow.postMessage({ synthetica: 1, type: 'hello' }, '*'));
    await page.waitForFunction(() => window.heard.some(({ type, again, error: late }) => type === 'hello' && again && late));
    assert.doesNotMatch(JSON.stringify(await page.evaluate(() => window.heard)), /hunter2|salary/);

    const { page: own } = await openCourse(frameOf(`?src=${file}`), site.address);
    assert.match((await hears(own, 'error')).error.message, all);
  }
});

test('src of a frame in a sandbox without an origin: says why it cannot be loaded', async () => {
  const { page } = await openCourse(frameOf('?src=mechanisms/2tpr.json', 'sandbox="allow-scripts"'));
  const { error } = await hears(page, 'error');
  assert.match(error.message, /2tpr\.json could not be loaded.*Access-Control-Allow-Origin: this page is in a sandbox without an origin.*in the address of the frame/);
  await page.frameLocator('iframe').locator('#trouble', { hasText: 'sandbox without an origin' }).waitFor();
});

test('src of an element: with the cookies of its own site, as a picture; in a sandbox, and from a disk, it says why it cannot be loaded', async () => {
  const element = (src) => `<script src="${site.address}/tools/inline.js"></script><synthetica-linkage loading="eager" src="${src}"></synthetica-linkage>`;
  const { page } = await openCourse(element('tools/mechanisms/2tpr.json'), site.address);
  await page.context().addCookies([{ name: 'session', value: 'of-the-reader', url: `${site.address}/` }]);
  const asking = page.waitForRequest(/2tpr\.json$/);
  await page.reload();
  assert.equal((await (await asking).allHeaders()).cookie, 'session=of-the-reader');
  await page.waitForFunction(() => document.querySelector('synthetica-linkage').document?.name === '2TPR');

  const { page: boxed } = await openCourse(`<iframe sandbox="allow-scripts" width="700" height="420" srcdoc="${element(`${site.address}/tools/mechanisms/2tpr.json`).replaceAll('"', '&quot;')}"></iframe>`);
  await boxed.frameLocator('iframe').locator('#trouble', { hasText: /2tpr\.json could not be loaded.*is in a sandbox without an origin.*in the element/ }).waitFor();

  const file = join(mkdtempSync(join(tmpdir(), 'disk-')), 'page.html');
  writeFileSync(file, `<!doctype html><meta charset="utf-8">${element('2tpr.json')}`);
  const { page: disk } = await browser.blankPage();
  await disk.goto(`file://${file}`);
  await disk.locator('#trouble', { hasText: /2tpr\.json could not be loaded.*was opened from a disk, and is without an origin/ }).waitFor();
});

test('a sample that there is not: the frame says which was meant, and shows no other', async () => {
  const { page } = await openCourse(frameOf('?sample=2tqr'));
  const { error } = await hears(page, 'error');
  assert.match(error.message, /no sample “2tqr”\. Did you mean “2tpr”\? Accepted: .*2tpr\.json/);
  await page.frameLocator('iframe').locator('#trouble', { hasText: 'Did you mean “2tpr”?' }).waitFor();
  assert.equal(await page.frames()[1].evaluate(() => document.querySelector('synthetica-linkage').document), null);
  assert.deepEqual([...new Set(await page.evaluate(() => window.heard.map(({ type }) => type)))].filter((type) => ['ready', 'document'].includes(type)), []);
});

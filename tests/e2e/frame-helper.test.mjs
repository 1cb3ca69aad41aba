// frame.js in the page around a frame: whenever it is begun, whatever the frame does, and whoever else sends messages.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { serve } from '../package/site.mjs';
import { openBrowser } from './browser.mjs';

const dist = new URL('../../www/dist/', import.meta.url);
const coursesFiles = { '/frame.js': readFileSync(new URL('frame.js', dist), 'utf8') };

let browser;
let site;
/** Of another origin, with a copy of frame.js: a module of the site's would need a header of it. */
let course;
/** Of a third origin; its page says that it is a frame at frame 67. */
let stranger;
before(async () => {
  browser = await openBrowser();
  site = await serve({ '/': dist });
  course = await serve(coursesFiles);
  const lie = "parent.postMessage({ synthetica: 1, type: 'state', state: { frame: 66 } }, '*'); parent.postMessage('lied', '*')";
  stranger = await serve({ '/lies.html': `<!doctype html><title>Lies</title><script>${lie}</script>` });
});
after(async () => {
  for (const { close } of [site, course, stranger]) close();
  await browser.close();
});

/** A page with frames in it; `window.linkageFrame` is the helper, `raw` holds all messages with the number of their frame. */
async function pageWith(...frames) {
  const iframes = frames.map(({ query, attributes = '' }) => `<iframe src="${site.address}/embed.html${query}" width="700" height="420" ${attributes}></iframe>`).join('');
  coursesFiles['/page.html'] = `<!doctype html><html lang="en"><title>A course</title><body><script>
      window.raw = [];
      addEventListener('message', ({ data, source }) => raw.push({ data, from: [...document.querySelectorAll('iframe')].findIndex((frame) => frame.contentWindow === source) }));
    </script>
    <script type="module">
      import { linkageFrame } from '/frame.js';
      window.linkageFrame = linkageFrame;
      window.frames$ = [...document.querySelectorAll('iframe')];
      window.onFrame = (index, wish) => {
        const frame = linkageFrame(frames$[index], wish);
        const told = [];
        for (const type of ['ready', 'document', 'state', 'height', 'error']) frame.on(type, (content) => told.push({ type, content }));
        return (window.helper = Object.assign(frame, { told }));
      };
    </script>${iframes}`;
  const { page } = await browser.blankPage();
  await page.goto(`${course.address}/page.html`);
  await page.waitForFunction(() => window.onFrame);
  return page;
}

const isReady = (page, index = 0) => page.waitForFunction((at) => window.raw.some(({ data, from }) => from === at && data.type === 'ready'), index);

test('is a small script of its own, which knows the version from the one place', () => {
  const script = readFileSync(new URL('frame.js', dist), 'utf8');
  assert.doesNotMatch(script, /\bimport\b/);
  assert.ok(script.length < 4000, `${script.length} letters`);
  const written = ['host.js', 'protocol.js', 'frame.js', 'address.js'].filter((file) => /VERSION = /.test(readFileSync(new URL(`../../www/embed/${file}`, import.meta.url), 'utf8')));
  assert.deepEqual(written, []);
});

test('begun long after the frame is ready: hears what it has told, once, and fits its height', async () => {
  const page = await pageWith({ query: '?sample=2tpr&speed=fast' });
  await isReady(page);
  await page.waitForFunction(() => window.raw.some(({ data }) => data.type === 'state'));
  await page.evaluate(() => void window.onFrame(0, { fit: true }));
  await page.waitForFunction(() => ['ready', 'document', 'state', 'height', 'error'].every((type) => window.helper.told.some((told) => told.type === type)));
  const told = await page.evaluate(() => window.helper.told);
  assert.equal(told.find(({ type }) => type === 'document').content.name, '2TPR');
  assert.equal(told.find(({ type }) => type === 'state').content.frames, 129);
  assert.match(told.find(({ type }) => type === 'error').content.message, /speed is “fast”/);
  const { content: height } = told.find(({ type }) => type === 'height');
  assert.equal(await page.evaluate(() => window.frames$[0].style.height), `${height}px`);
  // Answered after all that: nothing came twice.
  await page.evaluate(() => window.helper.get('state'));
  assert.deepEqual(await page.evaluate(() => window.helper.told.filter(({ type }) => ['ready', 'document', 'error'].includes(type)).map(({ type }) => type)), ['ready', 'document', 'error']);
});

test('begun before the frame is there: hears each thing once, also that the address has an attribute that is refused', async () => {
  const page = await pageWith();
  await page.evaluate((address) => {
    const iframe = document.createElement('iframe');
    iframe.src = address;
    document.body.append(iframe);
    window.frames$ = [iframe];
    window.onFrame(0);
  }, `${site.address}/embed.html?sample=2tpr&theme=sepia&panels=tables`);
  await page.waitForFunction(() => window.helper.told.some(({ type }) => type === 'state'));
  const told = await page.evaluate(() => window.helper.told);
  const errors = told.filter(({ type }) => type === 'error').map(({ content }) => content);
  assert.deepEqual(errors.map(({ code }) => code), ['attribute', 'attribute']);
  assert.match(errors[0].message, /theme is “sepia”.*Accepted: light, dark, auto/);
  assert.match(errors[1].message, /panels is “tables”/);
  assert.deepEqual(told.filter(({ type }) => ['ready', 'document'].includes(type)).map(({ type }) => type), ['ready', 'document']);
});

test('a document given before the address’s own is ready is the one that is shown', async () => {
  const page = await pageWith();
  const shown = await page.evaluate(async (address) => {
    const document_ = { ...(await (await fetch('/2tpr.json')).json()), name: 'Given' };
    const iframe = document.createElement('iframe');
    iframe.src = address;
    document.body.append(iframe);
    window.frames$ = [iframe];
    const frame = window.onFrame(0);
    // Long before there is anybody to hear it.
    frame.setDocument(document_);
    await new Promise((resolve) => frame.on('ready', resolve));
    return (await frame.get('document')).name;
  }, `${site.address}/embed.html?sample=bennett`);
  assert.equal(shown, 'Given');
  // What the address asks for was read before the given one: questions to the planner are answered in turn.
  const names = await page.evaluate(() => window.helper.told.filter(({ type }) => type === 'document').map(({ content }) => content.name));
  assert.deepEqual(names, ['Given']);
});
coursesFiles['/2tpr.json'] = readFileSync(new URL('mechanisms/2tpr.json', dist), 'utf8');

const refusal = (page, act) => page.evaluate((body) => new Function(`return ${body}`)().then(() => 'answered', ({ message }) => message), act);

test('a question that nobody will answer is rejected in bounded time, and says why', async () => {
  const page = await pageWith({ query: '?sample=2tpr', attributes: 'referrerpolicy="no-referrer"' }, { query: '?sample=2tpr&origin=https://other.example' }, { query: '?sample=2tpr' });
  for (const index of [0, 2]) await isReady(page, index);
  // It says itself that it listens to nobody: long before the patience ends.
  assert.match(await refusal(page, 'window.onFrame(0, { patience: 1e8 }).get("state")'), /listens to nobody.*Accepted: the origin of that page in the frame’s address/);
  assert.match(await refusal(page, 'window.helper.get("state")'), /listens to nobody/);
  assert.match(await refusal(page, 'window.onFrame(1, { patience: 50 }).get("state")'), /gave no “state” within 0\.05 s: it is not loaded: its address does not open, is of another origin/);
  assert.match(await refusal(page, 'window.onFrame(2, { patience: 1e8 }).get("nothing")'), /no “nothing” to get/);
  assert.equal((await page.evaluate(() => window.helper.get('state'))).frames, 129);
});

test('closing rejects what waits, and what is asked later', async () => {
  const page = await pageWith({ query: '?sample=2tpr&origin=https://other.example' });
  await page.evaluate(() => void window.onFrame(0, { patience: 1e8 }));
  assert.match(await refusal(page, '[window.helper.get("state"), window.helper.close()][0]'), /helper of this frame is closed/);
  assert.match(await refusal(page, 'window.helper.get("state")'), /helper of this frame is closed/);
});

test('two helpers of one frame each hear their own answers', async () => {
  const page = await pageWith({ query: '?sample=2tpr' });
  await isReady(page);
  const answers = await page.evaluate(async () => {
    const [one, other] = [window.onFrame(0), window.onFrame(0)];
    const [{ frames }, { chains }] = await Promise.all([one.get('state'), other.get('document')]);
    return [frames, chains.length];
  });
  assert.deepEqual(answers, [129, 2]);
});

test('another frame of the same origin is not heard', async () => {
  const page = await pageWith({ query: '?sample=2tpr' }, { query: '?sample=bennett' });
  for (const index of [0, 1]) await isReady(page, index);
  await page.evaluate(() => void window.onFrame(0));
  await page.waitForFunction(() => window.helper.told.some(({ type }) => type === 'document'));
  await page.evaluate(() => window.frames$[1].contentWindow.postMessage({ synthetica: 1, type: 'state', state: { frame: 50 } }, '*'));
  await page.waitForFunction(() => window.raw.some(({ data, from }) => from === 1 && data.state?.frame === 50));
  assert.deepEqual(await page.evaluate(() => window.helper.told.filter(({ type, content }) => type === 'document' && content.name !== '2TPR')), []);
  assert.deepEqual(await page.evaluate(() => window.helper.told.filter(({ content }) => content?.frame === 50)), []);
});

test('the frame’s window is not heard once it shows a page of another origin', async () => {
  const page = await pageWith({ query: '?sample=2tpr' });
  await isReady(page);
  await page.evaluate(() => void window.onFrame(0));
  await page.waitForFunction(() => window.helper.told.some(({ type }) => type === 'state'));
  await page.evaluate((address) => (window.frames$[0].src = address), `${stranger.address}/lies.html`);
  await page.waitForFunction(() => window.raw.some(({ data }) => data === 'lied'));
  assert.ok(await page.evaluate(() => window.raw.some(({ data, from }) => from === 0 && data.state?.frame === 66)), 'the lie was told');
  assert.deepEqual(await page.evaluate(() => window.helper.told.filter(({ content }) => content?.frame === 66)), []);
});

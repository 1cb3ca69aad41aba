// The life of an element in another page: what it loads and when, its poster, many at once, other documents, out of the page.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { gzipSync } from 'node:zlib';
import { openBrowser } from './browser.mjs';

const sample = (name) => readFileSync(new URL(`../../www/mechanisms/${name}.json`, import.meta.url), 'utf8');

/** What a page with an element that nobody has seen may load, in bytes after gzip. */
const LIGHT = 40_000;

/** A red picture, wider than high. */
const POSTER = '<svg xmlns="http://www.w3.org/2000/svg" width="200" height="100"><rect width="200" height="100" fill="red"/></svg>';

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

/** A page of somebody else's with this in its body; counts the graphics contexts that it makes. */
async function course(body, { before: prepare = async () => {}, ...options } = {}) {
  const { page, problems } = await browser.blankPage({ serviceWorkers: 'block', ...options });
  await page.addInitScript(() => {
    window.contexts = [];
    const getContext = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
      const context = getContext.call(this, kind, ...rest);
      if (/webgl/.test(kind) && context && !window.contexts.includes(context)) window.contexts.push(context);
      return context;
    };
  });
  const html = `<!doctype html><html lang="en"><head><meta charset="utf-8"><title>A course</title><link rel="icon" href="data:,">
    <script type="module" src="./element.js"></script></head><body><main><h1>A course</h1>${body}</main></body></html>`;
  await page.route(`${browser.address}course.html`, (route) => route.fulfill({ contentType: 'text/html', body: html }));
  await page.context().route(`${browser.address}other.html`, (route) => route.fulfill({ contentType: 'text/html', body: '<!doctype html><title>Other</title><body></body>' }));
  await page.route(`${browser.address}bennett.json`, (route) => route.fulfill({ contentType: 'application/json', body: sample('bennett') }));
  await page.route(`${browser.address}poster.svg`, (route) => route.fulfill({ contentType: 'image/svg+xml', body: POSTER }));
  await page.route(`${browser.address}no-such.svg`, (route) => route.fulfill({ status: 404, body: '' }));
  await prepare(page);
  await page.goto(`${browser.address}course.html`);
  await page.waitForFunction(() => customElements.get('synthetica-linkage'));
  return { page, problems };
}

const FAR = '<div style="height: 5000px"></div>';

/** The first element has been drawn. */
const drawn = (page) => page.waitForFunction(() => document.querySelector('synthetica-linkage').shadowRoot.querySelector('#canvas')?.dataset.draws > 0);

test('far below the view it loads next to nothing; scrolled to, it loads itself', async () => {
  /** @type {Map<string, Promise<number>>} */
  const sizes = new Map();
  const { page, problems } = await course(`${FAR}<synthetica-linkage src="bennett.json">A Bennett linkage</synthetica-linkage>`, {
    before: async (page) => {
      page.context().on('response', (response) => sizes.set(response.url(), response.body().then((body) => gzipSync(body, { level: 9 }).length)));
    },
  });
  await page.waitForLoadState('networkidle');
  const all = await Promise.all([...sizes].map(async ([url, size]) => [new URL(url).pathname, await size]));
  const total = all.reduce((sum, [, size]) => sum + size, 0);
  console.log(`an element out of sight: ${total} bytes after gzip`);
  assert.ok(total <= LIGHT && total > 1000, JSON.stringify(all));
  assert.ok(!all.some(([path]) => /wasm|worker|workbench|bennett/.test(path)), JSON.stringify(all));
  assert.deepEqual([page.workers().length, await page.evaluate(() => contexts.length)], [0, 0]);
  await page.locator('synthetica-linkage').scrollIntoViewIfNeeded();
  await drawn(page);
  assert.equal(page.workers().length, 1);
  assert.deepEqual(problems, []);
});

test('what asks for the motion begins to load it wherever it is: play, toCSV, toImage, whenReady, eager', async () => {
  const { page, problems } = await course(`${FAR}${'<synthetica-linkage src="bennett.json"></synthetica-linkage>'.repeat(6)}`);
  const told = await page.evaluate(async () => {
    const [play, csv, image, wait, eager, none] = document.querySelectorAll('synthetica-linkage');
    const ready = (element) => new Promise((resolve) => element.addEventListener('ready', () => resolve('ready'), { once: true }));
    const played = ready(play);
    const hurried = ready(eager);
    play.play();
    eager.loading = 'eager';
    const answers = [await played, await hurried, (await csv.toCSV()).split('\n').length > 60, (await image.toImage()).type, (await wait.whenReady()).frames];
    await eager.workbench;
    return [...answers, eager.getAttribute('loading'), none.trajectory, none.loading];
  });
  assert.deepEqual(told, ['ready', 'ready', true, 'image/png', 65, 'eager', null, 'lazy']);
  assert.deepEqual(problems, []);
});

test('a wait for an element without a linkage, or with a faulty one, ends with what is wrong', async () => {
  const { page } = await course(`${FAR}<synthetica-linkage></synthetica-linkage><synthetica-linkage><script type="application/json">{</script></synthetica-linkage>`);
  const told = await page.evaluate(() => Promise.all([...document.querySelectorAll('synthetica-linkage')].map((element) => element.whenReady().catch(({ message }) => message))));
  assert.match(told[0], /No linkage is given/);
  assert.match(told[1], /JSON/i);
});

/** The colour in the middle of the first element. */
const middle = async (page) => {
  const bytes = await page.locator('synthetica-linkage').first().screenshot();
  return page.evaluate(async (base64) => {
    const bitmap = await createImageBitmap(await (await fetch(`data:image/png;base64,${base64}`)).blob());
    const pen = new OffscreenCanvas(1, 1).getContext('2d');
    pen.drawImage(bitmap, bitmap.width / 2, bitmap.height / 2, 1, 1, 0, 0, 1, 1);
    return [...pen.getImageData(0, 0, 1, 1).data].slice(0, 3).join();
  }, bytes.toString('base64'));
};

test('a poster stands there, whole, until the linkage is drawn, and where it cannot be', async () => {
  let come;
  const late = new Promise((resolve) => (come = resolve));
  const { page } = await course('<synthetica-linkage src="bennett.json" poster="poster.svg" controls>What it is</synthetica-linkage><synthetica-linkage id="faulty" poster="poster.svg"><script type="application/json">{</script></synthetica-linkage>', {
    before: (page) =>
      page.route(/workbench-/, async (route) => {
        await late;
        await route.continue();
      }),
  });
  const poster = page.locator('synthetica-linkage >> #poster').first();
  await page.waitForFunction(() => document.querySelector('synthetica-linkage').shadowRoot.querySelector('#poster').naturalWidth > 0);
  assert.equal(await middle(page), '255,0,0');
  assert.equal(await poster.evaluate((image) => getComputedStyle(image).objectFit), 'contain');
  assert.ok(!(await page.getByRole('button', { name: 'Play' }).first().isVisible()), 'nothing that would answer nothing');
  come();
  await drawn(page);
  await poster.waitFor({ state: 'hidden' });
  assert.notEqual(await middle(page), '255,0,0');
  const faulty = page.locator('#faulty');
  await faulty.locator('#fault-text').filter({ hasText: /./ }).waitFor();
  assert.ok(await faulty.locator('#poster').isVisible(), 'it stands for what cannot be drawn');
});

test('a poster that does not come leaves its place to the content', async () => {
  const { page } = await course(`<synthetica-linkage poster="no-such.svg"><p>What it is</p></synthetica-linkage>`);
  await page.locator('synthetica-linkage >> #poster').waitFor({ state: 'hidden' });
  assert.ok((await page.getByText('What it is').boundingBox()).width > 20);
});

test('a view that cannot be loaded says so in the element, and comes when it is tried again', async () => {
  const { page } = await course('<synthetica-linkage src="bennett.json"></synthetica-linkage>', { before: (page) => page.route(/workbench-/, (route) => route.abort()) });
  await page.getByText('The view could not be loaded').waitFor();
  await page.unroute(/workbench-/);
  await page.getByRole('button', { name: 'Try again' }).click();
  await drawn(page);
});

/** How many colours each view's own canvas has. */
const coloursOfViews = (page) =>
  page.evaluate(() =>
    [...document.querySelectorAll('synthetica-linkage')].map(({ shadowRoot }) => {
      const canvas = shadowRoot.querySelector('#canvas');
      const pen = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d', { willReadFrequently: true });
      pen.drawImage(canvas, 0, 0);
      return new Set(new Uint32Array(pen.getImageData(0, 0, canvas.width, canvas.height).data.buffer)).size;
    }),
  );

test('the only view of a page is drawn without a copy; beside another each has its picture, and alone again it is as before', async () => {
  const { page, problems } = await course('<synthetica-linkage src="bennett.json" loading="eager" style="height: 200px"></synthetica-linkage>');
  await drawn(page);
  const views = async () => {
    const itself = await page.evaluate(() => [...document.querySelectorAll('synthetica-linkage')].map(({ shadowRoot }) => shadowRoot.querySelector('.drawn') !== null));
    const colours = await coloursOfViews(page);
    return itself.map((one, index) => ({ itself: one, copied: colours[index] > 20 }));
  };
  assert.deepEqual(await views(), [{ itself: true, copied: false }]);
  await page.evaluate(() => document.querySelector('synthetica-linkage').after(document.querySelector('synthetica-linkage').cloneNode()));
  await page.waitForFunction(() => [...document.querySelectorAll('synthetica-linkage')].every(({ shadowRoot }) => shadowRoot.querySelector('#canvas')?.dataset.draws > 0));
  assert.deepEqual(await views(), [{ itself: false, copied: true }, { itself: false, copied: true }]);
  await page.evaluate(() => {
    document.querySelectorAll('synthetica-linkage')[1].remove();
    document.querySelector('synthetica-linkage').frame = 20;
  });
  await page.waitForFunction(() => document.querySelector('synthetica-linkage').shadowRoot.querySelector('.drawn'));
  assert.deepEqual(await views(), [{ itself: true, copied: false }]);
  assert.deepEqual(problems, []);
});

test('twenty in view are all drawn, with few graphics contexts; a lost one is told by all, and all come back', async () => {
  const { page, problems } = await course('<synthetica-linkage src="bennett.json" style="display: block; width: 150px; height: 110px; float: left"></synthetica-linkage>'.repeat(20), { viewport: { width: 800, height: 700 } });
  await page.waitForFunction(() => [...document.querySelectorAll('synthetica-linkage')].every(({ shadowRoot }) => shadowRoot.querySelector('#canvas')?.dataset.draws > 0));
  const colours = () => coloursOfViews(page);
  assert.ok((await colours()).every((count) => count > 20), String(await colours()));
  assert.ok((await page.evaluate(() => contexts.length)) <= 2);
  assert.ok(await page.evaluate(() => contexts.every((context) => !context.isContextLost())));
  const notes = (shown) =>
    page.waitForFunction((wanted) => [...document.querySelectorAll('synthetica-linkage')].every(({ shadowRoot }) => shadowRoot.querySelector('#view-note').hidden !== wanted), shown);
  await page.evaluate(() => {
    window.draws = [...document.querySelectorAll('synthetica-linkage')].map(({ shadowRoot }) => shadowRoot.querySelector('#canvas').dataset.draws);
    window.loss = contexts[0].getExtension('WEBGL_lose_context');
    loss.loseContext();
  });
  await notes(true);
  assert.ok((await colours()).every((count) => count > 20), 'the last pictures stay');
  await page.evaluate(() => loss.restoreContext());
  await notes(false);
  await page.waitForFunction(() => [...document.querySelectorAll('synthetica-linkage')].every(({ shadowRoot }, at) => Number(shadowRoot.querySelector('#canvas').dataset.draws) > Number(draws[at])));
  assert.ok((await colours()).every((count) => count > 20));
  assert.deepEqual(problems.filter((text) => !/CONTEXT_LOST|Context Lost|Context Restored/i.test(text)), []);
});

test('pictures of elements out of sight, never loaded, and out of the page have the size asked for and leave no context behind', async () => {
  const { page, problems } = await course(`<div id="here"></div>${FAR}<synthetica-linkage src="bennett.json"></synthetica-linkage>`);
  const made = await page.evaluate(async (text) => {
    const below = document.querySelector('synthetica-linkage');
    const apart = document.createElement('synthetica-linkage');
    apart.src = 'bennett.json';
    const removed = document.createElement('synthetica-linkage');
    removed.document = text;
    document.querySelector('#here').append(removed);
    await removed.whenReady();
    removed.remove();
    const sizes = [];
    for (const element of [below, apart, removed]) {
      const { width, height } = await createImageBitmap(await element.toImage({ width: 320, height: 200, scale: 1 }));
      const svg = new DOMParser().parseFromString(await (await element.toImage({ type: 'svg', width: 320, height: 200 })).text(), 'image/svg+xml').documentElement;
      sizes.push([width, height, svg.getAttribute('width'), svg.getAttribute('height'), svg.querySelectorAll('#linkage path').length > 10]);
    }
    for (let k = 0; k < 20; k++) await [below, apart, removed][k % 3].toImage({ width: 60, height: 40, scale: 1 });
    return { sizes, contexts: contexts.length, alive: contexts.every((context) => !context.isContextLost()), left: document.body.children.length };
  }, sample('bennett'));
  assert.deepEqual(made.sizes, Array(3).fill([320, 200, '320', '200', true]));
  assert.ok(made.contexts <= 2, `${made.contexts} contexts`);
  assert.ok(made.alive);
  assert.equal(made.left, 1, 'nothing is left in the page');
  assert.deepEqual(problems, []);
});

/** A window behind another gives no pictures to look at each. */
const BY_TIME = { polling: 50 };

test('adopted by another document it keeps its look and goes on drawing, also when the first window rests', async () => {
  const { page, problems } = await course('<synthetica-linkage src="bennett.json" autoplay loop controls></synthetica-linkage><iframe src="other.html" width="500" height="400"></iframe>', { reducedMotion: 'no-preference', viewport: { width: 900, height: 1000 } });
  await drawn(page);
  const look = () =>
    page.evaluate(() => {
      const { shadowRoot } = window.element;
      const { display, backgroundImage } = element.ownerDocument.defaultView.getComputedStyle(shadowRoot.querySelector('.scene'));
      const canvas = shadowRoot.querySelector('#canvas');
      return [display, backgroundImage, element.ownerDocument.defaultView.getComputedStyle(canvas).position];
    });
  await page.evaluate(() => {
    window.element = document.querySelector('synthetica-linkage');
  });
  const before = await look();
  await page.waitForFunction(() => document.querySelector('iframe').contentDocument?.body);
  await page.evaluate(() => document.querySelector('iframe').contentDocument.body.append(element));
  assert.deepEqual(await look(), before);
  const goesOn = async () => {
    await page.waitForFunction(() => element.shadowRoot.querySelector('#canvas')?.dataset.draws > 2, null, BY_TIME);
    const frame = await page.evaluate(() => element.frame);
    await page.waitForFunction((old) => element.frame !== old, frame, BY_TIME);
  };
  await goesOn();
  const [popup] = await Promise.all([page.waitForEvent('popup'), page.evaluate(() => void (window.other = open('other.html', '', 'width=500,height=400')))]);
  await popup.waitForLoadState();
  await page.evaluate(() => other.document.body.append(element));
  assert.deepEqual(await look(), before);
  // Its own pictures go on, though the first window may give none.
  await popup.bringToFront();
  await goesOn();
  // And its size is that of its own window.
  await page.evaluate(() => (element.style.width = '210px'));
  await page.waitForFunction(() => element.shadowRoot.querySelector('#canvas').width === Math.floor(210 * Math.min(2, devicePixelRatio)), null, BY_TIME);
  await page.evaluate(() => document.querySelector('main').append(element));
  assert.deepEqual(await look(), before);
  assert.deepEqual(problems, []);
});

test('an element that has gone, at rest or while it moved, leaves no buffer in the graphics card', async () => {
  const { page, problems } = await course('', {
    before: (page) =>
      page.addInitScript(() => {
        window.buffers = new Set();
        const { createBuffer, deleteBuffer } = WebGL2RenderingContext.prototype;
        WebGL2RenderingContext.prototype.createBuffer = function () {
          const made = createBuffer.call(this);
          window.buffers.add(made);
          return made;
        };
        WebGL2RenderingContext.prototype.deleteBuffer = function (buffer) {
          window.buffers.delete(buffer);
          deleteBuffer.call(this, buffer);
        };
      }),
  });
  const counts = await page.evaluate(async () => {
    const counts = [];
    for (const moves of [false, true]) {
      const element = document.createElement('synthetica-linkage');
      element.setAttribute('src', 'bennett.json');
      element.setAttribute('eager', '');
      document.querySelector('main').append(element);
      const { player, scene } = await element.workbench;
      // The second picture is the one at rest, with shadows.
      while (!(scene.canvas.dataset.draws > 1)) await new Promise(requestAnimationFrame);
      if (moves) player.draw();
      counts.push(window.buffers.size);
      element.remove();
      while (scene.canvas.isConnected) await new Promise(requestAnimationFrame);
      while (element.shadowRoot.querySelector('#canvas')) await new Promise(requestAnimationFrame);
      counts.push(window.buffers.size);
    }
    return counts;
  });
  assert.ok(counts[0] > 10 && counts[2] > 10, counts.join(' '));
  assert.deepEqual([counts[1], counts[3]], [0, 0]);
  assert.deepEqual(problems, []);
});

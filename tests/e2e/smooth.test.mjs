// Smooth edges reach every view whole: with a graphics card, where every picture has them, and without one, of several views.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { openBrowser } from './browser.mjs';

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

/** A page with views of these heights, each half as wide again. @param {number[]} heights */
async function views(heights, graphicsCard = false) {
  const { page, problems } = await browser.blankPage({ viewport: { width: 900, height: 700 }, serviceWorkers: 'block' });
  await page.addInitScript((graphicsCard) => {
    const { getParameter } = WebGL2RenderingContext.prototype;
    const UNMASKED_RENDERER_WEBGL = 0x9246;
    WebGL2RenderingContext.prototype.getParameter = function (name) {
      return graphicsCard && [this.RENDERER, UNMASKED_RENDERER_WEBGL].includes(name) ? 'a graphics card' : getParameter.call(this, name);
    };
    /** How many pixels right of `from` anything covers. A view's own canvas can be read whenever it is not alone. */
    globalThis.covered = (at, from) => {
      const canvas = document.querySelectorAll('synthetica-linkage')[at].shadowRoot.querySelector('#canvas');
      const read = canvas.nextElementSibling.className === 'drawn' ? canvas.nextElementSibling : canvas;
      const pen = new OffscreenCanvas(read.width, read.height).getContext('2d');
      pen.drawImage(read, 0, 0);
      const { data } = pen.getImageData(from, 0, read.width - from, read.height);
      return data.filter((alpha, i) => i % 4 === 3 && alpha > 0).length;
    };
  }, graphicsCard);
  const bennett = readFileSync(new URL('../../www/mechanisms/bennett.json', import.meta.url), 'utf8');
  await page.route(`${browser.address}bennett.json`, (route) => route.fulfill({ contentType: 'application/json', body: bennett }));
  const elements = heights.map((height) => `<synthetica-linkage src="bennett.json" eager style="height: ${height}px; width: ${1.5 * height}px"></synthetica-linkage>`);
  const body = `<!doctype html><html lang="en"><title>Views</title><link rel="icon" href="data:,"><script type="module" src="./element.js"></script>${elements.join('')}`;
  await page.route(`${browser.address}views.html`, (route) => route.fulfill({ contentType: 'text/html', body }));
  await page.goto(`${browser.address}views.html`);
  await page.waitForFunction((count) => [...document.querySelectorAll('synthetica-linkage')].filter((one) => one.shadowRoot?.querySelector('#canvas')?.dataset.draws > 0).length === count, heights.length);
  return { page, problems };
}

test('with a graphics card the only view has its picture', async () => {
  const { page, problems } = await views([360], true);
  // In the task in which it is drawn, the canvas of the graphics card can be read.
  const pixels = await page.evaluate(async () => {
    const { player } = await document.querySelector('synthetica-linkage').workbench;
    player.draw();
    return globalThis.covered(0, 0);
  });
  assert.ok(pixels > 5000, `${pixels} pixels are covered`);
  assert.deepEqual(problems, []);
});

test('with a graphics card each of several views has its own picture', async () => {
  const { page, problems } = await views([360, 160], true);
  const pixels = await page.evaluate(() => [0, 1].map((at) => globalThis.covered(at, 0)));
  assert.ok(pixels[0] > 5000 && pixels[1] > 1000, `${pixels} pixels are covered`);
  assert.deepEqual(problems, []);
});

test('without one, a view at rest is smooth beyond the size of the view that moved last', async () => {
  const { page, problems } = await views([360, 160]);
  await page.evaluate(async () => {
    const [large, small] = await Promise.all([...document.querySelectorAll('synthetica-linkage')].map((one) => one.workbench));
    // It moves without its shadows, which cover more; the small one comes after it.
    large.player.draw();
    small.player.draw();
    globalThis.edge = small.scene.canvas.width;
    globalThis.moving = globalThis.covered(0, globalThis.edge);
  });
  await page.waitForFunction(() => globalThis.covered(0, globalThis.edge) > globalThis.moving + 100);
  assert.deepEqual(problems, []);
});

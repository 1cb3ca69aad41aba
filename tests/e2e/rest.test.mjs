// Pictures without a graphics card: quick while something moves, with smooth edges at rest, and in the same colours.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { openBrowser } from './browser.mjs';

test('edges are smooth at rest only, and the picture has the same colours then', async () => {
  const browser = await openBrowser();
  try {
    const { page, problems } = await browser.blankPage({ viewport: { width: 900, height: 700 }, reducedMotion: 'reduce' });
    await page.addInitScript(() => {
      globalThis.smooth = 0;
      const { blitFramebuffer } = WebGL2RenderingContext.prototype;
      WebGL2RenderingContext.prototype.blitFramebuffer = function (...part) {
        globalThis.smooth += 1;
        blitFramebuffer.apply(this, part);
      };
    });
    await page.goto(browser.address);
    await page.waitForFunction(() => globalThis.smooth > 0);
    await page.evaluate(async () => {
      const { store, scene, player } = await document.querySelector('synthetica-linkage').workbench;
      /** The last picture of each kind; in the task in which it is drawn a canvas can be read. */
      globalThis.pictures = {};
      const { draw } = player;
      player.draw = () => {
        const before = globalThis.smooth;
        draw();
        const drawn = scene.canvas.nextElementSibling;
        const pen = new OffscreenCanvas(drawn.width, drawn.height).getContext('2d', { willReadFrequently: true });
        pen.drawImage(drawn, 0, 0);
        globalThis.pictures[globalThis.smooth > before ? 'resting' : 'moving'] = pen.getImageData(0, 0, drawn.width, drawn.height).data;
      };
      // Shadows are in the picture at rest too: most of them lie on the ground.
      store.setView({ show: { ...store.view.show, ground: false } });
    });
    await page.waitForFunction(() => globalThis.pictures.moving && globalThis.pictures.resting);
    const seen = await page.evaluate(() => {
      const { moving, resting } = globalThis.pictures;
      const edges = { moving: 0, resting: 0 };
      let [bodies, others] = [0, 0];
      for (let at = 0; at < moving.length; at += 4) {
        const through = [moving, resting].map((data) => data[at + 3] < 255);
        if (through[0] && moving[at + 3] > 0) edges.moving += 1;
        if (through[1] && resting[at + 3] > 0) edges.resting += 1;
        if (through.includes(true)) continue;
        bodies += 1;
        if ([0, 1, 2].some((colour) => Math.abs(moving[at + colour] - resting[at + colour]) > 40)) others += 1;
      }
      return { edges, bodies, others };
    });
    assert.ok(seen.edges.resting > seen.edges.moving + 1000, `half covered pixels: ${JSON.stringify(seen)}`);
    assert.ok(seen.bodies > 5000 && seen.others < 0.1 * seen.bodies, `pixels with another colour: ${JSON.stringify(seen)}`);
    assert.deepEqual(problems, []);
  } finally {
    await browser.close();
  }
});

test('a picture that is exported while the view moves has its shadows, on the ground too', async () => {
  const browser = await openBrowser();
  try {
    const { page, problems } = await browser.openPage({ reducedMotion: 'reduce' });
    const { others, all } = await page.evaluate(async () => {
      const element = document.querySelector('synthetica-linkage');
      const { player, scene } = await element.workbench;
      const picture = async () => {
        const bitmap = await createImageBitmap(await element.toImage({ width: 400, height: 300 }));
        const pen = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
        pen.drawImage(bitmap, 0, 0);
        return pen.getImageData(0, 0, bitmap.width, bitmap.height).data;
      };
      while (!(scene.canvas.dataset.draws > 1)) await new Promise(requestAnimationFrame);
      const resting = await picture();
      // Twice at once: the second picture is one of a view that moves.
      player.draw();
      player.draw();
      const moving = await picture();
      return { others: resting.filter((value, at) => Math.abs(value - moving[at]) > 8).length, all: resting.length };
    });
    assert.equal(others, 0, `${others} of ${all} values are others`);
    assert.deepEqual(problems, []);
  } finally {
    await browser.close();
  }
});

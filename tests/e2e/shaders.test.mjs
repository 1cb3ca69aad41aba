// What the build leaves out of the 3D library's shaders is asked for by none that is compiled.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { NEVER_DEFINED } from '../../tools/lean/shaders.js';
import { openBrowser } from './browser.mjs';

test('no shader is compiled with what the build has left out, and each program can be made, before there is a motion too', async () => {
  const browser = await openBrowser();
  try {
    const { page, problems } = await browser.blankPage({ viewport: { width: 1280, height: 800 } });
    await page.addInitScript(() => {
      globalThis.shaders = [];
      globalThis.programs = [];
      const { shaderSource, linkProgram } = WebGL2RenderingContext.prototype;
      WebGL2RenderingContext.prototype.linkProgram = function (program) {
        // Asked at once it would be waited for.
        globalThis.programs.push({ planned: Boolean(document.querySelector('synthetica-linkage').trajectory), log: () => (this.getProgramParameter(program, this.LINK_STATUS) ? '' : this.getProgramInfoLog(program)) });
        linkProgram.call(this, program);
      };
      WebGL2RenderingContext.prototype.shaderSource = function (shader, text) {
        globalThis.shaders.push(text);
        shaderSource.call(this, shader, text);
      };
    });
    await page.goto(browser.address);
    await page.locator('#canvas').focus();
    // A part that is pointed at is outlined, and can be moved by its handles.
    for (let i = 0; i < 4; i += 1) await page.keyboard.press(']');
    await page.keyboard.press('Enter');
    // The lit materials are among them.
    await page.waitForFunction(() => ['STANDARD', 'USE_SHADOWMAP'].every((name) => globalThis.shaders.some((text) => text.includes(`#define ${name}`))));
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
    const shaders = await page.evaluate(() => globalThis.shaders);
    const defined = new Set(shaders.flatMap((text) => [...text.matchAll(/^#define (\w+)/gm)].map(([, name]) => name)));
    const programs = await page.evaluate(() => globalThis.programs.map(({ planned, log }) => ({ planned, log: log() })));
    assert.deepEqual(programs.filter(({ log }) => log), []);
    // Four draw the first picture; what is packed shares one.
    assert.ok(programs.filter(({ planned }) => !planned).length >= 4, JSON.stringify(programs));
    assert.deepEqual(NEVER_DEFINED.filter((name) => defined.has(name)), []);
    assert.deepEqual(problems, []);
  } finally {
    await browser.close();
  }
});

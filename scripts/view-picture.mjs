// The applet's view of a sample as a picture, for the scripts that make the site's pictures from the built page.
import { LAUNCH, lookInside } from '../tests/e2e/browser.mjs';
import { chromium } from 'playwright-core';
import { preview } from 'vite';

/** Share of the motion at which it is shown: the linkage bent, its motion before and behind it. */
const MOMENT = 0.35;

/** The built page in a browser. */
export async function openApplet() {
  const server = await preview({ configFile: 'tools/vite.config.js', preview: { port: 0 } });
  const browser = await chromium.launch(LAUNCH);
  const context = await browser.newContext({ viewport: { width: 1600, height: 1000 }, colorScheme: 'light', reducedMotion: 'reduce' });
  // Without the first minute, which marks what it speaks of.
  await context.addInitScript(() => localStorage.setItem('synthetica.first-minute', 'in a picture'));
  await context.addInitScript(lookInside);
  return {
    context,
    address: server.resolvedUrls.local[0],
    async close() {
      await browser.close();
      await server.close();
    },
  };
}

/**
 * @param {Awaited<ReturnType<typeof openApplet>>} applet @param {string} file of a sample @param {{width: number, height: number}} size
 * @returns {Promise<{page: import('playwright-core').Page, shot: Buffer}>} the page that shows it, and a PNG
 */
export async function viewOf({ context, address }, file, size) {
  const page = await context.newPage();
  await page.goto(`${address}?sample=${file}`);
  await page.waitForFunction(() => (page$('#closure')?.textContent ?? '–') !== '–');
  // Only the picture: without what lies over the view, in its proportions.
  await page.evaluate(({ width, height }) => {
    const canvas = page$('#canvas');
    for (const other of canvas.parentElement.children) if (!other.matches('canvas')) other.style.display = 'none';
    Object.assign(canvas.parentElement.style, { position: 'fixed', left: '0', top: '0', width: `${width}px`, height: `${height}px`, zIndex: '99' });
  }, size);
  await page.waitForTimeout(300);
  for (const key of ['Home', '+']) await page.locator('#canvas').press(key);
  // Without the ring of the focus.
  await page.locator('#canvas').blur();
  const last = Number(await page.locator('#scrub').getAttribute('max'));
  await page.locator('#scrub').fill(String(Math.round(last * MOMENT)));
  // The scene draws its shadows when it has come to rest.
  await page.waitForTimeout(1200);
  return { page, shot: await page.screenshot({ clip: { x: 0, y: 0, ...size } }) };
}

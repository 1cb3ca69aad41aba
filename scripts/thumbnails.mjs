// Makes the pictures of the examples, www/thumbnails/*.webp, from the built page: scripts/dev.sh build, then
// `node scripts/thumbnails.mjs`, or with the files of some samples only.
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { LAUNCH, lookInside } from '../tests/e2e/browser.mjs';
import { chromium } from 'playwright-core';
import { preview } from 'vite';

/** Pixels of a picture, and bytes that it may have. */
const SIZE = { width: 360, height: 240 };
const MAX_BYTES = 6000;

/** The view is drawn larger than its picture: smooth edges, and links as thin as they look on the page. */
const VIEW = { width: 720, height: 480 };

/** Share of the motion at which it is shown: the linkage bent, its motion before and behind it. */
const MOMENT = 0.35;

const folder = new URL('../www/thumbnails/', import.meta.url);
const wanted = process.argv.slice(2);
const samples = JSON.parse(readFileSync(new URL('../www/mechanisms/index.json', import.meta.url), 'utf8')).filter(({ file }) => !wanted.length || wanted.includes(file));
mkdirSync(folder, { recursive: true });
const server = await preview({ configFile: 'tools/vite.config.js', preview: { port: 0 } });
const browser = await chromium.launch(LAUNCH);
const context = await browser.newContext({ viewport: { width: 1600, height: 1000 }, colorScheme: 'light', reducedMotion: 'reduce' });
// Without the first minute, which marks what it speaks of.
await context.addInitScript(() => localStorage.setItem('synthetica.first-minute', 'in a picture'));
await context.addInitScript(lookInside);
for (const { file } of samples) {
  const page = await context.newPage();
  await page.goto(`${server.resolvedUrls.local[0]}?sample=${file}`);
  await page.waitForFunction(() => (page$('#closure')?.textContent ?? '–') !== '–');
  // Only the picture: without what lies over the view, in its proportions.
  await page.evaluate(({ width, height }) => {
    const canvas = page$('#canvas');
    for (const other of canvas.parentElement.children) if (other !== canvas) other.style.display = 'none';
    Object.assign(canvas.parentElement.style, { position: 'fixed', left: '0', top: '0', width: `${width}px`, height: `${height}px`, zIndex: '99' });
  }, VIEW);
  await page.waitForTimeout(300);
  for (const key of ['Home', '+']) await page.locator('#canvas').press(key);
  // Without the ring of the focus.
  await page.locator('#canvas').blur();
  const last = Number(await page.locator('#scrub').getAttribute('max'));
  await page.locator('#scrub').fill(String(Math.round(last * MOMENT)));
  // The scene draws its shadows when it has come to rest.
  await page.waitForTimeout(1200);
  const shot = await page.screenshot({ clip: { x: 0, y: 0, ...VIEW } });
  const picture = await page.evaluate(
    async ({ bytes, width, height, most }) => {
      const bitmap = await createImageBitmap(new Blob([new Uint8Array(bytes)]), { resizeWidth: width, resizeHeight: height, resizeQuality: 'high' });
      const canvas = new OffscreenCanvas(width, height);
      canvas.getContext('2d').drawImage(bitmap, 0, 0);
      for (let quality = 0.9; ; quality -= 0.05) {
        const blob = await canvas.convertToBlob({ type: 'image/webp', quality });
        if (blob.size <= most || quality < 0.1) return [...new Uint8Array(await blob.arrayBuffer())];
      }
    },
    { bytes: [...shot], ...SIZE, most: MAX_BYTES },
  );
  writeFileSync(new URL(file.replace('.json', '.webp'), folder), Buffer.from(picture));
  console.log(`${file}: ${picture.length} bytes`);
  await page.close();
}
await browser.close();
await server.close();

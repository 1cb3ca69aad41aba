// Makes the pictures of the examples, www/thumbnails/*.webp, from the built page: scripts/dev.sh build, then
// `node scripts/thumbnails.mjs`, or with the files of some samples only.
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { openApplet, viewOf } from './view-picture.mjs';

/** Pixels of a picture, and bytes that it may have. */
const SIZE = { width: 360, height: 240 };
const MAX_BYTES = 6000;

/** The view is drawn larger than its picture: smooth edges, and links as thin as they look on the page. */
const VIEW = { width: 720, height: 480 };

const folder = new URL('../www/thumbnails/', import.meta.url);
const wanted = process.argv.slice(2);
const samples = JSON.parse(readFileSync(new URL('../www/mechanisms/index.json', import.meta.url), 'utf8')).filter(({ file }) => !wanted.length || wanted.includes(file));
mkdirSync(folder, { recursive: true });
const applet = await openApplet();
for (const { file } of samples) {
  const { page, shot } = await viewOf(applet, file, VIEW);
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
await applet.close();

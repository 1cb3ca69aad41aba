// Makes the pictures that other sites show of links to the pages, www/public/cards/*.jpg, from the built page and the texts of
// tools/site-pages.js: scripts/dev.sh build, then `node scripts/cards.mjs`, or with the names of some pages only.
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { NAVIGATION } from '../tools/site-pages.js';
import { openApplet, viewOf } from './view-picture.mjs';

/** What all of them accept without cutting. */
const SIZE = { width: 1200, height: 630 };
const QUALITY = 78;

/** Which sample a page shows. */
const SHOWN = { index: '3rps.json', gallery: 'hexapod.json', course: 'four-bar.json', method: '2tpr.json', reference: 'delta.json', get: 'agile-eye.json' };

const read = (path) => readFileSync(new URL(`../www/${path}`, import.meta.url), 'utf8');
const applet = { name: 'index', title: 'Motions of constrained linkages', description: read('index.html').match(/<meta name="description" content="([^"]*)"/)[1] };
const folder = new URL('../www/public/cards/', import.meta.url);
const wanted = process.argv.slice(2);
mkdirSync(folder, { recursive: true });

const card = ({ title, description }, shot) => `<!doctype html><style>
  ${read('style/base.css')}
  :root { color-scheme: light; }
  body { margin: 0; width: ${SIZE.width}px; height: ${SIZE.height}px; position: relative; overflow: hidden; background: url(data:image/png;base64,${shot.toString('base64')}) top / 100% auto no-repeat var(--panel); }
  div { position: absolute; inset: auto 0 0; padding: 30px 56px 36px; background: color-mix(in srgb, var(--panel) 92%, transparent); }
  p { font-size: 27px; line-height: 1.35; color: var(--muted); }
  h1 { font: 600 54px/1.25 var(--serif); }
  b { position: absolute; left: 56px; top: 36px; display: flex; gap: 14px; align-items: center; font: italic 600 40px/1 var(--serif); }
  svg { width: 52px; height: 52px; }
</style><b>${read('icon.svg')}Synthetica</b><div><h1>${title}</h1><p>${description}</p></div>`;

const opened = await openApplet();
for (const page of [applet, ...NAVIGATION].filter(({ name }) => !wanted.length || wanted.includes(name))) {
  // The words lie over the lower part of the card, the linkage above them.
  const { page: view, shot } = await viewOf(opened, SHOWN[page.name], { width: SIZE.width, height: SIZE.height - 205 });
  await view.close();
  const drawn = await opened.context.newPage();
  await drawn.setViewportSize(SIZE);
  await drawn.setContent(card(page, shot));
  const picture = await drawn.screenshot({ type: 'jpeg', quality: QUALITY });
  writeFileSync(new URL(`${page.name}.jpg`, folder), picture);
  console.log(`${page.name}: ${picture.length} bytes`);
  await drawn.close();
}
await opened.close();

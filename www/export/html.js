/**
 * One HTML file that plays the solved motion by itself: the player, the scene and the numbers in it, nothing to load.
 */
import { script, style } from '../player-page/main.js?bundle';
import { pack } from '../player-page/pack.js';
import { withoutGhost } from '../core/best-motions.js';
import { saveFile } from './save.js';
import { shownName } from './shown-name.js';
import { inert } from './inert.js';

/** @param {import('../element/workbench.js').App} app */
export async function exportHtml({ store, say }) {
  const { motion, doc, plain } = store.result;
  if (!motion || !doc || !plain) return;
  const name = shownName(store.result, 'html');
  saveFile(name, new Blob([await page(doc, await pack(motion, doc, plain))], { type: 'text/html' }));
  const without = withoutGhost(motion);
  say(`Saved ${name}: it plays in any browser, also without a network.${without && ` ${without}.`}`);
}

/** @param {import('../core/types.js').MechanismDocument} doc @param {string} motion packed */
async function page(doc, motion) {
  const code = inert(script);
  // The file may run this one script and use this one style sheet, by their hashes, and load nothing at all.
  const [scripts, styles] = await Promise.all([allowed(code), allowed(style)]);
  return `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; script-src ${scripts}; style-src ${styles}; base-uri 'none'; form-action 'none'">
<title>${escaped(doc.name || 'Linkage')} – Synthetica</title>
<style>${style}</style>
</head>
<body>
<noscript>This page plays a linkage's motion and needs JavaScript for it.</noscript>
<script type="text/plain" id="motion">${motion}</script>
<script type="module">${code}</script>
</body>
</html>
`;
}

/** The policy's source for a text; where the page is not served securely there is no hash function. @param {string} text */
async function allowed(text) {
  if (!crypto.subtle) return "'unsafe-inline'";
  const hash = new Uint8Array(await crypto.subtle.digest('SHA-256', new TextEncoder().encode(text)));
  return `'sha256-${btoa(String.fromCharCode(...hash))}'`;
}

/** @param {string} text */
const escaped = (text) => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('"', '&quot;');

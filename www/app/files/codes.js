/**
 * A linkage as code for other people's pages: a frame, an element, a whole file. For the dialog Share, and at build for the
 * gallery. No DOM.
 *
 * @typedef {{controls: boolean, autoplay: boolean, readonly: boolean, panels: string[], height: number}} Wish `height` in CSS pixels
 */

import { inert } from '../../export/inert.js';

/** Text for an attribute. @param {string} text */
const quoted = (text) => text.replaceAll('&', '&amp;').replaceAll('"', '&quot;').replaceAll('<', '&lt;');

/** JSON inside a script element: nothing in it may look like the element's end. @param {string} text */
const inScript = (text) => text.replaceAll('<', '\\u003c');

/** @param {string} address of a frame's page @param {string} name of the linkage @param {number} height in CSS pixels */
export const frameTag = (address, name, height) =>
  `<iframe src="${quoted(address)}" title="${quoted(name)}" width="100%" height="${height}" loading="lazy" style="border: 0"></iframe>`;

/**
 * The element's script: a classic one, which a page may load from another server whatever that answers, where a module would
 * need a header of it.
 * @param {string} address of inline.js
 */
export const scriptTag = (address) => `<script src="${quoted(address)}" async></script>`;

/** @param {string} name @param {string} home the applet's own address @param {string} payload the document, packed @param {Wish} wish */
export function frameCode(name, home, payload, { controls, autoplay, readonly, panels, height }) {
  const query = [
    ...(controls ? [] : ['controls=0']),
    ...(autoplay ? ['autoplay', 'bounce'] : []),
    ...(readonly ? ['readonly'] : []),
    ...(panels.length ? [`panels=${panels.join('+')}`] : []),
  ].join('&');
  const address = `${new URL('embed.html', home).href}${query && `?${query}`}#d=${payload}`;
  return frameTag(address, name, height);
}

/** @param {string} text a document @param {Wish} wish */
function element(text, { controls, autoplay, readonly, panels, height }) {
  const attributes = [
    ...(controls ? ['controls'] : []),
    ...(autoplay ? ['autoplay', 'bounce'] : []),
    ...(readonly ? ['readonly'] : []),
    ...(panels.length ? [`panels="${panels.join(' ')}"`] : []),
    `style="height: ${height}px"`,
  ].join(' ');
  return `<synthetica-linkage ${attributes}>
  <script type="application/json">${inScript(text)}</script>
</synthetica-linkage>`;
}

/** The tag and its script. @param {string} text a document @param {string} home the applet's own address @param {Wish} wish */
export const elementCode = (text, home, wish) => `${element(text, wish)}\n${scriptTag(new URL('inline.js', home).href)}`;

/**
 * One file with everything in it.
 * @param {string} name @param {string} text a document @param {string} script all that the element needs, as a classic script @param {Wish} wish
 */
export const fileCode = (name, text, script, wish) => `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>${quoted(name)}</title>
</head>
<body>
<h1>${quoted(name)}</h1>
${element(text, wish)}
<script>${inert(script)}</script>
</body>
</html>
`;

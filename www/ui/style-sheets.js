/**
 * Style sheets of trees: one sheet for all of a document that wear it. A content policy has nothing against it.
 */
import { windowOf } from './dom.js';

/** A sheet belongs to the document of the window that made it. @type {WeakMap<object, Map<string, CSSStyleSheet>>} */
const sheets = new WeakMap();

/** @param {Document | ShadowRoot} root @param {string} css */
export function wear(root, css) {
  const window = windowOf(root instanceof Document ? root.documentElement : root);
  const own = sheets.get(window.document) ?? new Map();
  sheets.set(window.document, own);
  const sheet = own.get(css) ?? new window.CSSStyleSheet();
  if (!own.has(css)) sheet.replaceSync(css);
  own.set(css, sheet);
  if (!root.adoptedStyleSheets.includes(sheet)) root.adoptedStyleSheets = [...root.adoptedStyleSheets, sheet];
}

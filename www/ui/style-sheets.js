/**
 * Style sheets of trees: one sheet for all that wear it. A content policy has nothing against it.
 */

/** @type {Map<string, CSSStyleSheet>} */
const sheets = new Map();

/** @param {Document | ShadowRoot} root @param {string} css */
export function wear(root, css) {
  let sheet = sheets.get(css);
  if (!sheet) {
    sheet = new CSSStyleSheet();
    sheet.replaceSync(css);
    sheets.set(css, sheet);
  }
  if (!root.adoptedStyleSheets.includes(sheet)) root.adoptedStyleSheets = [...root.adoptedStyleSheets, sheet];
}

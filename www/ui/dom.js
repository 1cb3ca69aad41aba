/**
 * Making elements in one expression.
 */

/**
 * @template {keyof HTMLElementTagNameMap} K
 * @param {K} tag
 * @param {Record<string, string | number | boolean | undefined | ((event: any) => void)>} [attributes] a function is a listener
 * @param {...(Node | string)} children
 * @returns {HTMLElementTagNameMap[K]}
 */
export function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === 'function') made.addEventListener(name, value);
    else if (value === true) made.setAttribute(name, '');
    else if (value !== undefined && value !== false) made.setAttribute(name, String(value));
  }
  made.append(...children);
  return made;
}

/**
 * Elements by their id in a tree: the page's own, or a shadow tree's.
 * @typedef {<T extends Element = HTMLElement>(id: string) => T} Find
 */

/** @param {Document | ShadowRoot} root @returns {Find} */
export const finder = (root) => (id) => /** @type {any} */ (root.getElementById(id));

/** In the page itself. @type {Find} */
export const byId = (id) => /** @type {any} */ (document.getElementById(id));

/**
 * The window that shows a node: another than the one the script runs in, where the element was adopted by another document.
 * @param {Node} node @returns {Window & typeof globalThis}
 */
export const windowOf = (node) => /** @type {any} */ (node.ownerDocument?.defaultView ?? globalThis);

/** What has the focus in the tree that holds a node; of another tree only its host is seen. @param {Node} node */
export const focusBeside = (node) => /** @type {Document | ShadowRoot} */ (node.getRootNode()).activeElement ?? null;

/** What an event happened to, also inside an element's shadow tree. @param {Event} event @returns {Element | null} */
export const targetOf = (event) => /** @type {Element | null} */ (event.composedPath()[0] ?? null);

/**
 * Writes text only where it changed, so that screen readers and layout are left alone.
 * @param {Element} target
 * @param {string} text
 */
export function setText(target, text) {
  if (target.textContent !== text) target.textContent = text;
}

// All pages of the site with their text: what is in the navigation, and the parts of the reference.
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { render } from './markdown.js';
import { referencePages } from './reference-pages.js';

const folder = fileURLToPath(new URL('../www/pages/', import.meta.url));

/**
 * In the order of the navigation, some with a script for what is alive in them; the text of NAME.html is www/pages/NAME.md.
 * @type {{name: string, title: string, description: string, script?: string}[]}
 */
export const NAVIGATION = [
  { name: 'gallery', title: 'Gallery', description: 'Spatial linkages to open, change and animate in the browser.', script: './pages/embed-codes.js' },
  { name: 'course', title: 'Course', description: 'Mobility, and how close a linkage can come: a lecture with live linkages.', script: './element/embed.js' },
  { name: 'method', title: 'Method', description: 'How the closest reachable motion of a spatial linkage is found and certified, with the derivation.' },
  { name: 'reference', title: 'Reference', description: 'Document format, element, JavaScript package, frames and command of Synthetica.', script: './pages/old-addresses.js' },
  { name: 'get', title: 'How to get it', description: 'Synthetica for a site, a page or a program of your own: files, package, crate, command.' },
];

/** @typedef {{name: string, title: string, description: string, script?: string, part?: true, body: string, contents: import('./markdown.js').Heading[]}} Page */

/**
 * Links to a heading of the reference, wherever they stand, lead to the page that has it.
 * @param {Page} page @param {(id: string) => string | undefined} pageOf
 */
function withLinks(page, pageOf) {
  const own = new Set([...page.body.matchAll(/\bid="([^"]+)"/g)].map(([, id]) => id));
  const body = page.body.replaceAll(/href="(?:\.\/reference\.html)?#([^"]+)"/g, (link, id) => {
    if (link.startsWith('href="#') && own.has(id)) return link;
    const place = pageOf(id);
    if (!place) throw new Error(`${page.name}.html has a link to #${id}, which is the address of nothing`);
    return `href="./${place}.html#${id}"`;
  });
  return { ...page, body };
}

/** @returns {Page[]} */
export function sitePages() {
  const { parts, index, pageOf } = referencePages();
  const pages = NAVIGATION.map((page) => {
    if (page.name === 'reference') return { ...page, body: index, contents: [] };
    return { ...page, ...render(readFileSync(`${folder}${page.name}.md`, 'utf8')) };
  });
  return [...pages, ...parts.map((part) => ({ ...part, part: /** @type {const} */ (true) }))].map((page) => withLinks(page, pageOf));
}

// The reference in pages: one for each file of www/pages/reference, and reference.html, which leads to all of them.
import { readFileSync, readdirSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { render } from './markdown.js';

const folder = fileURLToPath(new URL('../www/pages/', import.meta.url));

/** The first sentence of a text, without markup. @param {string} source */
const firstSentence = (source) => {
  const paragraph = source.split('\n\n').find((text) => text && !text.startsWith('#')) ?? '';
  const plain = paragraph.replaceAll(/\[([^\]]*)\]\([^)]*\)/g, '$1').replaceAll(/[`*]/g, '').replaceAll(/\s+/g, ' ');
  return plain.match(/^.*?[.:](?= |$)/)?.[0].replace(/:$/, '.') ?? plain;
};

const idsOf = (html) => [...html.matchAll(/\bid="([^"]+)"/g)].map(([, id]) => id);

/** A link that is where an old address leads. @param {string} id @param {string} page @param {string} html */
const entry = (id, page, html) => `<a id="${id}" href="./${page}.html#${id}">${html}</a>`;

/** @param {{name: string, title: string, body: string, lead: string, contents: import('./markdown.js').Heading[]}} page */
function overview({ name, title, lead, body, contents }) {
  const [top] = idsOf(body);
  const headings = contents.map(({ id, html }) => `<li>${entry(id, name, html)}</li>`).join('');
  const fields = idsOf(body).filter((id) => id.startsWith('fields-'));
  const fieldLinks = fields.map((id) => entry(id, name, id.replace('fields-', '').replace(/Entry$/, '').replaceAll(/(.)([A-Z])/g, '$1 $2').toLowerCase())).join(', ');
  return `<h2>${entry(top, name, title)}</h2>
<p>${lead.replaceAll('&', '&amp;').replaceAll('<', '&lt;')}</p>
${headings ? `<ul class="overview">${headings}</ul>` : ''}${fields.length ? `\n<p class="overview">Fields of: ${fieldLinks}</p>` : ''}
`;
}

/**
 * @returns {{parts: {name: string, title: string, description: string, body: string, contents: import('./markdown.js').Heading[]}[], index: string,
 *   pageOf: (id: string) => string | undefined}} the pages, the text of reference.html, and which page has an address
 */
export function referencePages() {
  // What was one page has no address twice, so that old ones lead to one place.
  const ids = new Set();
  const parts = readdirSync(`${folder}reference`).sort().map((file) => {
    const source = readFileSync(`${folder}reference/${file}`, 'utf8');
    const [, title] = source.match(/^## (.*)$/m) ?? [];
    if (!title) throw new Error(`www/pages/reference/${file} does not begin with its title as a heading of the second level: ## Title`);
    const lead = firstSentence(source);
    const name = `reference-${file.replace(/^\d+-/, '').replace('.md', '')}`;
    return { name, title, lead, description: `${title}: ${lead}`, ...render(source, { raise: 1, ids }) };
  });
  const places = new Map(parts.flatMap(({ name, body }) => idsOf(body).map((id) => [id, name])));
  return {
    parts,
    index: render(readFileSync(`${folder}reference.md`, 'utf8')).body + parts.map(overview).join(''),
    pageOf: (id) => places.get(id),
  };
}

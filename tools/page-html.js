// A page of the site as HTML: head, navigation, text, footer.
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { NAVIGATION } from './site-pages.js';

const applet = fileURLToPath(new URL('../www/index.html', import.meta.url));

/** @typedef {import('./site-pages.js').Page} Page */

const link = (/** @type {{name: string, title: string}} */ { name, title }, /** @type {string} */ current) => `<a href="./${name}.html"${current && ` aria-current="${current}"`}>${title}</a>`;

/** The pages of the site; a part of the reference is within that. @param {Page} page */
const navigation = (page) =>
  NAVIGATION.map((other) => link(other, other.name === page.name ? 'page' : page.part && other.name === 'reference' ? 'true' : '')).join('');

/** The headings of a page that has many. @param {Page['contents']} contents */
function aside(contents) {
  if (contents.filter(({ level }) => level === 'h2').length <= 3) return '';
  const items = contents.map(({ id, level, html }) => `<li class="${level}"><a href="#${id}">${html}</a></li>`).join('');
  return `<nav class="contents" aria-label="On this page"><p aria-hidden="true">On this page</p><ul>${items}</ul></nav>`;
}

/** The parts of the reference, and those before and after one. @param {Page} page @param {Page[]} parts */
function ways(page, parts) {
  if (!page.part) return { before: '', after: '' };
  const at = parts.findIndex(({ name }) => name === page.name);
  const [last, next] = [parts[at - 1], parts[at + 1]];
  const step = (/** @type {Page | undefined} */ part, /** @type {string} */ word) => (part ? `<a rel="${word === 'Before' ? 'prev' : 'next'}" href="./${part.name}.html">${word}: ${part.title}</a>` : '');
  return {
    before: `<nav class="parts" aria-label="Parts of the reference">${parts.map((part) => link(part, part.name === page.name ? 'page' : '')).join('')}</nav>`,
    after: `<nav class="steps" aria-label="Next parts">${step(last, 'Before')}${step(next, 'Next')}</nav>`,
  };
}

/** @param {Page} page */
export const titleOf = ({ title, part }) => `${title}${part ? ' – Reference' : ''} – Synthetica`;

/** A whole page, as Vite takes an HTML file. @param {Page} page @param {Page[]} pages all of them */
export function html(page, pages) {
  const policy = readFileSync(applet, 'utf8').match(/<meta\s+http-equiv="Content-Security-Policy"[^>]*>/)[0];
  const { before, after } = ways(page, pages.filter(({ part }) => part));
  const contents = aside(page.contents);
  return `<!doctype html>
<html lang="en">
  <head>
    <meta charset="utf-8" />
    <meta name="viewport" content="width=device-width, initial-scale=1" />
    <meta name="color-scheme" content="light dark" />
    <meta name="description" content="${page.description.replaceAll('&', '&amp;').replaceAll('"', '&quot;')}" />
    ${policy}
    <title>${titleOf(page)}</title>
    <link rel="icon" href="./icon.svg" type="image/svg+xml" />
    <link rel="stylesheet" href="./style/pages.css" />
    <script src="/first.js"></script>${page.script ? `\n    <script type="module" src="${page.script}"></script>` : ''}
  </head>
  <body class="page-${page.part ? 'part' : page.name}">
    <a class="skip" href="#content">To the text</a>
    <header class="site">
      <a class="home" href="./"><img src="./icon.svg" alt="" width="24" height="24" />Synthetica</a>
      <nav aria-label="Site"><a href="./">Applet</a>${navigation(page)}</nav>
    </header>
    ${before}
    <div class="page">
      ${contents}
      <main id="content" tabindex="-1">
${page.body}
${after}
      </main>
    </div>
    <footer class="site">
      <p>Synthetica plans the closest reachable motions of spatial linkages. It runs in your browser, also offline, and asks nothing of any other host. MIT or Apache-2.0, at your choice; <a href="./licences.txt">licences</a> of all that is in it.</p>
      <p>Method: H.-J. Su, P. Dietmaier, J. M. McCarthy, <cite>Trajectory Planning for Constrained Parallel Manipulators</cite>, J. Mech. Des. 125 (2003), <a href="https://doi.org/10.1115/1.1623187">doi:10.1115/1.1623187</a>.</p>
    </footer>
  </body>
</html>
`;
}

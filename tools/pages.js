// The pages beside the applet: Markdown of www/pages as HTML, at build and in dev, for Vite.
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { basename, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { render } from './markdown.js';

const www = fileURLToPath(new URL('../www/', import.meta.url));
const schemaFile = fileURLToPath(new URL('../src/document/schema.json', import.meta.url));
const read = (file) => readFileSync(file, 'utf8');

/** In the order of the navigation, some with a script for what is alive in them; the text of NAME.html is www/pages/NAME.md, its sections those of www/pages/NAME/. */
const PAGES = [
  { name: 'gallery', title: 'Gallery', description: 'Spatial linkages to open, change and animate in the browser.' },
  { name: 'course', title: 'Course', description: 'Mobility, and how close a linkage can come: a lecture with live linkages.', script: './element/embed.js' },
  { name: 'method', title: 'Method', description: 'How the closest reachable motion of a spatial linkage is found and certified, with the derivation.' },
  { name: 'reference', title: 'Reference', description: 'Document format, element, JavaScript package and command of Synthetica.' },
].filter(({ name }) => existsSync(join(www, 'pages', `${name}.md`)));

/** What other pages and programs may count on: addresses without a hash. @returns {{[address: string]: string}} address → file */
function lastingFiles() {
  const folder = join(www, 'mechanisms');
  const samples = readdirSync(folder).map((file) => [`mechanisms/${file}`, join(folder, file)]);
  return { 'schema/document-1.json': schemaFile, ...Object.fromEntries(samples) };
}

const sourceOf = ({ name }) => {
  const sections = join(www, 'pages', name);
  const files = existsSync(sections) ? readdirSync(sections).sort() : [];
  return [`${name}.md`, ...files.map((file) => join(name, file))].map((file) => read(join(www, 'pages', file))).join('\n\n');
};

/** A whole page, as Vite takes an HTML file. @param {typeof PAGES[number]} page */
function html(page) {
  const { body, contents } = render(sourceOf(page));
  const policy = read(join(www, 'index.html')).match(/<meta\s+http-equiv="Content-Security-Policy"[^>]*>/)[0];
  const link = ({ name, title }) => `<a href="./${name}.html"${name === page.name ? ' aria-current="page"' : ''}>${title}</a>`;
  const aside = `<nav class="contents" aria-label="On this page"><p aria-hidden="true">On this page</p><ul>${contents.map(({ id, level, html }) => `<li class="${level}"><a href="#${id}">${html}</a></li>`).join('')}</ul></nav>`;
  return `<!doctype html>
<html lang="en">
  <head>
    <meta charset="utf-8" />
    <meta name="viewport" content="width=device-width, initial-scale=1" />
    <meta name="color-scheme" content="light dark" />
    <meta name="description" content="${page.description}" />
    ${policy}
    <title>${page.title} – Synthetica</title>
    <link rel="icon" href="./icon.svg" type="image/svg+xml" />
    <link rel="stylesheet" href="./style/pages.css" />
    <script src="/first.js"></script>${page.script ? `\n    <script type="module" src="${page.script}"></script>` : ''}
  </head>
  <body class="page-${page.name}">
    <a class="skip" href="#content">To the text</a>
    <header class="site">
      <a class="home" href="./"><img src="./icon.svg" alt="" width="24" height="24" />Synthetica</a>
      <nav aria-label="Site"><a href="./">Applet</a>${PAGES.map(link).join('')}</nav>
    </header>
    <div class="page">
      ${contents.filter(({ level }) => level === 'h2').length > 3 ? aside : ''}
      <main id="content" tabindex="-1">
${body}
      </main>
    </div>
    <footer class="site">
      <p>Synthetica plans the closest reachable motions of spatial linkages. It runs in your browser, also offline, and asks nothing of any other host. MIT or Apache-2.0, at your choice.</p>
      <p>Method: H.-J. Su, P. Dietmaier, J. M. McCarthy, <cite>Trajectory Planning for Constrained Parallel Manipulators</cite>, J. Mech. Des. 125 (2003), <a href="https://doi.org/10.1115/1.1623187">doi:10.1115/1.1623187</a>.</p>
    </footer>
  </body>
</html>
`;
}

/** The plugin: the pages as entries of the build, the lasting files as they are, both in dev too. */
export function pages() {
  const pageAt = (address) => PAGES.find(({ name }) => `${name}.html` === address);
  const pageOf = (id) => (id.startsWith(www) ? pageAt(id.slice(www.length)) : undefined);
  return {
    name: 'pages',
    enforce: 'pre',
    config: () => ({ build: { rolldownOptions: { input: Object.fromEntries(PAGES.map(({ name }) => [name, join(www, `${name}.html`)])) } } }),
    resolveId: (id) => (pageOf(id) ? id : null),
    load: (id) => (pageOf(id) ? html(pageOf(id)) : null),
    generateBundle() {
      for (const [fileName, file] of Object.entries(lastingFiles())) this.emitFile({ type: 'asset', fileName, source: read(file) });
    },
    configureServer(server) {
      server.watcher.on('change', (file) => {
        if (file.startsWith(join(www, 'pages'))) server.hot.send({ type: 'full-reload' });
      });
      server.middlewares.use(async (request, response, next) => {
        const address = new URL(request.url, 'http://page').pathname.slice(server.config.base.length);
        const page = pageAt(address);
        if (page) {
          response.setHeader('content-type', 'text/html');
          response.end(await server.transformIndexHtml(request.url, html(page)));
        } else if (basename(address) === 'document-1.json') {
          response.setHeader('content-type', 'application/json');
          response.end(read(schemaFile));
        } else next();
      });
    },
  };
}

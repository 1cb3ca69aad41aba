// The pages beside the applet: Markdown of www/pages as HTML, at build and in dev, for Vite.
import { readFileSync, readdirSync } from 'node:fs';
import { basename, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { html, titleOf } from './page-html.js';
import { sitePages } from './site-pages.js';
import { socialTags } from './social.js';

const www = fileURLToPath(new URL('../www/', import.meta.url));
const schemaFile = fileURLToPath(new URL('../src/document/schema.json', import.meta.url));
const read = (file) => readFileSync(file, 'utf8');

/** What other pages and programs may count on: addresses without a hash. @returns {{[address: string]: string}} address → file */
function lastingFiles() {
  const folders = ['mechanisms', 'thumbnails'].flatMap((folder) => readdirSync(join(www, folder)).map((file) => [`${folder}/${file}`, join(www, folder, file)]));
  return { 'schema/document-1.json': schemaFile, ...Object.fromEntries(folders) };
}

/** The applet's own page, of which the same is told to others. */
function applet() {
  const source = read(join(www, 'index.html'));
  const [, title] = source.match(/<title>(.*)<\/title>/);
  const [, description] = source.match(/<meta name="description" content="([^"]*)"/);
  return { address: '', title, description, card: 'index' };
}

/** The plugin: the pages as entries of the build, the lasting files as they are, both in dev too. */
export function pages() {
  const names = sitePages().map(({ name }) => name);
  let made;
  const all = () => (made ??= sitePages());
  const pageAt = (address) => all().find(({ name }) => `${name}.html` === address);
  const isPage = (id) => id.startsWith(www) && names.includes(id.slice(www.length).replace(/\.html$/, ''));
  return {
    name: 'pages',
    enforce: 'pre',
    config: () => ({ build: { rolldownOptions: { input: Object.fromEntries(names.map((name) => [name, join(www, `${name}.html`)])) } } }),
    resolveId: (id) => (isPage(id) ? id : null),
    load: (id) => (isPage(id) ? html(pageAt(id.slice(www.length)), all()) : null),
    transformIndexHtml: {
      order: 'post',
      handler(_, { path }) {
        const address = path.replace(/^\//, '');
        if (address === 'index.html') return socialTags(applet());
        const page = pageAt(address);
        if (!page) return [];
        return socialTags({ address, title: titleOf(page), description: page.description, card: page.part ? 'reference' : page.name });
      },
    },
    generateBundle(_, output) {
      for (const [fileName, file] of Object.entries(lastingFiles()).filter(([name]) => !(name in output))) this.emitFile({ type: 'asset', fileName, source: readFileSync(file) });
    },
    configureServer(server) {
      server.watcher.on('change', (file) => {
        if (!file.startsWith(join(www, 'pages'))) return;
        made = undefined;
        server.hot.send({ type: 'full-reload' });
      });
      server.middlewares.use(async (request, response, next) => {
        const address = new URL(request.url, 'http://page').pathname.slice(server.config.base.length);
        const page = pageAt(address);
        if (page) {
          response.setHeader('content-type', 'text/html');
          response.end(await server.transformIndexHtml(request.url, html(page, all())));
        } else if (basename(address) === 'document-1.json') {
          response.setHeader('content-type', 'application/json');
          response.end(read(schemaFile));
        } else next();
      });
    },
  };
}

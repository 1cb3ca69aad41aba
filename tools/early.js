// What the built page begins to load with its first bytes: its scripts and the sample that it shows, before the script that
// starts the planner's worker. A browser looks ahead in a page no further than to its content policy.

/** The sample that a first visit shows. */
const SAMPLE = '/mechanisms/3rps.json';

/** @param {string} html @param {Record<string, any>} bundle the files of the build @returns {string} */
export function loadsEarly(html, bundle) {
  const names = Object.keys(bundle);
  const worker = names.filter((name) => /^assets\/worker-[^/]*\.js$/.test(name));
  const sample = names.filter((name) => bundle[name].facadeModuleId?.includes(SAMPLE));
  const first = /\n *<script src="\.\/first\.js"><\/script>/;
  const main = /<script type="module" crossorigin src="([^"]+)"><\/script>/;
  const styles = /<link rel="stylesheet"[^>]*>/;
  if (worker.length !== 1 || sample.length !== 1 || ![first, main, styles].every((part) => part.test(html))) throw new Error(`The page is built in another way: see tools/early.js (${worker.length} workers, ${sample.length} samples)`);
  const [script, address] = main.exec(html) ?? [];
  const load = (/** @type {string} */ file) => `<link rel="modulepreload" crossorigin href="${file}">`;
  // It hears that the other cannot be loaded.
  const scripts = [load(`./${sample[0]}`), `<script src="./first.js" data-worker="./${worker[0]}"></script>`, script];
  return html
    .replace(first, '')
    .replace(main, load(address))
    .replace(styles, (link) => [link, ...scripts].join('\n    '));
}

/** Vite's plugin. */
export const early = () => ({
  name: 'early',
  apply: 'build',
  transformIndexHtml: { order: 'post', handler: (html, { bundle, path }) => (path === '/index.html' && bundle ? loadsEarly(html, bundle) : html) },
});

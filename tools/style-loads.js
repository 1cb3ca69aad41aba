// Replaces Vite's wrapper of dynamic imports: it loads a part's style sheets, then the part. Vite's own also preloads scripts,
// which mostly are there already, and is 2 kB more of the first load.

/** Vite's name of it. */
const WRAPPER = '\0vite/preload-helper.js';

/**
 * The wrapper, in the page: calls `load` once the style sheets are there. One that fails is taken out, and loaded again the next
 * time.
 * @template T @param {() => T} load @param {string[] | undefined} addresses of style sheets @param {string} base what they are relative to
 */
export function withStyles(load, addresses, base) {
  const sheet = (address) =>
    new Promise((resolve, reject) => {
      const { href } = new URL(address, base);
      const known = [...document.querySelectorAll('link')].find((link) => link.href === href);
      if (known?.sheet) return resolve();
      const link = known ?? Object.assign(document.createElement('link'), { rel: 'stylesheet', crossOrigin: '', href });
      link.addEventListener('load', resolve);
      link.addEventListener('error', () => {
        link.remove();
        reject(Error(`${href} cannot be loaded`));
      });
      if (!known) document.head.append(link);
    });
  return Promise.all((addresses ?? []).map(sheet)).then(load);
}

/** For `build.modulePreload.resolveDependencies`. @param {string} _ @param {string[]} files */
export const onlyStyles = (_, files) => files.filter((file) => file.endsWith('.css'));

/** Vite's plugin; a Vite that has another wrapper is a fault of the build. */
export const styleLoads = () => {
  let isReplaced = false;
  return {
    name: 'style-loads',
    apply: 'build',
    enforce: 'pre',
    load(/** @type {string} */ id) {
      if (id !== WRAPPER) return null;
      isReplaced = true;
      return `export const __vitePreload = ${withStyles};`;
    },
    generateBundle() {
      if (!isReplaced) throw new Error(`Vite has no ${JSON.stringify(WRAPPER)} any more: see tools/style-loads.js`);
    },
  };
};

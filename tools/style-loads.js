// Parts that are loaded when they are needed: their style sheets first. Vite's own wrap of such a load also begins with the
// scripts that its script imports; most are there already, and it is 2 kB of the first load.

/** Vite's name for what it wraps such a load in. */
const WRAP = '\0vite/preload-helper.js';

/** The wrap: `load` is called once the style sheets at `addresses`, from `base`, are in the page. One that fails is taken out: the next time it is loaded again. */
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

/** For `build.modulePreload`. */
export const onlyStyles = (_, files) => files.filter((file) => file.endsWith('.css'));

/** Vite's plugin. */
export const styleLoads = () => ({
  name: 'style-loads',
  apply: 'build',
  enforce: 'pre',
  load: (id) => (id === WRAP ? `export const __vitePreload = ${withStyles};` : null),
});

// What other sites show of a link to a page: title, sentence and picture.

/**
 * The site's own address, which the build cannot know: SITE_URL. Other sites ask for pictures by a whole address; without it
 * theirs is relative to the page, which some understand.
 */
function home() {
  const given = process.env.SITE_URL;
  if (!given) return undefined;
  if (!URL.canParse(given) || !/^https?:$/.test(new URL(given).protocol)) throw new Error(`SITE_URL is ${given}; it must be the site's whole address, such as https://example.org/synthetica/`);
  return new URL(given.endsWith('/') ? given : `${given}/`);
}

/** A file of the site. @param {string} path */
export const addressOf = (path) => (home() ? new URL(path, home()).href : `./${path}`);

/**
 * Tags for Vite to put into a page's head.
 * @param {{address: string, title: string, description: string, card: string}} page `card` is the name of its picture in www/public/cards
 */
export function socialTags({ address, title, description, card }) {
  const meta = (/** @type {Record<string, string>} */ attrs) => ({ tag: 'meta', attrs, injectTo: /** @type {const} */ ('head') });
  const own = home() ? [meta({ property: 'og:url', content: addressOf(address) }), { tag: 'link', attrs: { rel: 'canonical', href: addressOf(address) }, injectTo: /** @type {const} */ ('head') }] : [];
  return [
    meta({ property: 'og:title', content: title }),
    meta({ property: 'og:description', content: description }),
    meta({ property: 'og:image', content: addressOf(`cards/${card}.jpg`) }),
    meta({ name: 'twitter:card', content: 'summary_large_image' }),
    ...own,
  ];
}

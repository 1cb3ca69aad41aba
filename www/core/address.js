/**
 * What the page's address asks for: a shared document (`#d=…`), the document at another address (`?src=…`),
 * a sample (`?sample=2tpr.json`), changes (`?set=…`).
 */

/** @param {{search: string, hash: string}} address */
export function readAddress({ search, hash }) {
  // A plus is a sign here, not a blank.
  const query = new URLSearchParams(search.replaceAll('+', '%2B'));
  return { payload: /^#(?:.*&)?d=([^&]*)/.exec(hash)?.[1] ?? null, src: query.get('src'), sample: query.get('sample'), sets: query.getAll('set') };
}

/** The address that asks for nothing of that. @param {string} href */
export function plainAddress(href) {
  const url = new URL(href);
  for (const name of ['src', 'sample', 'set']) url.searchParams.delete(name);
  if (readAddress(url).payload !== null) url.hash = '';
  return url.href.replace(/[?#]+$/, '');
}

/** @param {string} href @param {string} payload */
export const shareAddress = (href, payload) => `${href.replace(/[?#].*$/s, '')}#d=${payload}`;

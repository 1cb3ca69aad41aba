// A page of somebody else's with elements in it, for the tests of how the element behaves there.
import { readFileSync } from 'node:fs';

const DOCUMENT = readFileSync(new URL('../../www/mechanisms/2tpr.json', import.meta.url), 'utf8');

export const LINKAGE = '<synthetica-linkage src="2tpr.json" controls></synthetica-linkage>';

/** A page of somebody else's, 600 px wide unless told, with this in its body. */
export async function openGuestPage(browser, body, { head = '', html = '<html lang="en">', script = true, ...options } = {}) {
  const { page, problems } = await browser.blankPage({ viewport: { width: 600, height: 700 }, ...options });
  await page.route(`${browser.address}guest.html`, (route) =>
    route.fulfill({
      contentType: 'text/html',
      body: `<!doctype html>${html}<head><meta charset="utf-8"><meta name="viewport" content="width=device-width"><title>A page</title>
        ${script ? '<script type="module" src="./element.js"></script>' : ''}<style>body { margin: 0 }</style>${head}</head><body>${body}</body></html>`,
    }),
  );
  await page.route(`${browser.address}2tpr.json`, (route) => route.fulfill({ contentType: 'application/json', body: DOCUMENT }));
  await page.goto(`${browser.address}guest.html`);
  return { page, problems };
}

/** Waits until every element of the page has its motion and is drawn. */
export const planned = (page) =>
  page.waitForFunction(() => [...document.querySelectorAll('synthetica-linkage')].every((element) => element.trajectory && element.shadowRoot.querySelector('#frame-number')?.textContent !== '–'));

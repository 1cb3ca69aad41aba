// The built page in a real browser, for the tests beside this file.
import assert from 'node:assert/strict';
import { chromium } from 'playwright-core';
import { preview } from 'vite';

/** The page is opened in a small window: without a graphics card every pixel is computed. */
const WINDOW = { width: 800, height: 600 };

/** How Chromium is started: with a `gc()` for the test that nothing is left behind. */
export const LAUNCH = { executablePath: process.env.CHROMIUM || '/usr/bin/chromium', args: ['--no-sandbox', '--js-flags=--expose-gc'] };

/**
 * For functions that run in the page: what has the focus, and what a selector finds, inside the linkage element too. (A
 * locator looks there by itself.)
 */
export function lookInside() {
  const trees = () => [document, ...[...document.querySelectorAll('synthetica-linkage')].map((element) => element.shadowRoot).filter(Boolean)];
  window.page$$ = (selector) => trees().flatMap((tree) => [...tree.querySelectorAll(selector)]);
  window.page$ = (selector) => window.page$$(selector)[0] ?? null;
  window.pageFocus = () => {
    let at = document.activeElement;
    while (at?.shadowRoot?.activeElement) at = at.shadowRoot.activeElement;
    return at;
  };
}

/** Serves www/dist and starts a browser. */
export async function openBrowser() {
  const server = await preview({ configFile: 'tools/vite.config.js', preview: { port: 0 } });
  const browser = await chromium.launch(LAUNCH);
  const address = server.resolvedUrls.local[0];

  return {
    address,
    async close() {
      await browser.close();
      await server.close();
    },
    /**
     * A fresh page with its first motion planned, and everything that it complains about or asks of other hosts.
     * @param {import('playwright-core').BrowserContextOptions} [options]
     */
    async openPage(options) {
      const { page, problems } = await this.blankPage(options);
      await page.goto(address);
      await page.waitForFunction(() => (page$('#closure')?.textContent ?? '–') !== '–');
      return { page, problems };
    },
    /** A page that is nowhere yet; the first minute counts as seen, unless it is the visitor's first; the legend is open, or as it opens by itself; a better motion is looked for only when asked, or by itself. */
    async blankPage({ firstVisit = false, legend = true, search = false, ...options } = {}) {
      const context = await browser.newContext({ viewport: WINDOW, reducedMotion: 'reduce', ...options });
      if (!firstVisit) {
        await context.addInitScript(() => {
          try {
            localStorage.setItem('synthetica.first-minute', 'in a test');
          } catch {
            // A test of blocked storage: the page sees to it.
          }
        });
      }
      const layout = { ...(legend && { legend }), ...(!search && { search }) };
      await context.addInitScript((chosen) => {
        try {
          localStorage.setItem('synthetica.dock', JSON.stringify({ ...JSON.parse(localStorage.getItem('synthetica.dock')), ...chosen }));
        } catch {
          // As above.
        }
      }, layout);
      await context.addInitScript(lookInside);
      // Other suites may run at the same time.
      context.setDefaultTimeout(60_000);
      const page = await context.newPage();
      const problems = [];
      page.on('console', (message) => {
        // Chromium remarks on its own screenshots of a canvas.
        if (['error', 'warning'].includes(message.type()) && !message.text().includes('GPU stall')) problems.push(message.text());
      });
      page.on('pageerror', (error) => problems.push(String(error)));
      page.on('request', (request) => {
        if (!request.url().startsWith(address) && !/^(data|blob):/.test(request.url())) problems.push(`asks for ${request.url()}`);
      });
      return { page, problems };
    },
  };
}

/**
 * Opens an example as a person does, and waits for its motion.
 * @param {import('playwright-core').Page} page
 * @param {string} file such as `2tpr.json`
 */
export async function openSample(page, file) {
  const menu = page.getByRole('button', { name: 'Examples', exact: true });
  if (await menu.isVisible()) await menu.click();
  else {
    await page.getByRole('button', { name: 'File', exact: true }).click();
    await page.getByRole('menuitem', { name: 'Examples' }).click();
  }
  await page.locator(`[data-sample="${file}"]`).click();
  await page.locator('dialog.gallery').waitFor({ state: 'detached' });
  await motionIsOfDocument(page);
}

/** Waits until the chains named in the info panel are those of the tables. */
export const motionIsOfDocument = (page) =>
  page.waitForFunction(() => {
    const types = (all) => [...page$$(all)].map((node) => node.value ?? node.textContent).join();
    return types('#mechanism .chain .type') === types('#chain-rows td:nth-child(2)');
  });

export const cell = (page, path) => page.locator(`[data-path="${path}"]`);

/** Does something with a thing of the tables by its menu: "chain 2", "joint 1 of chain 3", "key frame 2". */
export async function doTo(page, thing, what) {
  await page.getByRole('button', { name: `Actions of ${thing}`, exact: true }).click();
  await page.getByRole('menuitem', { name: what, exact: true }).click();
}

/** The charts and the algorithm are folded away until they are wanted. @param {import('playwright-core').Page} page */
export async function unfoldCharts(page) {
  const fold = page.getByRole('button', { name: 'Charts and algorithm' });
  if ((await fold.getAttribute('aria-expanded')) === 'false') await fold.click();
}

/** Goes to a frame as a person does who drags the scrub bar. */
export const scrubTo = (page, frame) => page.locator('#scrub').fill(String(frame));

export const text = (page, id) => page.locator(`#${id}`).textContent();

/** A number as the page writes it. */
export const number = (shown) => Number(shown.replaceAll('−', '-').replace(/[^\d.e-].*$/, ''));

/** Waits until the metric of the shown frame is another than `old`, and gives it. */
export async function otherMetric(page, old) {
  await page.waitForFunction((value) => page$('#metric').textContent !== value, old);
  return text(page, 'metric');
}

export const metricBecomes = (page, value) =>
  page.waitForFunction((wanted) => page$('#metric').textContent === wanted, value);

/** The fault's text, once it stands beside the cell that caused it. */
export async function faultBeside(page, path) {
  const faulty = cell(page, path);
  await page.locator(`[data-path="${path}"][aria-invalid="true"]`).waitFor();
  const note = page.locator(`#${await faulty.getAttribute('aria-describedby')}`);
  assert.ok(await note.isVisible(), 'the fault can be seen');
  const [below, box] = [await note.boundingBox(), await faulty.boundingBox()];
  assert.ok(below.y >= box.y && below.y - (box.y + box.height) < 60, 'the fault is beside its cell');
  return note.textContent();
}

export const noFault = (page) => page.locator('#fault-note').waitFor({ state: 'detached' });

/** The first motion of the page is planned. */
export const ready = (page) => page.waitForFunction(() => (page$('#closure')?.textContent ?? '–') !== '–');

/** The header names that document. */
export const nameIs = (page, name) => page.locator('#document-name').filter({ hasText: new RegExp(`^${name}$`) }).waitFor();

export const notice = (page, words) => page.locator('#notices p').filter({ hasText: words });

/** The kept work holds that text. */
export const keeps = (page, words) => page.waitForFunction((wanted) => localStorage.getItem('synthetica.work.1')?.includes(wanted), words);

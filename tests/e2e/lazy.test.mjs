// Parts of the page that do not come: that is said, and the way to try again works.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { openBrowser } from './browser.mjs';

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

/** Fails requests until told otherwise. @returns {Promise<() => Promise<void>>} lets them through */
async function block(page, pattern) {
  let asked = 0;
  await page.route(pattern, (route) => {
    asked++;
    return route.abort();
  });
  return async () => {
    assert.ok(asked > 0, `${pattern} was asked for`);
    await page.unroute(pattern);
  };
}

/** A page whose problems are only those that a test expects: what the browser itself says of a blocked request. */
const ofThePage = (problems) => problems.filter((problem) => !/ERR_FAILED|Failed to load resource|Service Worker registration blocked/.test(problem));

const motion = (page) => page.waitForFunction(() => (page$('#closure')?.textContent ?? '–') !== '–');

for (const [what, pattern] of [['its first script', /assets\/index-[^/]*\.js/], ['a script that it imports', /assets\/linkage-[^/]*\.js/]]) {
  test(`without ${what} the page says that it cannot start, and tries again when asked`, async () => {
    const { page, problems } = await browser.blankPage();
    const pass = await block(page, pattern);
    await page.goto(browser.address);
    await page.getByRole('alert').filter({ hasText: 'could not be loaded, so the page cannot start' }).waitFor();
    await pass();
    await page.getByRole('button', { name: 'Try again' }).click();
    await motion(page);
    assert.equal(await page.locator('#start-note').count(), 0);
    assert.deepEqual(ofThePage(problems), []);
  });
}

test('a page that has started says nothing of scripts that failed', async () => {
  const { page } = await browser.openPage();
  assert.equal(await page.locator('#start-note').count(), 0);
});

test('a panel that cannot be loaded says so, and comes when it is tried again', async () => {
  const { page, problems } = await browser.openPage();
  const pass = await block(page, /assets\/teach-[^/]*\.js/);
  await page.getByRole('tab', { name: 'Teach' }).click();
  const panel = page.getByRole('tabpanel', { name: 'Teach' });
  const said = panel.getByRole('alert').filter({ hasText: 'The joints could not be loaded' });
  await said.waitFor();
  // A second time without success, it is said again.
  await panel.getByRole('button', { name: 'Try again' }).click();
  await said.waitFor();
  await pass();
  await panel.getByRole('button', { name: 'Try again' }).click();
  await panel.locator('.teach-row').first().waitFor();
  assert.equal(await page.evaluate(() => pageFocus().id), 'teach', 'the focus stays in the panel');
  assert.deepEqual(ofThePage(problems), []);
});

test('the tables of the motion that cannot be loaded say so, and come when they are tried again', async () => {
  const { page, problems } = await browser.openPage();
  const pass = await block(page, /assets\/motion-tables-[^/]*\.js/);
  await page.getByRole('tab', { name: 'Motion', exact: true }).click();
  const panel = page.getByRole('tabpanel', { name: 'Motion', exact: true });
  await panel.getByRole('alert').filter({ hasText: 'The tables of the motion could not be loaded' }).waitFor();
  await pass();
  await panel.getByRole('button', { name: 'Try again' }).click();
  await panel.locator('[data-path="motion.key_frames[0].x"]').waitFor();
  assert.equal(await panel.getByRole('alert').count(), 0);
  assert.deepEqual(ofThePage(problems), []);
});

test('a fault in the motion is told beside its cell though nobody has seen the tables of the motion', async () => {
  const { page, problems } = await browser.openPage();
  await page.evaluate(() => {
    const { workbench } = document.querySelector('synthetica-linkage');
    return workbench.then(({ store }) => store.edit((doc) => ({ ...doc, motion: { ...doc.motion, frames: 'many' } })));
  });
  await page.locator('#go-to-fault').click();
  const cell = page.locator('[data-path="motion.frames"]');
  await cell.and(page.locator('[aria-invalid="true"]')).waitFor();
  assert.equal(await page.evaluate(() => pageFocus().dataset.path), 'motion.frames');
  assert.deepEqual(ofThePage(problems), []);
});

test('a block that is pasted, and a key that is pressed, before blocks of cells are loaded are not lost', async () => {
  const { page, problems } = await browser.openPage();
  /** @type {() => void} */
  let pass = () => {};
  const held = new Promise((resolve) => (pass = resolve));
  await page.route(/assets\/cell-block-[^/]*\.js/, async (route) => {
    await held;
    await route.continue();
  });
  const at = (row, column) => `chains[0].joints[${row}].rows[0].${column}`;
  const value = (path) => page.locator(`[data-path="${path}"]`).inputValue();
  const before = await value(at(0, 'd'));
  await page.locator(`[data-path="${at(0, 'theta')}"]`).evaluate((field) => {
    field.focus();
    const clipboardData = new DataTransfer();
    clipboardData.setData('text/plain', '7\t0.5');
    field.dispatchEvent(new ClipboardEvent('paste', { clipboardData, bubbles: true, cancelable: true }));
    clipboardData.clearData();
  });
  await page.keyboard.press('Shift+ArrowDown');
  assert.equal(await value(at(0, 'd')), before);
  pass();
  await page.locator('.block-note').filter({ hasText: '2 rows of 1 cell' }).waitFor();
  assert.deepEqual([await value(at(0, 'theta')), await value(at(0, 'd'))], ['7', '0.5']);
  assert.deepEqual(ofThePage(problems), []);
});

const PARTS = [
  ['The examples', /assets\/gallery-[^/]*\.(js|css)/, (page) => page.getByRole('button', { name: 'Examples', exact: true }).click(), (page) => page.getByRole('dialog', { name: 'Examples' })],
  ['What opens and saves documents', /assets\/actions-[^/]*\.js/, (page) => page.getByRole('button', { name: 'Share', exact: true }).click(), (page) => page.getByRole('dialog', { name: 'Share' })],
  ['What makes new linkages', /assets\/new-dialog-[^/]*\.(js|css)/, (page) => page.getByRole('button', { name: 'New', exact: true }).click(), (page) => page.getByRole('option', { name: /^Delta robot/ })],
  ['This part of the help', /assets\/reference-[^/]*\.css/, (page) => page.keyboard.press('?'), (page) => page.getByRole('dialog', { name: 'Keys' })],
  ['What makes this file', /assets\/picture-dialog-[^/]*\.(js|css)/, async (page) => {
    await page.getByRole('button', { name: 'Export', exact: true }).click();
    await page.getByRole('menuitem', { name: /PNG/ }).click();
  }, (page) => page.getByRole('dialog')],
  ['The lesson', /assets\/open-lesson-[^/]*\.js/, async (page) => {
    await page.getByRole('button', { name: 'Help', exact: true }).click();
    await page.getByRole('menuitem', { name: /Lesson: Why/ }).click();
  }, (page) => page.getByRole('tabpanel', { name: 'Lesson' })],
];
test('what is loaded when it is asked for and does not come is told, and comes when it is tried again', async () => {
  // What a service worker keeps could not be blocked.
  const { page, problems } = await browser.openPage({ viewport: { width: 1280, height: 800 }, serviceWorkers: 'block' });
  for (const [what, pattern, ask, there] of PARTS) {
    const pass = await block(page, pattern);
    await ask(page);
    const notice = page.locator('#notices p').filter({ hasText: `${what} could not be loaded` });
    await notice.waitFor();
    await pass();
    await notice.getByRole('button', { name: 'Try again' }).click();
    await there(page).waitFor();
    // With its style.
    await page.waitForFunction(() => [...document.querySelectorAll('link[rel=stylesheet]')].every((link) => link.sheet));
    await page.keyboard.press('Escape');
    await page.waitForFunction(() => !pageFocus()?.closest('dialog'));
  }
  assert.deepEqual(ofThePage(problems), []);
});

test('an element in another page whose panels do not come shows its view, says so, and shows them when it is tried again', async () => {
  const { page, problems } = await browser.blankPage();
  const body = '<!doctype html><title>Another page</title><script type="module" src="./element.js"></script><synthetica-linkage type="3RPS" controls panels="info"></synthetica-linkage>';
  await page.route('**/another.html', (route) => route.fulfill({ contentType: 'text/html', body }));
  const pass = await block(page, /assets\/panels-[^/]*\.js/);
  await page.goto(`${browser.address}another.html`);
  const again = page.getByRole('button', { name: 'Try again' });
  await page.getByText('The panels could not be loaded').waitFor();
  assert.ok(await page.locator('#canvas').isVisible());
  await pass();
  await again.click();
  await motion(page);
  assert.deepEqual(ofThePage(problems), []);
});

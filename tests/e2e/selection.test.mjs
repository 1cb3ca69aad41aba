// One selection for the 3D view, the tables and the object tree.
import assert from 'node:assert/strict';
import { after, afterEach, before, beforeEach, test } from 'node:test';
import { cell, openBrowser, openSample } from './browser.mjs';

let browser;
let page;
let problems;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());
beforeEach(async () => {
  ({ page, problems } = await browser.openPage({ viewport: { width: 1280, height: 800 } }));
});
afterEach(() => assert.deepEqual(problems, []));

const marked = (path) => page.locator(`.tables [data-path="${path}"][aria-current="true"]`);
const item = (path) => page.locator(`[data-item="${path}"]`);
/** The name of what is chosen, as the 3D view writes it. */
const inView = (text) => page.locator('#labels .chosen').filter({ hasText: text });

test('what is chosen in the view is marked in the tables and in the tree, and the view keeps the focus', async () => {
  await page.locator('#canvas').focus();
  for (let i = 0; i < 40 && !(await page.locator('#view-live').textContent()).startsWith('chain 3, joint 2'); i++) await page.keyboard.press(']');
  await page.keyboard.press('Enter');
  await marked('chains[2].joints[1]').waitFor();
  await item('chains[2].joints[1]').and(page.locator('[aria-selected=true]')).waitFor();
  assert.equal(await page.evaluate(() => pageFocus().id), 'canvas');
  const [row, box] = [await marked('chains[2].joints[1]').boundingBox(), await page.locator('#tables').boundingBox()];
  assert.ok(row.y >= box.y - 1 && row.y + row.height <= box.y + box.height + 1, `the row is in sight: ${JSON.stringify([row, box])}`);
  await page.keyboard.press('Escape');
  await marked('chains[2].joints[1]').waitFor({ state: 'detached' });
});

test('a name clicked in the view opens the table that it is in', async () => {
  await page.locator('#labels').getByText('between').click();
  await marked('motion.key_frames[1]').waitFor();
  assert.ok(await page.getByRole('tabpanel', { name: 'Motion', exact: true }).isVisible());
  // Sliders do not give way to a click.
  await page.getByRole('tab', { name: 'Teach' }).click();
  await page.locator('#labels').getByText('begin').click();
  assert.ok(await page.getByRole('tabpanel', { name: 'Teach' }).isVisible());
});

test('a cell that is entered selects its joint everywhere, and nothing scrolls away under the hand', async () => {
  await cell(page, 'chains[1].joints[1].rows[0].alpha').focus();
  await inView('chain 2, joint 2').waitFor();
  await marked('chains[1].joints[1]').waitFor();
  await cell(page, 'chains[0].base.x').focus();
  await inView('base of chain 1').waitFor();
  assert.equal(await marked('chains[1].joints[1]').count(), 0);
  assert.equal(await page.evaluate(() => pageFocus().dataset.path), 'chains[0].base.x');
});

test('entering a cell moves nothing under the hand', async () => {
  const at = async () => (await cell(page, 'chains[0].joints[0].rows[0].alpha').boundingBox()).y;
  const before = await at();
  await cell(page, 'chains[0].joints[0].rows[0].alpha').click();
  await item('chains[0].joints[0]').and(page.locator('[aria-selected=true]')).waitFor();
  assert.equal(await at(), before);
});

test('pointing at a row shows the thing in the view and in the tree', async () => {
  await page.locator('[data-path="chains[0].joints[2]"] th').first().hover();
  await page.locator('#labels .pointed').filter({ hasText: 'chain 1, joint 3' }).waitFor();
  await page.locator('[data-item="chains[0].joints[2]"].pointed').waitFor({ state: 'attached' });
});

test('the tree by keyboard: branches, letters, selection, and the way into the table', async () => {
  await item('chains[0]').focus();
  await page.keyboard.press('ArrowRight');
  assert.equal(await item('chains[0]').getAttribute('aria-expanded'), 'true');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('ArrowDown');
  const focused = () => page.evaluate(() => pageFocus().dataset.item);
  assert.equal(await focused(), 'chains[0].joints[0]');
  await page.keyboard.press('Space');
  await inView('chain 1, joint 1').waitFor();
  await page.keyboard.press('ArrowLeft');
  assert.equal(await focused(), 'chains[0]');
  await page.keyboard.press('m');
  assert.equal(await focused(), 'motion');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('Enter');
  // The tables of the motion are loaded with it.
  await page.waitForFunction(() => pageFocus()?.dataset.path === 'motion.key_frames[0].name');
  await page.keyboard.press('Home');
});

test('the tree follows the document: names, types, five chains', async () => {
  await openSample(page, 'five-link.json');
  await item('chains[4]').waitFor();
  assert.match(await item('chains[4]').textContent(), /toe link/);
  await cell(page, 'chains[4].name').fill('track rod');
  await item('chains[4]').filter({ hasText: 'track rod' }).waitFor();
  const tree = await page.getByRole('tree', { name: 'Objects' }).boundingBox();
  assert.ok(tree.height <= 200, 'it leaves the tables their room');
});

test('on a phone a tap in the view does not take the page away from it', async () => {
  const { page: phone } = await browser.openPage({ viewport: { width: 390, height: 844 }, isMobile: true, hasTouch: true });
  await phone.locator('#labels').getByText('end', { exact: true }).tap();
  await phone.locator('.tables [data-path="motion.key_frames[2]"][aria-current="true"]').waitFor({ state: 'attached' });
  assert.equal(await phone.evaluate(() => scrollY), 0);
});

test('the tree keeps its nodes and the focus when the document changes, and its arrows scroll with it', async () => {
  await item('chains[1]').focus();
  await page.evaluate(() => {
    window.before = pageFocus();
    const { store } = document.querySelector('synthetica-linkage').parts;
    store.edit((doc) => ({ ...doc, chains: doc.chains.map((chain, index) => ({ ...chain, name: `leg ${index + 1}` })) }));
  });
  await item('chains[1]').filter({ hasText: 'leg 2' }).waitFor();
  assert.ok(await page.evaluate(() => pageFocus() === window.before && window.before.isConnected), 'the same node has the focus');
  const arrow = async () => (await page.locator('[data-item="chains[0]"] .arrow').boundingBox()).y;
  const before = await arrow();
  await page.locator('.tree').evaluate((tree) => {
    tree.style.height = '70px';
    tree.scrollTop = 20;
  });
  assert.equal(await arrow(), before - 20, 'the arrow goes with its item');
});

test('when the focused item goes, the focus stays in the tree', async () => {
  await item('chains[2]').focus();
  await page.keyboard.press('Home');
  await page.keyboard.press('End');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('End');
  assert.equal(await page.evaluate(() => pageFocus().dataset.item), 'motion.key_frames[2]');
  await page.evaluate(() => {
    const { store } = document.querySelector('synthetica-linkage').parts;
    store.edit((doc) => ({ ...doc, motion: { ...doc.motion, key_frames: doc.motion.key_frames.slice(0, 2) } }));
  });
  await item('motion.key_frames[2]').waitFor({ state: 'detached' });
  assert.equal(await page.evaluate(() => pageFocus().getAttribute('role')), 'treeitem');
});

// Tables 2 and 3, from which a linkage can be built.
import assert from 'node:assert/strict';
import { after, afterEach, before, beforeEach, test } from 'node:test';
import { openBrowser, openSample } from './browser.mjs';

let browser;
let page;
let problems;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());
beforeEach(async () => {
  ({ page, problems } = await browser.openPage());
  await page.getByRole('tab', { name: 'Types' }).click();
  await page.locator('#types .chip').first().waitFor();
});
afterEach(() => assert.deepEqual(problems, []));

const panel = () => page.getByRole('tabpanel', { name: 'Types' });
const sentence = (pattern) => panel().locator('.type-sentence').filter({ hasText: pattern }).waitFor();
const types = () => page.locator('#mechanism .chain .type').evaluateAll((all) => all.map(({ value }) => value));

test('lists 6, 18, 51 and 139 chains, and the paper’s totals of assemblies', async () => {
  for (const [category, count] of [['IV', 6], ['III', 18], ['II', 51], ['I', 139]]) {
    assert.equal(await page.locator(`[data-category="${category}"] .chip`).count(), count, category);
  }
  assert.deepEqual(await panel().locator('.total td:last-child').allTextContents(), ['487,990,859', '16,734,569', '464,417', '9,781', '139']);
});

test('says what the present linkage is, and marks its types', async () => {
  await sentence(/of type 3I: one of 457,310 such assemblies, of 464,417 with 3 constraints/);
  assert.deepEqual(await panel().locator('.chip.used').allTextContents(), ['RPS']);
  assert.equal(await panel().locator('tr[aria-current=true]').getAttribute('data-assembly'), '3I');
  await openSample(page, '2tpr.json');
  await sentence(/of type 2II: one of 1,326/);
  await openSample(page, 'four-bar.json');
  await sentence(/2IV with 8 constraints: more than the five/);
});

test('a type takes a chain’s place or comes beside the others, and undo takes it back', async () => {
  await panel().getByRole('button', { name: 'TS', exact: true }).click();
  await page.getByRole('menuitem', { name: 'Replace chain 3' }).click();
  assert.deepEqual(await types(), ['RPS', 'RPS', 'TS']);
  await page.locator('#notices').getByRole('button', { name: 'Undo' }).click();
  assert.deepEqual(await types(), ['RPS', 'RPS', 'RPS']);
  await panel().getByRole('button', { name: 'SP', exact: true }).click();
  await page.getByRole('menuitem', { name: 'Add as a new chain' }).click();
  assert.deepEqual(await types(), ['RPS', 'RPS', 'RPS', 'SP']);
  await page.keyboard.press('Control+z');
  assert.deepEqual(await types(), ['RPS', 'RPS', 'RPS']);
});

test('finds a type, and says what types are where there is none', async () => {
  const search = panel().getByRole('searchbox', { name: 'Find a chain type' });
  await search.fill('rps');
  assert.deepEqual(await panel().locator('.chip:visible').allTextContents(), ['RPS']);
  await search.fill('QQ');
  await panel().getByText('There is no such chain.').waitFor();
  await search.fill('');
  assert.equal(await panel().locator('.chip:visible').count(), 214);
});

test('a type begins a new linkage, of as many chains as leave a freedom', async () => {
  for (const [type, label] of [['RRS', 'New linkage 5RRS'], ['TS', 'New linkage 5TS'], ['TR', 'New linkage 1TR']]) {
    await panel().getByRole('button', { name: type, exact: true }).click();
    await page.getByRole('menuitem', { name: label }).click();
    const chains = Number(/\d/.exec(label)[0]);
    await page.waitForFunction(([wanted, many]) => page$$('#mechanism .chain .type').map((node) => node.value).join() === Array(many).fill(wanted).join(), [type, chains]);
    assert.ok(await page.locator('#fault-banner').isHidden());
  }
  await page.locator('#undo').click();
  assert.deepEqual(await types(), Array(5).fill('TS'));
});

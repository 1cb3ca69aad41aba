// Expressions in cells, and parameters with their sliders.
import assert from 'node:assert/strict';
import { after, afterEach, before, test } from 'node:test';
import { encode } from '../../www/core/link-codec.js';
import { cell, faultBeside, noFault, openBrowser, openSample, ready } from './browser.mjs';

let browser;
let problems = [];
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());
afterEach(() => assert.deepEqual(problems, []));

/** The four-bar, with the length of its crank as a parameter. @param {import('playwright-core').BrowserContextOptions} [options] */
async function open(options) {
  const opened = await browser.openPage(options);
  ({ problems } = opened);
  await openSample(opened.page, 'four-bar.json');
  return opened.page;
}
const CRANK = 'chains[0].joints[1].rows[0].a';
const FIRST = 'chains[0].joints[0].rows[0].a';
const docOf = (page) => page.evaluate(() => page$('synthetica-linkage').document);
const value = (page) => page.locator('#expression-value');

test('an expression is shown as typed, with its value; a fault is told at the cell, with its place in the text', async () => {
  const page = await open();
  const first = cell(page, FIRST);
  await first.fill('hypot(0.3, ');
  await first.press('Enter');
  assert.match(await faultBeside(page, FIRST), /in “hypot\(0\.3,” a value is missing at the end/);
  assert.equal(await first.inputValue(), 'hypot(0.3, ');
  await first.fill('hypot(0.3, 0.4) - 0.5');
  await first.press('Enter');
  await noFault(page);
  await value(page).filter({ hasText: /^= 0 m$/ }).waitFor();
  assert.equal(await first.getAttribute('aria-describedby'), 'expression-value');
  // It has no steps, and what would change it is said.
  await first.press('PageUp');
  await page.locator('#notices p').filter({ hasText: 'is an expression, which has no steps' }).waitFor();
  // Its value is there: Enter goes on.
  await first.press('Enter');
  assert.notEqual(await page.evaluate(() => pageFocus().dataset.path), FIRST);
  assert.equal(await first.inputValue(), 'hypot(0.3, 0.4) - 0.5');
  assert.equal((await docOf(page)).chains[0].joints[0].rows[0].a, 'hypot(0.3, 0.4) - 0.5');
});

test('a parameter of a number, its slider, its name and its end', async () => {
  const page = await open();
  await cell(page, 'chains[0].base.y').press('Alt+Enter');
  const form = page.locator('dialog[open]');
  await form.getByLabel('Name').fill('sin');
  await form.getByRole('button', { name: 'Make the parameter' }).click();
  await form.getByText('is the name of a function').waitFor();
  await form.getByLabel('Name').fill('height');
  await form.getByLabel(/Also in the 1 other cell/).check();
  await form.getByRole('button', { name: 'Make the parameter' }).click();
  const slider = page.getByRole('slider', { name: 'parameter height' });
  await slider.waitFor();
  assert.deepEqual([await slider.getAttribute('min'), await slider.getAttribute('max')], ['0', '0.4']);
  let doc = await docOf(page);
  assert.deepEqual([doc.parameters, doc.chains[0].base.y, doc.chains[1].base.y], [{ height: 0.2 }, 'height', 'height']);

  // A drag is one step of undo.
  const box = await slider.boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  for (const share of [0.6, 0.7, 0.75]) await page.mouse.move(box.x + box.width * share, box.y + box.height / 2);
  await page.mouse.up();
  const moved = (await docOf(page)).parameters.height;
  assert.ok(moved > 0.25 && moved < 0.35, String(moved));
  await page.waitForFunction((now) => page$('synthetica-linkage').document.parameters.height === now, moved);
  await cell(page, 'chains[0].base.y').focus();
  await value(page).filter({ hasText: `= ${moved} m` }).waitFor();
  await page.keyboard.press('Control+z');
  assert.equal((await docOf(page)).parameters.height, 0.2);

  // In a cell with its name and nothing else, the keys of a number change it.
  await cell(page, 'chains[0].base.y').press('PageUp');
  assert.equal((await docOf(page)).parameters.height, 0.21);
  await page.keyboard.press('Control+z');

  // Another name, also where it is used.
  const name = page.getByLabel('name of parameter height');
  await name.fill('cos');
  await name.press('Enter');
  await page.locator('.parameters .fault').filter({ hasText: 'is the name of a function' }).waitFor();
  await name.press('Escape');
  await name.fill('up');
  await name.press('Enter');
  await page.getByRole('slider', { name: 'parameter up' }).waitFor();
  doc = await docOf(page);
  assert.deepEqual([doc.parameters, doc.chains[0].base.y], [{ up: 0.2 }, 'up']);

  // It is not removed while it is used, but with its value in its place.
  await page.getByRole('button', { name: 'Actions of parameter up' }).click();
  const remove = page.getByRole('menuitem', { name: 'Remove', exact: false }).first();
  assert.equal(await remove.getAttribute('aria-disabled'), 'true');
  assert.match(await remove.textContent(), /It is used in chain 1, base frame, y/);
  await page.getByRole('menuitem', { name: /write its value/ }).click();
  doc = await docOf(page);
  assert.deepEqual([doc.parameters, doc.chains[0].base.y], [undefined, 0.2]);
  await page.keyboard.press('Control+z');
  assert.deepEqual((await docOf(page)).parameters, { up: 0.2 });
});

test('an address sets a parameter by its name, and a link keeps the document as it was typed', async () => {
  const page = await open();
  const crank = cell(page, CRANK);
  await page.locator('details.parameters summary').click();
  await page.getByRole('button', { name: '+ parameter' }).click();
  const name = page.getByLabel('name of parameter p1');
  await name.fill('crank');
  await name.press('Enter');
  await page.getByLabel('name of parameter crank').waitFor();
  assert.equal(await page.evaluate(() => pageFocus().dataset.name), 'crank', 'the focus stays at the name');
  await cell(page, 'parameters.crank').fill('0.4');
  await crank.fill('crank');
  await crank.press('Enter');
  await value(page).filter({ hasText: '= 0.4 m' }).waitFor();
  const link = await encode(JSON.stringify(await docOf(page)));
  await page.goto('about:blank');
  await page.goto(`${browser.address}?set=crank:0.41#d=${link}`);
  await ready(page);
  const doc = await docOf(page);
  assert.deepEqual([doc.parameters, doc.chains[0].joints[1].rows[0].a], [{ crank: 0.41 }, 'crank']);
});

test('on a phone the table of parameters is not wider than its panel, and cells take letters', async () => {
  const page = await open({ viewport: { width: 390, height: 800 }, hasTouch: true, isMobile: true, colorScheme: 'dark' });
  await cell(page, 'chains[0].base.y').tap();
  await page.locator('details.parameters summary').tap();
  await page.getByRole('button', { name: /from chain 1, base frame, y/ }).tap();
  await page.locator('dialog[open]').getByRole('button', { name: 'Make the parameter' }).tap();
  await page.getByRole('slider', { name: 'parameter p1' }).waitFor();
  // Cells are named in words after every planning.
  assert.equal(await page.getByRole('button', { name: /from chains\[/ }).count(), 0);
  const table = page.locator('.parameters-table');
  assert.ok(await table.evaluate((node) => node.scrollWidth <= node.parentElement.clientWidth), 'no wider than its panel');
  const box = await page.getByRole('slider', { name: 'parameter p1' }).boundingBox();
  assert.ok(box.width > 80 && box.height >= 40, `${box.width} × ${box.height}`);
  assert.equal(await cell(page, CRANK).evaluate((field) => field.inputMode), 'text');
});

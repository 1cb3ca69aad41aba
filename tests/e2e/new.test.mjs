// New: a mechanism by its name and the numbers of its paper, or next to nothing.
import assert from 'node:assert/strict';
import { after, afterEach, before, test } from 'node:test';
import { motionIsOfDocument, nameIs, openBrowser } from './browser.mjs';

let browser;
let problems;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());
afterEach(() => assert.deepEqual(problems, []));

/** A page with the dialog open, from the keyboard. */
async function openNew(options) {
  const opened = await browser.openPage(options);
  ({ problems } = opened);
  const { page } = opened;
  const button = page.getByRole('button', { name: 'New', exact: true });
  if (await button.isVisible()) await button.press('Enter');
  else {
    await page.locator('#file-menu').press('Enter');
    await page.getByRole('menuitem', { name: 'New…' }).press('Enter');
  }
  await page.waitForFunction(() => document.activeElement?.getAttribute('role') === 'combobox');
  return page;
}
const inDialog = (page) => page.getByRole('dialog', { name: 'New linkage' });
const chosen = (page) => inDialog(page).locator('[role=option][aria-selected=true]');
const field = (page, name) => inDialog(page).getByRole('textbox', { name, exact: true });
const focused = (page) => page.evaluate(() => document.activeElement.name);
const shownDoc = (page) => page.evaluate(() => document.querySelector('synthetica-linkage').document);

test('a Delta by its four numbers, by keyboard only; a size that does not fit is told at its field', async () => {
  const page = await openNew({ viewport: { width: 1280, height: 800 } });
  await page.keyboard.type('rotary');
  await chosen(page).filter({ hasText: 'Delta robot with rotary arms' }).waitFor();
  await page.keyboard.press('Enter');
  assert.equal(await focused(page), 'base');
  await page.keyboard.type('5000');
  const fault = inDialog(page).locator('.maker-form .fault:not([hidden])');
  await fault.filter({ hasText: /do not reach the platform/ }).waitFor();
  assert.equal(await field(page, 'base').getAttribute('aria-invalid'), 'true');
  assert.equal(await field(page, 'platform').getAttribute('aria-invalid'), null);
  const described = await field(page, 'base').getAttribute('aria-describedby');
  assert.ok(described.split(' ').includes(await fault.getAttribute('id')), 'the field is described by its fault');
  // It is not made, and the field that is at fault has the focus.
  for (const text of ['', '50']) {
    await page.keyboard.press('Tab');
    if (text) await page.keyboard.type(text);
  }
  assert.equal(await focused(page), 'upper');
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => document.activeElement.name === 'base');
  await page.keyboard.press('Control+a');
  await page.keyboard.type('400');
  for (const text of ['50', '300', '580']) {
    await page.keyboard.press('Tab');
    await page.keyboard.type(text);
  }
  await fault.waitFor({ state: 'detached' });
  await page.keyboard.press('Enter');
  await inDialog(page).waitFor({ state: 'detached' });
  await nameIs(page, 'Delta robot with rotary arms');
  await motionIsOfDocument(page);
  const { length_unit: unit, parameters, about } = await shownDoc(page);
  assert.equal(unit, 'mm');
  const { base, platform, upper, lower } = parameters;
  assert.deepEqual([base, platform, upper, lower], [400, 50, 300, 580]);
  assert.match(about, /Clavel/);
  await page.keyboard.press('Control+z');
  await nameIs(page, '3RPS');
});

test('arrow keys go through all groups, numbers and drawing follow; a name that there is not is told', async () => {
  const page = await openNew({ viewport: { width: 1280, height: 800 } });
  const first = await chosen(page).textContent();
  await page.keyboard.press('ArrowDown');
  const second = await chosen(page).textContent();
  assert.notEqual(second, first);
  assert.equal(await page.evaluate(() => document.getElementById(document.activeElement.getAttribute('aria-activedescendant')).textContent), second, 'said by a screen reader');
  await page.keyboard.type('linear delta');
  const drawing = inDialog(page).getByRole('img', { name: /^Drawing of the numbers of/ });
  await drawing.waitFor();
  const colour = await drawing.evaluate((svg) => [getComputedStyle(svg).stroke, getComputedStyle(svg).color]);
  assert.equal(colour[0], colour[1], 'its lines have the colour of the text');
  await page.getByRole('combobox', { name: 'Find a mechanism' }).fill('steam engine');
  await inDialog(page).getByText('No mechanism is called “steam engine”.').waitFor();
  assert.equal(await inDialog(page).locator('.maker-form').count(), 0, 'and none is asked for');
});

test('defaults are converted to another unit, what was typed stays', async () => {
  const page = await openNew({ viewport: { width: 1280, height: 800 } });
  await page.keyboard.type('delta');
  const before = Number(await field(page, 'upper').inputValue());
  await field(page, 'base').fill('0,2');
  await inDialog(page).getByRole('combobox', { name: 'Unit', exact: true }).selectOption('m');
  assert.equal(Number(await field(page, 'upper').inputValue()), before / 1000);
  assert.equal(await field(page, 'base').inputValue(), '0,2');
  await inDialog(page).getByText('about the middle of the base, in m.').waitFor();
  await inDialog(page).getByRole('button', { name: 'Make', exact: true }).first().click();
  await inDialog(page).waitFor({ state: 'detached' });
  const { length_unit: unit, parameters } = await shownDoc(page);
  assert.deepEqual([unit, parameters.base, parameters.upper], ['m', 0.2, before / 1000]);
});

test('on a phone, dark: nothing is wider than the window, and a mechanism is made by touch', async () => {
  const page = await openNew({ viewport: { width: 390, height: 844 }, isMobile: true, hasTouch: true, colorScheme: 'dark' });
  await inDialog(page).getByRole('option', { name: /^3-RPS/ }).tap();
  await page.waitForFunction(() => document.activeElement.name === 'base');
  await inDialog(page).locator('.maker-drawing svg').waitFor();
  const wide = await page.evaluate(() => [...document.querySelectorAll('dialog, dialog *')].filter((node) => node.getBoundingClientRect().right > innerWidth + 0.5 && !node.closest('svg')).map((node) => node.outerHTML.slice(0, 80)));
  assert.deepEqual(wide, []);
  await inDialog(page).getByRole('button', { name: 'Make', exact: true }).first().tap();
  await inDialog(page).waitFor({ state: 'detached' });
  assert.equal((await shownDoc(page)).parameters.base, 350);
  await page.locator('[data-name]').first().waitFor();
  await page.locator('table.axes').first().waitFor();
  const cut = await page.evaluate(() => ({
    names: page$$('[data-name]').filter((field) => field.value.length <= 8 && field.scrollWidth > field.clientWidth).map((field) => field.value),
    page: document.documentElement.scrollWidth,
    widerInItsFrame: page$$('.scroller').some((frame) => frame.scrollWidth > frame.clientWidth),
  }));
  assert.deepEqual(cut, { names: [], page: 390, widerInItsFrame: true });
});

test('an empty linkage by its tables or by its axes is planned', async () => {
  for (const [name, isOfAxes] of [['By its tables', false], ['By its axes', true]]) {
    const page = await openNew();
    await inDialog(page).getByRole('tab', { name: 'Empty' }).click();
    await inDialog(page).getByRole('button', { name }).click();
    await inDialog(page).waitFor({ state: 'detached' });
    await page.waitForFunction(() => document.querySelector('synthetica-linkage').document.chains.length === 1);
    await motionIsOfDocument(page);
    assert.ok(await page.locator('#fault-banner').isHidden());
    assert.equal('axis' in (await shownDoc(page)).chains[0].joints[0], isOfAxes);
    await page.close();
  }
});

test('an element shows a mechanism by its name and numbers, and what was made is shared whole', async () => {
  const opened = await browser.blankPage();
  ({ problems } = opened);
  const { page } = opened;
  const body = '<!doctype html><title>Another page</title><script type="module" src="./element.js"></script><synthetica-linkage type="delta?base=400&platform=50&arms=300,580&unit=mm" controls panels="types"></synthetica-linkage>';
  await page.route(`${browser.address}delta.html`, (route) => route.fulfill({ contentType: 'text/html', body }));
  await page.goto(`${browser.address}delta.html`);
  await page.waitForFunction(() => document.querySelector('synthetica-linkage')?.trajectory?.frames > 1);
  const { parameters } = await shownDoc(page);
  assert.deepEqual([parameters.base, parameters.platform, parameters.upper, parameters.lower], [400, 50, 300, 580]);
  await page.locator('.type-sentence').filter({ hasText: /\S/ }).waitFor();

  const applet = await openNew({ viewport: { width: 1280, height: 800 } });
  await applet.keyboard.type('delta');
  await applet.keyboard.press('Enter');
  await applet.keyboard.press('Enter');
  await inDialog(applet).waitFor({ state: 'detached' });
  await applet.getByRole('button', { name: 'Share', exact: true }).click();
  const link = await applet.getByRole('textbox', { name: 'Link', exact: true }).inputValue();
  assert.match(await applet.getByRole('textbox', { name: 'Element', exact: true }).inputValue(), /"parameters":\{"base":164,/);
  const shared = await browser.blankPage();
  await shared.page.goto(link);
  await nameIs(shared.page, 'Delta robot with rotary arms');
  assert.deepEqual((await shownDoc(shared.page)).parameters, (await shownDoc(applet)).parameters);
  assert.deepEqual(shared.problems, []);
});

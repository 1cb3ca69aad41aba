// Tables take and give blocks as a spreadsheet does.
import assert from 'node:assert/strict';
import { after, afterEach, before, beforeEach, test } from 'node:test';
import { cell, faultBeside, noFault, openBrowser } from './browser.mjs';

let browser;
let page;
let problems;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());
beforeEach(async () => {
  ({ page, problems } = await browser.openPage());
});
afterEach(() => assert.deepEqual(problems, []));

const at = (row, column, chain = 0) => {
  const [joint, inner] = [[0, 0], [1, 0], [2, 0], [2, 1], [2, 2]][row];
  return `chains[${chain}].joints[${joint}].rows[${inner}].${column}`;
};
const value = (path) => cell(page, path).inputValue();
/** Waits until cells show values. */
const become = (values) =>
  page.waitForFunction((wanted) => Object.entries(wanted).every(([path, shown]) => page$(`input[data-path="${path}"]`)?.value === shown), values);
/** Pastes into a cell; gives whether the page pastes in the browser's place. */
const paste = (path, text) =>
  cell(page, path).evaluate((field, data) => {
    field.focus();
    const clipboardData = new DataTransfer();
    clipboardData.setData('text/plain', data);
    const event = new ClipboardEvent('paste', { clipboardData, bubbles: true, cancelable: true });
    field.dispatchEvent(event);
    // After its event a clipboard can be read no more.
    clipboardData.clearData();
    return event.defaultPrevented;
  }, text);
/** What copying gives. */
const copied = () =>
  page.evaluate(() => {
    const clipboardData = new DataTransfer();
    pageFocus().dispatchEvent(new ClipboardEvent('copy', { clipboardData, bubbles: true, cancelable: true }));
    return clipboardData.getData('text/plain');
  });
const active = () => page.evaluate(() => pageFocus().dataset.path);

test('a pasted block fills the cells to the right and below, as one step of undo', async () => {
  const before = await value(at(2, 'd'));
  assert.equal(await paste(at(1, 'theta'), '7'), false, 'a single value is pasted by the browser');
  assert.equal(await paste(at(1, 'theta'), '0,5\t0.01\r\n1\t0.02\r\n'), true);
  await become({ [at(1, 'theta')]: '0.5', [at(1, 'd')]: '0.01', [at(2, 'theta')]: '1', [at(2, 'd')]: '0.02' });
  await noFault(page);
  await page.keyboard.press('Control+z');
  assert.equal(await value(at(2, 'd')), before);
  assert.equal(await value(at(1, 'theta')), '0');
  assert.equal(await page.locator('#undo').isDisabled(), true);
});

test('a block that is too large is refused in words, and nothing is written', async () => {
  await paste(at(4, 'theta'), '1\t2\t3\n4\t5\t6');
  await page.locator('#notices').filter({ hasText: '2 rows of 3 cells; from this cell on there is room for 1 row of 2 cells' }).waitFor();
  assert.equal(await page.locator('#undo').isDisabled(), true);
});

test('what is no number is kept as pasted and explained beside its cell', async () => {
  await paste(at(0, 'a'), '0\tabc');
  assert.match(await faultBeside(page, at(0, 'theta')), /number/);
  assert.equal(await value(at(0, 'theta')), 'abc');
  await page.keyboard.press('Control+z');
  await noFault(page);
});

test('frames and key frames take blocks too', async () => {
  await paste('chains[0].base.x', '-0.51\t-0.86\t0.01');
  await become({ 'chains[0].base.x': '-0.51', 'chains[0].base.y': '-0.86', 'chains[0].base.z': '0.01' });
  await page.getByRole('tab', { name: 'Motion', exact: true }).click();
  await paste('motion.key_frames[1].x', '0.3\t0.3\t0.4\n0.25\t0.2\t0');
  await become({ 'motion.key_frames[2].z': '0', 'motion.key_frames[2].x': '0.25' });
});

test('more key frames than there are, with names and times under heads, are appended in one step of undo', async () => {
  await page.getByRole('tab', { name: 'Motion', exact: true }).click();
  const keys = page.locator('#motion tbody.key');
  const row = (name, time, x) => [name, time, x, 0.2, 0.3, 10, 5, 0].join('\t');
  const head = ['name', 'time [s]', 'x', 'y', 'z', 'lon', 'lat', 'roll'].join('\t');
  await paste('motion.key_frames[1].name', [head, row('b', 1, 0.31), row('c', 2, 0.32), row('d', 3, 0.33), row('e', 4, 0.34)].join('\n'));
  await keys.nth(4).waitFor();
  assert.equal(await keys.count(), 5);
  assert.deepEqual(await Promise.all(['name', 'time', 'x', 'longitude'].map((key) => value(`motion.key_frames[4].${key}`))), ['e', '4', '0.34', '10']);
  assert.equal(await value('motion.key_frames[0].time'), '0');
  await page.locator('#notices').filter({ hasText: '2 key frames added. The row of heads was skipped.' }).waitFor();
  await noFault(page);
  await page.keyboard.press('Control+z');
  await keys.nth(4).waitFor({ state: 'detached' });
  assert.equal(await keys.count(), 3);
  assert.equal(await page.locator('#undo').isDisabled(), true);

  // All bad cells are marked at once, each with what to write.
  await paste('motion.key_frames[1].x', '1,8 mm\tabc\t0.4\n0.25\t0.2\t1.8 m');
  const bad = page.locator('#motion [aria-invalid="true"]');
  await bad.nth(2).waitFor();
  assert.deepEqual(await bad.evaluateAll((all) => all.map((field) => field.dataset.path.slice(17))), ['[1].x', '[1].y', '[2].z']);
  const note = async (index) => page.locator(`#${await bad.nth(index).getAttribute('aria-describedby')}`).textContent();
  assert.match(await note(0), /Key frame 2.* x: this is the text “1,8 mm”\. Write the number alone, with a point: 1\.8\.$/);
  assert.match(await note(1), / y: this is the text “abc”\. Accepted: a number, or an expression such as 2\*pi\.$/);
  assert.match(await note(2), /Key frame 3.* z: this is the text “1\.8 m”\. Write the number alone: 1\.8\.$/);
  await cell(page, 'motion.key_frames[1].x').fill('0.3');
  await bad.nth(2).waitFor({ state: 'detached' });
  assert.equal(await bad.count(), 2, 'what is mended is marked no more, the others are');
  await page.keyboard.press('Tab');
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  await noFault(page);

  for (const [typed, said] of [['many', /Accepted: a number, or an expression such as 2\*pi, or an empty cell\.$/], ['1,8', /“1,8”\. Write a point: 1\.8\.$/]]) {
    await cell(page, 'motion.radius').fill(typed);
    await page.keyboard.press('Enter');
    await page.locator('#fault-note').filter({ hasText: typed }).waitFor();
    assert.match(await faultBeside(page, 'motion.radius'), said);
  }
});

test('a chosen block is copied in whole numbers and cleared at once', async () => {
  await cell(page, 'chains[0].base.x').focus();
  await page.keyboard.press('Shift+ArrowDown');
  await page.keyboard.press('Shift+ArrowRight');
  await page.locator('.block-note').filter({ hasText: '2 rows of 2 cells' }).waitFor();
  assert.equal(await page.locator('.in-block').count(), 4);
  assert.equal(await copied(), '-0.5\t-0.866\n0.571\t0');
  await page.keyboard.press('Escape');
  assert.equal(await page.locator('.in-block').count(), 0);

  await page.locator('.chain details summary').first().click();
  await cell(page, 'chains[0].start[0]').focus();
  await cell(page, 'chains[0].start[1]').click({ modifiers: ['Shift'] });
  assert.equal(await copied(), '31.420546783\n1.509051435', 'as the document has them, not as they are shown');
  const limit = 'chains[0].joints[1].limits[0].max';
  await cell(page, limit).fill('9');
  await page.keyboard.press('Shift+ArrowLeft');
  await page.keyboard.press('Tab');
  await cell(page, limit).focus();
  await page.keyboard.press('Shift+ArrowLeft');
  await page.keyboard.press('Delete');
  assert.equal(await value(limit), '');
  await noFault(page);
});

test('left and right arrows leave a cell at the ends of its text', async () => {
  await cell(page, at(0, 'a')).focus();
  await page.keyboard.press('ArrowRight');
  assert.equal(await active(), at(0, 'theta'));
  await page.keyboard.press('ArrowLeft');
  assert.equal(await active(), at(0, 'a'));
  await cell(page, 'chains[0].base.y').focus();
  await page.keyboard.press('End');
  await page.keyboard.press('ArrowLeft');
  assert.equal(await active(), 'chains[0].base.y', 'within a text they go through its letters');
});

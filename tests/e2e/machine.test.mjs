// A machine of one's own: a chain's type is typed, copied around an axis, numbers are dragged, the unit is converted, turns
// come in other forms.
import assert from 'node:assert/strict';
import { after, afterEach, before, beforeEach, test } from 'node:test';
import { cell, doTo, faultBeside, motionIsOfDocument, noFault, number, openBrowser, otherMetric, scrubTo, text } from './browser.mjs';

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

const doc = () => page.evaluate(() => document.querySelector('synthetica-linkage').document);
const undo = () => page.getByRole('button', { name: 'Undo' }).click();
const active = () => page.evaluate(() => pageFocus().dataset.path ?? pageFocus().dataset.menu);
const canUndo = () => page.locator('#undo').isEnabled();
const joints = (one, chain) => one.chains[chain].joints.map(({ type }) => type).join('');

test('a chain’s type is typed: letters are checked, joints that stay keep their rows, one step of undo', async () => {
  const before = await doc();
  const field = page.getByRole('textbox', { name: 'type of chain 2' });
  assert.equal(await field.inputValue(), 'RPS');
  await field.fill('r x s');
  await page.keyboard.press('Enter');
  await page.getByText('“X” is no joint. Accepted: letters from base to workpiece, R revolute').waitFor();
  assert.equal(await field.getAttribute('aria-invalid'), 'true');
  await page.keyboard.press('Escape');
  assert.equal(await field.inputValue(), 'RPS');
  assert.equal(await canUndo(), false, 'nothing was edited');

  await field.fill('r r s');
  await page.getByText('Enter makes this chain R R S; Escape keeps RPS.').waitFor();
  await page.keyboard.press('Enter');
  await motionIsOfDocument(page);
  const typed = await doc();
  assert.equal(joints(typed, 1), 'RRS');
  assert.deepEqual(typed.chains[1].joints[0], before.chains[1].joints[0]);
  assert.deepEqual(typed.chains[1].joints[2], before.chains[1].joints[2]);
  assert.equal(await active(), 'chains[1].type', 'the focus stays');
  await undo();
  await motionIsOfDocument(page);
  assert.deepEqual(await doc(), before);
  assert.equal(await canUndo(), false);
});

test('one leg becomes three around an axis, closed at the start, as one step of undo', async () => {
  await doTo(page, 'chain 3', 'Remove');
  await doTo(page, 'chain 2', 'Remove');
  const leg = await doc();
  await doTo(page, 'chain 1', 'Duplicate around an axis…');
  const dialog = page.getByRole('dialog', { name: 'Duplicate chain 1 around an axis' });
  await dialog.getByLabel('Chains in all').fill('1');
  await dialog.getByRole('button', { name: 'Duplicate' }).click();
  await dialog.getByText('Accepted: a whole number from 2 to 24.').waitFor();
  await dialog.getByLabel('Chains in all').fill('3');
  await page.keyboard.press('Enter');
  await dialog.waitFor({ state: 'detached' });
  await motionIsOfDocument(page);
  const { chains } = await doc();
  assert.deepEqual(chains.map(({ name }) => name), ['chain 1', 'chain 2', 'chain 3']);
  assert.deepEqual(chains.map(({ start }) => start), Array(3).fill(leg.chains[0].start));
  assert.equal(await active(), 'chains[0]', 'the focus is at the chain');
  await page.waitForFunction(() => page$('#closure').textContent !== '–');
  assert.ok(number(await text(page, 'closure')) <= 1e-10);
  await undo();
  await motionIsOfDocument(page);
  assert.deepEqual(await doc(), leg);
});

test('a number is dragged beside its cell, the motion follows; one step of undo, and Escape takes it back', async () => {
  await scrubTo(page, 60);
  const path = 'chains[0].base.x';
  const before = await doc();
  // The slider is loaded when a cell is entered: a key at once is not lost.
  await cell(page, path).evaluate((field) => {
    field.focus();
    for (const key of ['PageUp', 'PageUp']) field.dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true, cancelable: true }));
  });
  await page.waitForFunction((at) => page$(`[data-path="${at}"]`).value === '-0.48', path);
  await undo();
  assert.deepEqual(await doc(), before);
  await page.getByRole('tab', { name: 'Mechanism' }).focus();
  const old = await text(page, 'metric');
  const slide = page.locator('.slide');
  await cell(page, path).hover();
  await slide.waitFor({ timeout: 5000 });
  const box = await slide.boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 9, y);
  await page.mouse.move(x + 41, y);
  const seen = await otherMetric(page, old);
  assert.equal((await doc()).chains[0].base.x, before.chains[0].base.x + 0.1, 'ten steps of a hundredth of the size');
  await page.mouse.move(x + 81, y);
  await otherMetric(page, seen);
  await page.mouse.up();
  await undo();
  assert.deepEqual(await doc(), before, 'the whole drag is one step');
  assert.equal(await canUndo(), false);

  await cell(page, path).hover();
  await slide.waitFor({ timeout: 5000 });
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 41, y);
  await page.keyboard.down('Shift');
  await page.mouse.move(x + 4, y);
  await page.mouse.move(x + 5, y);
  await page.keyboard.up('Shift');
  assert.equal((await doc()).chains[0].base.x, before.chains[0].base.x + 0.1, 'with Shift ten steps at once');
  await page.keyboard.press('Escape');
  await page.mouse.up();
  assert.deepEqual(await doc(), before);
  assert.equal(await canUndo(), false, 'nothing is left to undo');

  await cell(page, 'chains[0].base.longitude').focus();
  await page.locator('.slide').waitFor();
  await page.keyboard.press('PageUp');
  await page.keyboard.press('Shift+PageUp');
  assert.equal(await cell(page, 'chains[0].base.longitude').inputValue(), '-79');
  await undo();
  assert.deepEqual(await doc(), before);
});

test('on a phone the slider is there for the cell that has the focus, and a finger drags it', async () => {
  const phone = await browser.openPage({ viewport: { width: 390, height: 844 }, isMobile: true, hasTouch: true });
  const path = 'chains[0].joints[1].rows[0].alpha';
  const field = phone.page.locator(`[data-path="${path}"]`);
  await field.evaluate((node) => node.scrollIntoView({ block: 'center' }));
  await field.tap();
  const slide = phone.page.locator('.slide');
  await slide.waitFor();
  const box = await slide.boundingBox();
  assert.ok(box.width >= 24 && box.height >= 24, `large enough for a finger: ${box.width} by ${box.height}`);
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  const devtools = await phone.page.context().newCDPSession(phone.page);
  const touch = (type, at) => devtools.send('Input.dispatchTouchEvent', { type, touchPoints: at === undefined ? [] : [{ x: at, y }] });
  await touch('touchStart', x);
  await touch('touchMove', x - 20);
  await touch('touchMove', x - 40);
  await touch('touchEnd');
  await phone.page.waitForFunction((at) => page$(`[data-path="${at}"]`).value === '80', path);
  assert.equal(await phone.page.evaluate(() => pageFocus().dataset.path), path, 'the cell keeps the focus');
  assert.deepEqual(phone.problems, []);
  await phone.page.close();
});

test('another unit asks: the numbers are converted with the metric length, or the unit is only renamed', async () => {
  const before = await doc();
  const unit = page.getByRole('textbox', { name: 'unit of length' });
  const choice = page.getByRole('group', { name: 'Another unit of length' });
  await unit.fill('mm');
  await choice.waitFor();
  assert.deepEqual(await doc(), before, 'nothing is changed before the answer');
  await page.keyboard.press('Escape');
  await choice.waitFor({ state: 'hidden' });
  assert.equal(await unit.inputValue(), 'm');

  await unit.fill('mm');
  await page.keyboard.press('Enter');
  assert.equal(await page.evaluate(() => pageFocus().textContent), 'Convert the numbers');
  await page.keyboard.press('Enter');
  await page.getByText('the metric length too, which is 1000 mm now').waitFor();
  const converted = await doc();
  assert.deepEqual([converted.length_unit, converted.chains[0].base.x, converted.planner.metric_length], ['mm', -500, 1000]);
  await undo();
  assert.deepEqual(await doc(), before);

  await page.getByRole('textbox', { name: 'unit of length' }).fill('ell');
  await page.getByText('How the two units compare is not known here').waitFor();
  await choice.getByRole('button', { name: 'Convert the numbers' }).click();
  await choice.getByText('Accepted: a number above 0').waitFor();
  await choice.getByRole('button', { name: 'Only rename' }).click();
  assert.deepEqual(await doc(), { ...before, length_unit: 'ell' });
  assert.equal(await active(), 'length_unit');
});

test('a frame’s turn is typed as quaternion, matrix or roll-pitch-yaw, and is drawn where its angles are typed', async () => {
  const path = 'chains[0].gripper.latitude';
  await cell(page, path).focus();
  const drawing = page.getByRole('img', { name: /longitude turns it about y/ });
  await drawing.waitFor();
  assert.match(await page.locator(`#${await cell(page, path).getAttribute('aria-describedby')}`).textContent(), /R = Y\(lon\) · X\(−lat\) · Z\(roll\)/);
  assert.equal(await page.locator('.turn-drawing figcaption .now').textContent(), 'lat');
  await cell(page, 'chains[0].gripper.x').focus();
  await drawing.waitFor({ state: 'hidden' });

  await page.getByRole('button', { name: 'Gripper frame of chain 1: turn as' }).click();
  const dialog = page.getByRole('dialog', { name: 'Turn of the gripper frame of chain 1' });
  const quaternion = dialog.getByLabel('Quaternion x y z w', { exact: true });
  const use = dialog.getByRole('button', { name: 'Use this turn' });
  assert.equal(await use.isDisabled(), true, 'nothing is typed yet');
  await quaternion.fill('0 0 1 1');
  await dialog.getByText('The length is 1.414213562').waitFor();
  assert.equal(await use.isDisabled(), true);
  await quaternion.fill('0 0 0.7071 0.7071');
  assert.equal(await dialog.getByLabel('Rotation matrix, row by row', { exact: true }).inputValue(), '0 -1 0\n1 0 0\n0 0 1');
  assert.equal(await dialog.getByLabel('Roll, pitch, yaw in degrees', { exact: true }).inputValue(), '0 0 90');
  await use.click();
  await dialog.waitFor({ state: 'detached' });
  const { gripper } = (await doc()).chains[0];
  assert.deepEqual([gripper.longitude, gripper.latitude, gripper.roll, gripper.x], [0, 0, 90, 0.571]);
  await undo();
  assert.equal(await canUndo(), false);

  await page.getByRole('tab', { name: 'Motion', exact: true }).click();
  await doTo(page, 'key frame 2', 'Turn as quaternion, matrix…');
  await page.getByRole('dialog', { name: 'Turn of key frame 2' }).getByLabel('Roll, pitch, yaw in degrees', { exact: true }).fill('0 0 10');
  await page.keyboard.press('Enter');
  await page.getByRole('dialog').waitFor({ state: 'detached' });
  const key = (await doc()).motion.key_frames[1];
  assert.deepEqual([key.name, key.longitude, key.latitude, key.roll], ['between', 0, 0, 10]);
});

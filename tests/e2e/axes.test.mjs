// Chains by their axes, conventions of tables, angles in radians and rotations in other forms, as a person gives them.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, afterEach, before, test } from 'node:test';
import { violations } from './axe.mjs';
import { cell, doTo, faultBeside, noFault, openBrowser, openSample } from './browser.mjs';

const PHONE = { viewport: { width: 390, height: 844 }, isMobile: true, hasTouch: true };

let browser;
let problems;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());
afterEach(() => assert.deepEqual(problems, []));

async function openPage(options) {
  const opened = await browser.openPage(options);
  ({ problems } = opened);
  return opened.page;
}

/** Opens a document as a file, and waits for its motion. */
async function open(page, doc) {
  await page.locator('#file').setInputFiles({ name: 'doc.json', mimeType: 'application/json', buffer: Buffer.from(JSON.stringify(doc)) });
  await page.waitForFunction((name) => page$('[data-path="name"]').value === name, doc.name);
  await planned(page);
}

const planned = (page) =>
  page.waitForFunction(() => {
    const { store } = document.querySelector('synthetica-linkage').parts;
    return store.result.doc === store.doc && !store.result.motion.partial;
  });

const inPage = (page, body) => page.evaluate((text) => new Function('store', `return ${text}`)(document.querySelector('synthetica-linkage').parts.store), body);
const docOf = (page) => inPage(page, 'store.doc');
const poses = (page) => inPage(page, 'Array.from(store.result.motion.pose)');
const statuses = (page) => inPage(page, 'Array.from(store.result.motion.status, (code) => store.result.motion.report.statuses[code])');
const farthest = (a, b) => {
  assert.equal(a.length, b.length);
  return Math.max(...a.map((value, i) => Math.abs(value - b[i])));
};

/** Pastes into the cell that has the focus, as a spreadsheet's text. */
const paste = (page, text) =>
  page.evaluate((words) => {
    const clipboardData = new DataTransfer();
    clipboardData.setData('text/plain', words);
    pageFocus().dispatchEvent(new ClipboardEvent('paste', { clipboardData, bubbles: true, cancelable: true, composed: true }));
  }, text);

const crank = {
  version: 1,
  name: 'by axes',
  length_unit: 'mm',
  home: { x: 0, y: 100 },
  chains: [{ name: 'crank', joints: [{ type: 'R', point: [0, 0, 0], axis: [0, 0, 1] }] }],
  motion: { key_frames: [{ x: 0, y: 100 }, { x: -60, y: 80 }], frames: 17 },
};

test('a four-bar is pasted and typed by its axes, and plans; what is wrong is told at its cell', async () => {
  const page = await openPage();
  await open(page, crank);
  await cell(page, 'chains[0].joints[0].point[0]').focus();
  await paste(page, 'R 0 0 0  0 0 1\nR 0 100 0  0 0 1');
  await page.getByRole('button', { name: '+ chain by axes' }).click();
  await cell(page, 'chains[1].joints[0].point[0]').fill('300');
  await cell(page, 'chains[1].joints[0].point[0]').press('Tab');
  await doTo(page, 'joint 1 of chain 2', 'Insert a joint after');
  await cell(page, 'chains[1].joints[1].point[0]').focus();
  await paste(page, '350\t200\t0\t0\t0\t2');
  await planned(page);
  const { chains, home } = await docOf(page);
  assert.deepEqual(chains[1].joints.map(({ point }) => point), [[300, 0, 0], [350, 200, 0]]);
  assert.deepEqual(home, { x: 0, y: 100 });
  assert.equal(await inPage(page, 'store.result.motion.report.mobility_rank'), 1);
  const shown = await statuses(page);
  assert.ok(shown.every((name) => name === 'closest' || name === 'reached'), shown.join());
  const first = await poses(page);
  assert.ok(Math.hypot(first[0], first[1] - 100) < 1e-6, 'it begins at home');

  // The axes are drawn while one is in their table, also of a document at fault.
  assert.ok(Number(await page.locator('#canvas').getAttribute('data-axes')) >= 8);
  await cell(page, 'chains[1].joints[1].axis[2]').fill('0');
  assert.match(await faultBeside(page, 'chains[1].joints[1].axis[2]'), /no length/);
  await page.getByRole('button', { name: 'Direction along z, joint 2' }).click();
  await noFault(page);
  assert.deepEqual(await violations(page), []);
  await doTo(page, 'chain 2', 'Show the rows…');
  await page.locator('dialog .shown-rows').first().waitFor();
  assert.equal(await page.locator('dialog .shown-rows').first().locator('tbody tr').count(), 2);
  await page.keyboard.press('Escape');
});

test('the point of a joint is picked in the view', async () => {
  const page = await openPage();
  await open(page, crank);
  await cell(page, 'chains[0].joints[0].point[0]').fill('7');
  await page.getByRole('button', { name: 'Pick point in the view, joint 1' }).click();
  await page.locator('#canvas.picking').waitFor();
  const canvas = page.locator('#canvas');
  const { width, height } = await canvas.boundingBox();
  await canvas.click({ position: { x: width / 2, y: height / 2 } });
  await page.locator('#canvas:not(.picking)').waitFor();
  const [joint] = (await docOf(page)).chains[0].joints;
  assert.ok(joint.point.every(Number.isFinite) && joint.point[0] !== 7, JSON.stringify(joint));
  await page.getByRole('button', { name: 'Direction along x, joint 1' }).click();
  assert.deepEqual((await docOf(page)).chains[0].joints[0].axis, [1, 0, 0]);
});

test('rows become axes and rows again, and the motion stays', async () => {
  const page = await openPage();
  await openSample(page, 'four-bar.json');
  await planned(page);
  const before = await poses(page);
  for (const chain of [1, 2]) {
    await page.getByRole('button', { name: `Actions of chain ${chain}`, exact: true }).click();
    await page.getByRole('menuitem', { name: /^Give by axes/ }).click();
    await cell(page, `chains[${chain - 1}].joints[0].axis[0]`).waitFor();
    await planned(page);
  }
  const axes = await docOf(page);
  assert.ok(axes.home && axes.chains.every(({ joints }) => joints.every(({ point, rows }) => point && !rows)));
  assert.ok(farthest(await poses(page), before) < 1e-6);
  await doTo(page, 'chain 1', 'Turn into rows');
  await cell(page, 'chains[0].base.x').waitFor();
  await planned(page);
  assert.ok(farthest(await poses(page), before) < 1e-6);
});

test('a table that was copied in the other convention is noticed, and switched by the warning', async () => {
  const page = await openPage();
  await open(page, JSON.parse(readFileSync('tests/field/cobra600-copied.json', 'utf8')));
  assert.match(await cell(page, 'chains[0].convention').textContent(), /modified \(Craig\): X·Z/);
  await page.locator('#warning-list button', { hasText: 'Read as standard tables' }).evaluate((button) => button.click());
  await page.waitForFunction(() => /standard: Z·X/.test(page$('[data-path="chains[0].convention"]').textContent));
  await planned(page);
  assert.equal(await page.evaluate(() => pageFocus().dataset.path), 'chains[0].convention', 'the focus goes to what was changed');
  const shown = await statuses(page);
  for (const frame of [0, 16, 32]) assert.equal(shown[frame], 'reached', `frame ${frame}`);

  // Converted back, the motion stays.
  const before = await poses(page);
  await cell(page, 'chains[0].convention').click();
  await page.locator('dialog .shown-rows').nth(1).waitFor();
  assert.deepEqual(await violations(page), []);
  await page.getByLabel('Convert the numbers').check();
  await page.getByRole('button', { name: 'Switch', exact: true }).click();
  await page.waitForFunction(() => /modified/.test(page$('[data-path="chains[0].convention"]').textContent));
  await planned(page);
  assert.ok(farthest(await poses(page), before) < 1e-9);
});

test('angles in radians: converted, labelled, and back', async () => {
  const page = await openPage();
  const before = await poses(page);
  const old = await docOf(page);
  const choose = async (unit, how) => {
    await cell(page, 'angles').selectOption(unit);
    await page.getByLabel(how).waitFor();
    assert.equal(await page.evaluate(() => pageFocus().value), 'convert', 'what is proposed has the focus, not the button that closes');
    await page.getByLabel(how).check();
    await page.getByRole('button', { name: `Use ${unit}` }).click();
    await page.locator('dialog').waitFor({ state: 'detached' });
    await planned(page);
  };
  await choose('radians', 'Convert the numbers');
  assert.ok(farthest(await poses(page), before) < 1e-6);
  assert.match(await page.locator('#mechanism .dh th').nth(2).textContent(), /rad/);
  await choose('degrees', 'Convert the numbers');
  const back = await docOf(page);
  assert.equal(back.angles, undefined);
  assert.ok(farthest(back.chains.flatMap(({ start }) => start), old.chains.flatMap(({ start }) => start)) < 1e-9);
});

test('a key frame gives its rotation as a quaternion, and keeps it so, also on a phone', async () => {
  const page = await openPage(PHONE);
  const before = await poses(page);
  await page.getByRole('tab', { name: 'Motion', exact: true }).click();
  await doTo(page, 'key frame 1', 'Turn as quaternion, matrix…');
  await page.getByLabel('form in the document').selectOption('quaternion_wxyz');
  await page.getByRole('button', { name: 'Use this turn' }).click();
  await cell(page, 'motion.key_frames[0].quaternion_wxyz[0]').waitFor();
  await planned(page);
  const { motion: { key_frames: [key] } } = await docOf(page);
  assert.equal(key.quaternion_wxyz.length, 4);
  assert.ok(!('longitude' in key));
  assert.ok(farthest(await poses(page), before) < 1e-6);
  const [rotation, all] = await page.evaluate(() => [page$('.rotation .point'), page$('.keys')].map((node) => node.getBoundingClientRect().width));
  assert.ok(rotation > 0.75 * all, `${rotation} px of ${all}: four numbers have the whole width`);

  // A chain by axes on a phone: every cell can be reached, and the page itself does not scroll sideways.
  await open(page, crank);
  await page.getByRole('tab', { name: 'Mechanism' }).click();
  await cell(page, 'chains[0].joints[0].axis[2]').fill('-1');
  await cell(page, 'chains[0].joints[0].axis[2]').press('Tab');
  assert.deepEqual((await docOf(page)).chains[0].joints[0].axis, [0, 0, -1]);
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
  assert.deepEqual(await violations(page), []);
});

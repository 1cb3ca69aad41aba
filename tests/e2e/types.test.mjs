// Tables 2 and 3, from which a linkage can be built.
import assert from 'node:assert/strict';
import { after, afterEach, before, beforeEach, test } from 'node:test';
import { motionIsOfDocument, openBrowser, openSample } from './browser.mjs';

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
  const offered = page.locator('#notices').getByRole('button', { name: 'Undo' });
  await offered.waitFor();
  await page.keyboard.press('Control+z');
  assert.deepEqual(await types(), ['RPS', 'RPS', 'RPS']);
  // It would take back an older step now.
  assert.equal(await offered.count(), 0);
  await page.locator('#notices').filter({ hasText: 'A chain SP is added.' }).waitFor();
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

test('Table 3 stands in columns, and a row makes a linkage of its assembly, by pointer and by keys', async () => {
  const edges = await page.locator('.assemblies tbody tr td:last-child').evaluateAll((cells) =>
    cells.map((cell) => {
      const range = document.createRange();
      range.selectNodeContents(cell);
      return Math.round(range.getBoundingClientRect().right);
    }),
  );
  assert.equal(new Set(edges).size, 1, `numbers end in one line: ${edges}`);
  await page.locator('[data-assembly="1I-1II"] td:last-child').click();
  await page.getByRole('menuitem', { name: 'New linkage 1RPS+1' }).waitFor();
  await page.keyboard.press('Escape');
  await page.getByRole('button', { name: '1I-1II', exact: true }).focus();
  await page.keyboard.press('Enter');
  await page.keyboard.press('Enter');
  assert.match(await panel().getByRole('textbox', { name: 'Type', exact: true }).inputValue(), /^1RPS\+1/);
  await page.keyboard.press('Enter');
  await sentence(/of type 1I-1II/);
  assert.equal(await page.evaluate(() => pageFocus().textContent), '1I-1II', 'the focus is back at the row');
  await page.getByRole('button', { name: '1I-1II', exact: true }).press('ArrowDown');
  await page.getByRole('menuitem', { name: 'Show the chains of category II' }).nth(0).press('Enter');
  assert.equal(await page.evaluate(() => pageFocus().closest('details').dataset.category), 'II');
});

test('a type begins a new linkage, of as many legs as are asked for', async () => {
  for (const [type, fit, legs] of [['RRS', '5', '3'], ['TR', '1', '1']]) {
    await panel().getByRole('button', { name: type, exact: true }).click();
    await page.getByRole('menuitem', { name: `New linkage of ${type} legs` }).click();
    const number = panel().getByRole('spinbutton', { name: `Legs ${type}` });
    assert.equal(await number.inputValue(), fit);
    await number.fill('24');
    await panel().locator('.new-linkage .fault').filter({ hasText: /no freedom.*at most \d of these legs/ }).waitFor();
    assert.equal(await number.getAttribute('aria-invalid'), 'true');
    await number.fill(legs);
    await page.keyboard.press('Enter');
    await page.waitForFunction(([wanted, many]) => page$$('#mechanism .chain .type').map((node) => node.value).join() === Array(Number(many)).fill(wanted).join(), [type, legs]);
    assert.ok(await page.locator('#fault-banner').isHidden());
    assert.ok(await number.isHidden());
  }
  await page.locator('#undo').click();
  assert.deepEqual(await types(), Array(3).fill('RRS'));
});

test('new: a 3-PRS in millimetres, planned, its first key frame reached, its legs equal', async () => {
  await page.locator('#file-menu').click();
  await page.getByRole('menuitem', { name: 'New…' }).click();
  const dialog = page.getByRole('dialog', { name: 'New linkage' });
  await dialog.getByRole('tab', { name: 'A type and sizes' }).click();
  const field = (name) => dialog.getByRole('textbox', { name, exact: true });
  const fault = dialog.locator('#new-type .fault');
  // A fault is told beside its field while it is typed, and Enter goes there.
  await field('Type').fill('3 PQS');
  await fault.filter({ hasText: /“Q” stands for no joint.*3-PRS/ }).waitFor();
  await field('Type').fill('3 prs');
  await fault.waitFor({ state: 'hidden' });
  await field('Leg length').fill('150');
  await fault.filter({ hasText: /do not reach.*from 201\./ }).waitFor();
  assert.equal(await field('Leg length').getAttribute('aria-invalid'), 'true');
  await field('Base radius').fill('abc');
  await fault.filter({ hasText: /^Base radius: this is the text “abc”\. Accepted: a number\.$/ }).waitFor();
  await field('Base radius').fill('');
  await fault.filter({ hasText: /Base radius: this is missing/ }).waitFor();
  await field('Unit').focus();
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => document.activeElement.name === 'base_radius');
  await field('Base radius').fill('350');
  await field('Leg length').fill('600');
  await fault.waitFor({ state: 'hidden' });
  await page.keyboard.press('Enter');
  await dialog.waitFor({ state: 'hidden' });
  await sentence(/of type 3I/);
  await motionIsOfDocument(page);
  const { doc, status } = await page.evaluate(() => {
    const { document: doc, trajectory } = document.querySelector('synthetica-linkage');
    return { doc, status: trajectory.report.statuses[trajectory.status[0]] };
  });
  assert.equal(status, 'reached');
  assert.deepEqual([doc.length_unit, doc.planner.metric_length], ['mm', 150]);
  assert.deepEqual(doc.motion.key_frames.map(({ name }) => name), ['start', 'raised', 'tilted']);
  for (const { base, joints, gripper } of doc.chains) {
    assert.deepEqual(joints, doc.chains[0].joints);
    assert.deepEqual([joints[2].rows[0].a, gripper.x, Math.round(Math.hypot(base.x, base.y) * 1e6) / 1e6], [600, -150, 350]);
  }
  await page.keyboard.press('Control+z');
  assert.deepEqual(await types(), ['RPS', 'RPS', 'RPS']);
});

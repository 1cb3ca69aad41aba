// Key frames from a table, and a tool path that is too long to be shown whole.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { openBrowser } from './browser.mjs';

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

const open = async (page) => {
  await page.getByRole('tab', { name: 'Motion', exact: true }).click();
  await page.getByRole('button', { name: 'From a table…' }).click();
  return page.getByRole('dialog', { name: 'Key frames from a table' });
};
const count = (page) => page.locator('#motion .title span').first().textContent();

test('a pasted table is read, corrected, and taken over as one step', async () => {
  const { page, problems } = await browser.openPage({ viewport: { width: 1280, height: 800 } });
  const dialog = await open(page);
  const former = await count(page);
  const take = dialog.getByRole('button', { name: 'Take over' });
  assert.ok(await take.isDisabled());
  await dialog.getByLabel('Or its cells, pasted').fill('x;y;z;a;b;c\n0,1;0;0,5;0;0;90\nnothing;0;0;0;0;0\n0,2;0;0,5;0;0;90');
  await dialog.getByRole('status').filter({ hasText: '2 poses. With headings, parted by semicolons' }).waitFor();
  await dialog.getByText('1 row cannot be taken over').click();
  await dialog.getByText('Row 3: “nothing” in column 1 is no number').waitFor();
  await dialog.getByLabel('Rotations').selectOption('roll_pitch_yaw');
  await dialog.getByLabel('Order of the angles').fill('q');
  await dialog.getByRole('alert').filter({ hasText: '“q” is no order' }).waitFor();
  assert.ok(await take.isDisabled());
  await dialog.getByLabel('Order of the angles').fill('zyx');
  await dialog.getByRole('status').filter({ hasText: 'angle 1, angle 2, angle 3' }).waitFor();
  await take.click();
  assert.equal(await count(page), '2 poses');
  await page.keyboard.press('Control+z');
  assert.equal(await count(page), former);
  assert.deepEqual(problems, []);
  await page.context().close();
});

test('a long path from a file is turned page by page; its link is refused with the way out', async () => {
  const { page, problems } = await browser.openPage({ viewport: { width: 1280, height: 800 } });
  const dialog = await open(page);
  // With digits that do not compress.
  const rows = Array.from({ length: 40_000 }, (_, i) => `${i},${0.1 * Math.sin(i * 12.9898)},${0.1 * Math.sin(i * 78.233)},${0.5 + 0.01 * Math.sin(i * 37.719)}`);
  await dialog.getByLabel('A file').setInputFiles({ name: 'path.csv', mimeType: 'text/csv', buffer: Buffer.from(`t,x,y,z\n${rows.join('\n')}`) });
  await dialog.getByRole('status').filter({ hasText: '40000 poses' }).waitFor();
  await dialog.getByRole('radio', { name: 'take the place of the key frames' }).check();
  await dialog.getByRole('button', { name: 'Take over' }).click();
  const pager = page.getByRole('group', { name: 'Pages of key frames' });
  await pager.getByText('1 to 20 of 40000').waitFor();
  await pager.getByRole('button', { name: 'Last page' }).click();
  await page.locator('[data-path="motion.key_frames[39999].x"]').waitFor();
  await pager.getByLabel('Show key frame').fill('1234');
  await page.keyboard.press('Enter');
  await pager.getByText('1221 to 1240 of 40000').waitFor();
  const shown = await page.evaluate(() => ({ rows: page$$('#motion .key').length, ticks: page$$('#ticks button').length, items: page$$('[role=treeitem]').length }));
  assert.ok(shown.rows === 20 && shown.ticks <= 62 && shown.items < 200, JSON.stringify(shown));
  await page.getByRole('button', { name: 'Share' }).click();
  await page.getByText('too large for a link').waitFor();
  assert.deepEqual(problems, []);
  await page.context().close();
});

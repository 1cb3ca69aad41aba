// Documents in addresses: share links, samples, and changes that a person writes.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { cell, keeps, nameIs, notice, openBrowser, openSample, ready, text } from './browser.mjs';

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

const A = 'chains[0].joints[1].rows[0].a';

async function edit(page, value = '0.25', path = A) {
  await cell(page, path).fill(value);
  await page.keyboard.press('Enter');
  await page.locator('#unsaved').waitFor({ state: 'visible' });
}

/** The link that the page makes of its document. */
async function shared(page) {
  await page.evaluate(() => {
    navigator.clipboard.writeText = async (text) => void (window.copied = text);
  });
  await page.getByRole('button', { name: 'Share', exact: true }).click();
  await page.getByRole('button', { name: 'Copy link' }).click();
  await page.locator('dialog .said', { hasText: 'Link copied.' }).waitFor();
  await page.keyboard.press('Escape');
  return page.evaluate(() => window.copied);
}

test('a link carries the whole document into another browser, and gives way to edits', async () => {
  const { page } = await browser.openPage();
  await openSample(page, '2tpr.json');
  await edit(page, 'Größe − 2', 'name');
  const link = await shared(page);
  assert.ok(link.startsWith(`${browser.address}#d=1.`), link);
  assert.ok(link.length < 2500, `${link.length} characters`);

  const { page: other, problems } = await browser.blankPage();
  await other.goto(link);
  await ready(other);
  await nameIs(other, 'Größe − 2');
  assert.equal(other.url(), link);
  assert.ok(await other.locator('#unsaved').isHidden());
  await edit(other, 'Mine', 'name');
  assert.equal(other.url(), browser.address);
  await keeps(other, 'Mine');
  await other.reload();
  await ready(other);
  await nameIs(other, 'Mine');
  assert.deepEqual(problems, []);
});

test('without a clipboard the link is shown to be copied', async () => {
  const { page } = await browser.openPage();
  await page.evaluate(() => {
    navigator.clipboard.writeText = () => Promise.reject(new DOMException('no', 'NotAllowedError'));
  });
  await page.getByRole('button', { name: 'Share', exact: true }).click();
  await page.getByRole('button', { name: 'Copy link' }).click();
  await page.locator('dialog .said', { hasText: 'Ctrl+C' }).waitFor();
  const field = page.getByLabel('Link', { exact: true });
  assert.match(await field.inputValue(), /#d=1\./);
  assert.equal(await page.evaluate(() => getSelection().toString()), await field.inputValue());
});

test('a damaged link says so and opens a sample; one of a newer form too', async () => {
  const { page } = await browser.openPage();
  const link = await shared(page);
  for (const [damaged, words] of [
    [link.slice(0, -20), /missing or changed/],
    [`${browser.address}#d=7.abcdef`, /version 7/],
    [`${browser.address}#d=`, /cannot be opened/],
  ]) {
    const { page: other, problems } = await browser.blankPage();
    await other.goto(damaged);
    await ready(other);
    await notice(other, words).waitFor();
    await nameIs(other, '3RPS');
    assert.equal(other.url(), damaged);
    assert.deepEqual(problems, []);
  }
});

test("a link does not cost one's own work", async () => {
  const { page } = await browser.openPage();
  const link = await shared(page);
  await edit(page, 'Own work', 'name');
  await keeps(page, 'Own work');
  await page.goto('about:blank');
  await page.goto(link);
  await ready(page);
  await nameIs(page, '3RPS');
  await edit(page, 'Changed link', 'name');
  await notice(page, 'Your last document is kept').getByRole('button', { name: 'Restore my last document' }).click();
  await nameIs(page, 'Own work');
  await page.locator('#undo').click();
  await nameIs(page, '3RPS');
});

test('readable changes in the address are applied to a sample, and refused by place', async () => {
  const { page, problems } = await browser.blankPage();
  await page.goto(`${browser.address}?sample=2tpr&set=chains.0.base.x:0.5;motion.frames:7&set=name:Variant, by hand`);
  await ready(page);
  await nameIs(page, 'Variant, by hand');
  assert.equal(await cell(page, 'chains[0].base.x').inputValue(), '0.5');
  assert.match(await text(page, 'frame-number'), /\/ 7$/);
  for (const [set, words] of [
    ['chains.7.name:x', /chains\[7\]\.name.*Accepted/],
    ['motion.frames:many', /frames.*Accepted/],
    ['motion.speed:3', /speed.*Accepted/],
    ['nonsense', /“nonsense”.*Accepted/],
  ]) {
    await page.goto(`${browser.address}?set=${set}`);
    await ready(page);
    await notice(page, words).waitFor();
    await nameIs(page, '3RPS');
  }
  await page.goto(`${browser.address}?set=motion.frames:many;name:Mine;chains.7.name:x`);
  await ready(page);
  await nameIs(page, 'Mine');
  await notice(page, /“motion\.frames:many”.*Accepted/).waitFor();
  await notice(page, /“chains\.7\.name:x”.*Accepted/).waitFor();
  await page.goto(`${browser.address}?sample=nothing`);
  await ready(page);
  await notice(page, /no sample “nothing”/).waitFor();
  assert.deepEqual(problems, []);
});

test('a link put into the address of the open page is opened as a step', async () => {
  const { page } = await browser.openPage();
  await openSample(page, '2tpr.json');
  const link = await shared(page);
  await openSample(page, 'scara.json');
  await page.evaluate((hash) => (location.hash = hash), new URL(link).hash);
  await nameIs(page, '2TPR');
  await page.locator('#undo').click();
  await nameIs(page, 'SCARA');
  // What is wrong with a change beside it is told, and the link opened.
  await page.goto(`${browser.address}?sample=scara.json&set=motion.frames:many`);
  await ready(page);
  await page.evaluate((hash) => (location.hash = hash), new URL(link).hash);
  await nameIs(page, '2TPR');
  await notice(page, /“motion\.frames:many”.*Accepted/).first().waitFor();
});

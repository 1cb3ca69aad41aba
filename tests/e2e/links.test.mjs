// Documents in addresses: share links, samples, and changes that a person writes.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import jsQR from 'jsqr';
import { serve } from '../package/site.mjs';
import { violations } from './axe.mjs';
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

test('a sample that there is not: says which was meant, shows no other, and leads to the examples', async () => {
  const { page, problems } = await browser.blankPage();
  await page.goto(`${browser.address}?sample=2tqr&set=motion.frames:5`);
  const note = page.locator('#linkage > [role=alert]');
  await note.filter({ hasText: /no sample “2tqr”\. Did you mean “2tpr”\? Accepted: .*bennett\.json/ }).waitFor();
  assert.ok(await note.isVisible());
  const [words, buttons] = await Promise.all([note.boundingBox(), page.locator('#view-bar > button').first().boundingBox()]);
  assert.ok(words.y >= buttons.y + buttons.height, 'its words do not lie under the buttons of the view');
  assert.equal(await page.evaluate(() => document.querySelector('synthetica-linkage').document), null);
  assert.deepEqual(await violations(page), []);
  await note.getByRole('button', { name: 'See all examples' }).click();
  await page.locator('[data-sample="2tpr.json"]').click();
  await ready(page);
  await nameIs(page, '2TPR');
  assert.equal(await note.count(), 0);
  // What was not there is no step.
  assert.ok(await page.locator('#undo').isDisabled());
  await page.goto(`${browser.address}?sample=zzzzzzzzzzzz`);
  await note.filter({ hasText: /no sample “zzzzzzzzzzzz”\. Accepted/ }).waitFor();
  assert.deepEqual(problems, []);
});

/** Some other server, with what it was asked. @param {Record<string, string>} headers */
async function elsewhere(headers) {
  const document = { ...JSON.parse(readFileSync(new URL('../../www/mechanisms/2tpr.json', import.meta.url), 'utf8')), name: 'Mine' };
  const site = await serve({ '/mine.json': JSON.stringify(document), '/bad.json': '{"version": 1, "chains": [], "wheels": 4}' }, headers);
  after(() => site.close());
  return site.address;
}

test('one’s own document by its address: without cookies, told, and then an ordinary document', async () => {
  const address = await elsewhere({ 'access-control-allow-origin': '*' });
  const { page, problems } = await browser.blankPage();
  await page.context().addCookies([{ name: 'session', value: 'mine', url: address }]);
  const asking = page.waitForRequest(`${address}/mine.json`);
  const opened = `${browser.address}?src=${encodeURIComponent(`${address}/mine.json`)}&set=motion.frames:9`;
  await page.goto(opened);
  assert.equal((await (await asking).allHeaders()).cookie, undefined);
  await notice(page, `Opened from ${address}/mine.json.`).waitFor();
  await ready(page);
  await nameIs(page, 'Mine');
  assert.match(await text(page, 'frame-number'), /\/ 9$/);
  assert.ok(await page.locator('#unsaved').isHidden());
  await page.reload();
  await ready(page);
  await nameIs(page, 'Mine');
  assert.equal(page.url(), opened);
  await edit(page, 'Changed', 'name');
  assert.equal(page.url(), browser.address);
  await keeps(page, 'Changed');
  await page.reload();
  await ready(page);
  await nameIs(page, 'Changed');
  assert.deepEqual(problems.filter((text) => text !== `asks for ${address}/mine.json`), []);
  // Beside the page itself no header is needed.
  await page.goto(`${browser.address}?src=mechanisms/2tpr.json`);
  await ready(page);
  await nameIs(page, '2TPR');
});

test('an address that no document can be had from: says where, what, and what would do; shows no other', async () => {
  const [open, closed] = [await elsewhere({ 'access-control-allow-origin': '*' }), await elsewhere({})];
  const { page } = await browser.blankPage();
  await page.route('**/none.json', (route) => route.fulfill({ status: 404, headers: { 'access-control-allow-origin': '*' } }));
  for (const [src, words] of [
    [`${closed}/mine.json`, /127\.0\.0\.1:\d+\/mine\.json could not be loaded.*Accepted: .*lets other pages read it \(with the header Access-Control-Allow-Origin\)/],
    ['none.json', /none\.json could not be loaded \(404.*Accepted: .*on this server/],
    [`${open}/bad.json`, /bad\.json cannot be opened\. .*wheels.*Accepted/],
    ['javascript:alert(1)', /src is “javascript:alert\(1\)”\. Accepted/],
  ]) {
    await page.goto(`${browser.address}?src=${encodeURIComponent(src)}`);
    await page.locator('#linkage > [role=alert]').filter({ hasText: words }).waitFor();
    assert.equal(await page.evaluate(() => document.querySelector('synthetica-linkage').document), null, src);
  }
});

test('the QR code in the share dialog is read as the link, also in the dark scheme; where the link is too long that is said', async () => {
  const { page, problems } = await browser.openPage({ colorScheme: 'dark', viewport: { width: 1200, height: 1100 } });
  assert.deepEqual(await page.evaluate(() => performance.getEntriesByType('resource').filter(({ name }) => /\/qr-/.test(name))), [], 'not before it is asked for');
  await page.getByRole('button', { name: 'Share', exact: true }).click();
  const picture = page.getByRole('img', { name: 'QR code of the link' });
  await picture.scrollIntoViewIfNeeded();
  const shot = await picture.screenshot({ scale: 'css' });
  const { data, width, height } = await page.evaluate(async (base64) => {
    const bitmap = await createImageBitmap(new Blob([Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0))]));
    const canvas = Object.assign(document.createElement('canvas'), { width: bitmap.width, height: bitmap.height });
    const context = canvas.getContext('2d');
    context.drawImage(bitmap, 0, 0);
    return { width: bitmap.width, height: bitmap.height, data: [...context.getImageData(0, 0, bitmap.width, bitmap.height).data] };
  }, shot.toString('base64'));
  assert.equal(jsQR(new Uint8ClampedArray(data), width, height, { inversionAttempts: 'dontInvert' })?.data, await page.getByLabel('Link', { exact: true }).inputValue());
  assert.deepEqual(await violations(page), []);
  await page.keyboard.press('Escape');
  let at = 1;
  const noise = Array.from({ length: 1900 }, () => String.fromCharCode(0x4e00 + ((at = (at * 48271) % 2147483647) % 20000))).join('');
  await page.locator('#about-button').click();
  await page.locator('#about-text').fill(noise);
  await page.keyboard.press('Escape');
  await page.getByRole('button', { name: 'Share', exact: true }).click();
  await page.locator('dialog p', { hasText: /too long for a QR code, which holds 2.953 characters/ }).waitFor();
  assert.equal(await picture.count(), 0);
  assert.deepEqual(problems, []);
});

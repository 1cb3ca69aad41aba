// Whoever gets a copy gets the licences of what is in it: on the site, in its scripts for other pages, in what is exported.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { after, before, test } from 'node:test';
import { openBrowser } from './browser.mjs';
import { assertLicensed, crates, imported, packages } from './licensed.mjs';

const dist = (file) => readFileSync(new URL(`../../www/dist/${file}`, import.meta.url), 'utf8');
const OWN = readFileSync(new URL('../../LICENSE-MIT', import.meta.url), 'utf8').trim();

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

test('the site has the licence of every crate in the wasm and of every package that the page imports', async () => {
  assert.ok(['lit-html', 'mediabunny', 'three', 'uplot'].every((name) => imported().includes(name)), imported().join());
  const text = dist('licences.txt');
  assertLicensed(text, [...crates(), ...packages(imported())]);
  assert.ok(text.includes(OWN));
  assert.match(text, /^rust-std \d+\.\d+\.\d+, /m);
  const { page } = await browser.blankPage();
  await page.goto(`${browser.address}method.html`);
  await page.getByRole('contentinfo').getByRole('link', { name: /licences/i }).click();
  assert.equal(await page.locator('body').innerText().then((shown) => shown.includes('three ')), true);
});

test('the help of the applet leads to the licences', async () => {
  const { page } = await browser.openPage();
  await page.getByRole('button', { name: 'Help' }).click();
  const [opened] = await Promise.all([page.waitForEvent('popup'), page.getByRole('menuitem', { name: 'Licences' }).click()]);
  await opened.waitForLoadState();
  assert.match(opened.url(), /\/licences\.txt$/);
  assert.match(await opened.locator('body').innerText(), /^synthetica \d/);
});

test('inline.js begins with the licences of all that is in it', () => {
  const script = dist('inline.js');
  const comment = script.slice(0, script.indexOf('*/'));
  assert.ok(comment.startsWith('/*! synthetica '));
  assertLicensed(comment, [...crates(), ...packages(['lit-html', 'three', 'uplot'])]);
  assert.ok(comment.includes(OWN));
});

for (const [what, save, parts] of [
  [
    'a motion as one HTML file',
    async (page) => {
      await page.getByRole('button', { name: 'Export', exact: true }).click();
      await page.getByRole('menuitem', { name: /HTML/ }).click();
    },
    // The motion is solved: there is no planner in it, and no panel.
    () => packages(['three']),
  ],
  [
    'a linkage as one HTML file',
    async (page) => {
      await page.getByRole('button', { name: 'Share' }).click();
      await page.getByRole('button', { name: 'Save the file' }).click();
    },
    () => [...crates(), ...packages(['lit-html', 'three', 'uplot'])],
  ],
])
  test(`${what} has the licences of all that is in it`, async () => {
    const { page } = await browser.openPage();
    const [download] = await Promise.all([page.waitForEvent('download'), save(page)]);
    const file = await readFile(await download.path(), 'utf8');
    assertLicensed(file, parts());
    assert.ok(file.includes(OWN));
  });

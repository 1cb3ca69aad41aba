// axe-core finds nothing to complain about in any panel, menu or dialog, in either scheme, on a desktop and a phone;
// and no text is cut off, at twice the size too.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { violations } from './axe.mjs';
import { cell, doTo, faultBeside, openBrowser, unfoldCharts } from './browser.mjs';

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

/** Visible texts that their boxes cut off, or that reach out of the window. */
const cutOff = (page) =>
  page.evaluate(() => {
    const found = [];
    for (const box of document.body.querySelectorAll('*')) {
      const own = [...box.childNodes].some((node) => node.nodeType === Node.TEXT_NODE && node.textContent.trim());
      if (!own || !box.checkVisibility({ checkVisibilityCSS: true }) || box.closest('.sr, svg, math, option')) continue;
      const style = getComputedStyle(box);
      // For screen readers only.
      if (style.clipPath === 'inset(50%)') continue;
      const across = style.overflowX !== 'visible' && !['auto', 'scroll'].includes(style.overflowX) && box.scrollWidth > box.clientWidth + 1;
      const down = style.overflowY !== 'visible' && !['auto', 'scroll'].includes(style.overflowY) && box.scrollHeight > box.clientHeight + 2;
      if (across || down) found.push(`${box.tagName}.${box.className}#${box.id}: ${box.textContent.slice(0, 40)}`);
    }
    return found;
  });

/** Shows every panel, menu and dialog in turn. @param {(what: string) => Promise<void>} look */
async function everywhere(page, look) {
  // Folded on a phone that is held across.
  const tables = page.locator('#fold-tables');
  if ((await tables.isVisible()) && (await tables.getAttribute('aria-expanded')) === 'false') await tables.click();
  for (const tab of await page.locator('[role=tab]:visible').all()) {
    const name = await tab.textContent();
    await tab.click();
    for (const fold of await page.locator('[role=tabpanel]:visible details:not([open]) > summary').all()) if (await fold.isVisible()) await fold.click();
    await look(`panel ${name}`);
  }
  await page.getByRole('tab', { name: 'Mechanism' }).click();
  const menus = page.locator('button[aria-haspopup=menu]:visible');
  const seen = new Set();
  for (let i = 0; i < (await menus.count()); i++) {
    const name = (await menus.nth(i).getAttribute('aria-label')) ?? (await menus.nth(i).textContent());
    // The menus of every chain and joint are one menu.
    const kind = name.replace(/\d+/g, 'n');
    if (seen.has(kind)) continue;
    seen.add(kind);
    await menus.nth(i).click();
    await page.locator('[role=menu]:popover-open').waitFor();
    await look(`menu ${name}`);
    await page.keyboard.press('Escape');
  }
  for (const item of ['Keys', 'What the numbers mean']) {
    await page.getByRole('button', { name: 'Help' }).click();
    await page.getByRole('menuitem', { name: item }).click();
    await page.getByRole('dialog').waitFor();
    await look(`dialog ${item}`);
    await page.keyboard.press('Escape');
    await page.getByRole('dialog').waitFor({ state: 'detached' });
  }
}

const PLACES = {
  'desktop, light': { viewport: { width: 1280, height: 800 } },
  'desktop, dark': { viewport: { width: 1280, height: 800 }, colorScheme: 'dark' },
  'phone, light': { viewport: { width: 390, height: 844 }, isMobile: true, hasTouch: true },
  'phone, dark': { viewport: { width: 390, height: 844 }, isMobile: true, hasTouch: true, colorScheme: 'dark' },
};

for (const [name, options] of Object.entries(PLACES)) {
  test(`axe finds nothing: ${name}`, async () => {
    const { page, problems } = await browser.openPage(options);
    const found = [];
    await everywhere(page, async (what) => found.push(...(await violations(page)).map((violation) => `${what}: ${violation}`)));
    assert.deepEqual(found, []);
    assert.deepEqual(problems, []);
  });
}

test('axe finds nothing in the gallery, the form for a new linkage, the export of a picture, what is said of the document, and with things in hand', async () => {
  const { page } = await browser.openPage({ viewport: { width: 1280, height: 800 } });
  await page.getByRole('button', { name: 'Examples', exact: true }).click();
  await page.locator('dialog.gallery').waitFor();
  assert.deepEqual(await violations(page), [], 'gallery');
  await page.keyboard.press('Escape');
  await page.getByRole('button', { name: 'New', exact: true }).click();
  await page.getByRole('combobox', { name: 'Find a mechanism' }).fill('delta');
  await page.getByRole('textbox', { name: 'base', exact: true }).fill('0');
  await page.locator('.maker-form .fault:not([hidden])').waitFor();
  await page.locator('.maker-drawing svg').waitFor();
  assert.deepEqual(await violations(page), [], 'new mechanism');
  await page.getByRole('tab', { name: 'Empty' }).click();
  assert.deepEqual(await violations(page), [], 'new and empty');
  await page.getByRole('tab', { name: 'A type and sizes' }).click();
  await page.getByRole('textbox', { name: 'Leg length' }).fill('1');
  await page.locator('#new-type .fault:not([hidden])').waitFor();
  assert.deepEqual(await violations(page), [], 'new linkage');
  await page.keyboard.press('Escape');
  await page.getByRole('button', { name: 'Export', exact: true }).click();
  await page.getByRole('menuitem', { name: /PNG/ }).click();
  await page.getByRole('dialog').waitFor();
  assert.deepEqual(await violations(page), [], 'picture');
  await page.keyboard.press('Escape');
  await page.locator('#about-button').click();
  await page.locator('#about-panel').waitFor();
  assert.deepEqual(await violations(page), [], 'about');
  await page.keyboard.press('Escape');
  await cell(page, 'chains[0].gripper.roll').focus();
  await page.locator('.turn-drawing').waitFor();
  await page.getByRole('textbox', { name: 'unit of length' }).fill('mm');
  assert.deepEqual(await violations(page), [], 'unit');
  await page.keyboard.press('Escape');
  await page.getByRole('textbox', { name: 'type of chain 1' }).fill('rz');
  await page.keyboard.press('Enter');
  assert.deepEqual(await violations(page), [], 'type of a chain');
  await page.keyboard.press('Escape');
  await cell(page, 'chains[0].gripper.roll').focus();
  await page.locator('.turn-drawing').waitFor();
  assert.deepEqual(await violations(page), [], 'drawing and slider');
  for (const name of ['Gripper frame as quaternion, matrix…', 'Duplicate around an axis…']) {
    await doTo(page, 'chain 1', name);
    await page.getByRole('dialog').waitFor();
    assert.deepEqual(await violations(page), [], name);
    await page.keyboard.press('Escape');
  }
  await page.locator('[data-item="workpiece"]').click();
  await page.getByRole('button', { name: 'Freedoms', exact: true }).click();
  await page.locator('[data-freedom]').first().waitFor();
  await page.getByRole('button', { name: /Forwards along freedom 1/ }).click();
  await page.getByText('Back to the motion').first().waitFor();
  assert.deepEqual(await violations(page), [], 'in hand');
});

for (const [name, options] of [['desktop, dark', PLACES['desktop, dark']], ['phone, light', PLACES['phone, light']]]) {
  test(`axe finds nothing in the best motion and the ways to assemble, and nothing is cut off: ${name}`, async () => {
    const { page } = await browser.openPage(options);
    if (!options.isMobile) await unfoldCharts(page);
    await page.getByRole('tab', { name: 'Best motion' }).click();
    await page.getByRole('button', { name: 'Look for a better motion' }).click();
    await page.getByRole('tabpanel', { name: 'Best motion' }).locator('.calm-curve, .best-verdict:has-text("best one")').first().waitFor({ timeout: 180_000 });
    await page.locator('#best summary').click();
    assert.deepEqual(await violations(page), [], 'best motion');
    assert.deepEqual(await cutOff(page), []);
    await page.getByRole('button', { name: 'Ways to assemble…' }).click();
    await page.locator('.best-mode').waitFor({ timeout: 180_000 });
    assert.deepEqual(await violations(page), [], 'ways to assemble');
    assert.deepEqual(await cutOff(page), []);
  });
}

test('axe finds nothing while a fault is shown, in a lesson, and in the first minute', async () => {
  const { page } = await browser.openPage({ firstVisit: true, viewport: { width: 1280, height: 800 } });
  await page.getByRole('region', { name: 'First minute' }).waitFor();
  assert.deepEqual(await violations(page), [], 'first minute');
  await page.getByRole('button', { name: 'Skip' }).click();
  const path = 'chains[0].joints[1].rows[0].a';
  await cell(page, path).fill('abc');
  await page.keyboard.press('Enter');
  await faultBeside(page, path);
  assert.deepEqual(await violations(page), [], 'fault');
  await page.goto(`${browser.address}?lesson=why`);
  await page.getByRole('heading', { name: 'Why the 3RPS cannot follow' }).waitFor();
  assert.deepEqual(await violations(page), [], 'lesson');
});

const SIZES = {
  // 1280 × 800 at 200 % is a window of 640 × 400.
  'at 200 %': { viewport: { width: 640, height: 400 }, deviceScaleFactor: 2 },
  'on a phone, upright': { viewport: { width: 390, height: 844 }, isMobile: true, hasTouch: true },
  'on a phone, across': { viewport: { width: 844, height: 390 }, isMobile: true, hasTouch: true },
  'on a desktop': { viewport: { width: 1280, height: 800 } },
};
for (const [name, options] of Object.entries(SIZES)) {
  test(`no text is cut off ${name}`, async () => {
    const { page } = await browser.openPage(options);
    const found = [];
    await everywhere(page, async (what) => {
      found.push(...(await cutOff(page)).map((box) => `${what}: ${box}`));
      const over = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
      if (over > 0) found.push(`${what}: sticks out by ${over} pixels`);
    });
    assert.deepEqual(found, []);
  });
}

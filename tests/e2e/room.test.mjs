// Room for the view: its share of the window in every size, panels that fold away, the view alone, the order of the info panel.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { openBrowser, openSample, scrubTo, text, unfoldCharts } from './browser.mjs';
import { openGuestPage } from './guest-page.mjs';

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

const TOUCH = { isMobile: true, hasTouch: true };
const DESKTOP = { viewport: { width: 1280, height: 720 } };

/** The part of the window that the canvas has, of what is in sight. */
const share = (page) =>
  page.evaluate(() => {
    const { top, bottom, width } = page$('#canvas').getBoundingClientRect();
    return ((Math.min(bottom, innerHeight) - Math.max(top, 0)) * width) / innerWidth / innerHeight;
  });
const button = (page, name) => page.getByRole('button', { name, exact: true });
const focused = (page) => page.evaluate(() => pageFocus().id);
const overflow = (page) => page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);

/** Every number of a table of a joint is as wide as its field, and its table no wider than its frame. */
const cutTables = (page) =>
  page.evaluate(() => {
    const cut = page$$('.dh input.cell').filter((field) => field.scrollWidth > field.clientWidth).map((field) => field.dataset.path);
    const wide = page$$('.scroller:has(> .dh)').filter((frame) => frame.scrollWidth > frame.clientWidth + 1).map((frame) => `${frame.scrollWidth} > ${frame.clientWidth}`);
    return [...cut, ...wide];
  });

const SIZES = {
  'at 1440 × 900': [0.5, { viewport: { width: 1440, height: 900 } }],
  'at 1280 × 720': [0.45, DESKTOP],
  'at 1920 × 1080': [0.55, { viewport: { width: 1920, height: 1080 } }],
  'on a tablet, upright': [0.45, { viewport: { width: 820, height: 1180 }, ...TOUCH }],
  'on a tablet, across': [0.45, { viewport: { width: 1180, height: 820 }, ...TOUCH }],
  'on a phone, upright': [0.42, { viewport: { width: 390, height: 844 }, ...TOUCH }],
  'on a phone, across': [0.5, { viewport: { width: 844, height: 390 }, ...TOUCH }],
  'on a small phone, across': [0.5, { viewport: { width: 667, height: 375 }, ...TOUCH }],
};
for (const [name, [least, options]] of Object.entries(SIZES)) {
  test(`the view has ${Math.round(100 * least)} % of the window ${name}, and no number is cut`, async () => {
    const { page, problems } = await browser.openPage(options);
    const has = await share(page);
    assert.ok(has >= least - 0.001, `${(100 * has).toFixed(1)} %`);
    assert.equal(await overflow(page), 0);
    if (options.viewport.width >= 760) assert.deepEqual(await cutTables(page), []);
    assert.deepEqual(problems, []);
  });
}

test('on a phone held across, what is scrolled or unfolded leaves the view in sight', async () => {
  const wide = await browser.openPage({ viewport: { width: 844, height: 390 }, ...TOUCH });
  assert.equal(await wide.page.locator('#tables').isVisible(), false);
  await button(wide.page, 'Tables').tap();
  await wide.page.locator('#mechanism').waitFor();
  assert.ok((await share(wide.page)) > 0.35);
  const small = await browser.openPage({ viewport: { width: 667, height: 375 }, ...TOUCH });
  await small.page.getByRole('tab', { name: 'Motion', exact: true }).tap();
  await small.page.locator('#motion input').last().scrollIntoViewIfNeeded();
  assert.ok((await small.page.evaluate(() => scrollY)) > 100, 'the page is scrolled');
  assert.ok((await share(small.page)) >= 0.5);
  const [stage, cell] = [await small.page.locator('.stage').boundingBox(), await small.page.locator('#motion input').last().boundingBox()];
  assert.ok(cell.y + cell.height / 2 < 375 && cell.y + cell.height / 2 > stage.y + stage.height, 'the cell is beside it');
});

test('tables and info panel are folded by buttons, by pointer and keyboard; the choice and the charts’ are remembered', async () => {
  const { page, problems } = await browser.openPage(DESKTOP);
  const before = await share(page);
  await page.locator('#mechanism input').first().focus();
  await button(page, 'Tables').click();
  assert.equal(await page.locator('#tables').isVisible(), false);
  assert.equal(await button(page, 'Tables').getAttribute('aria-expanded'), 'false');
  const without = await share(page);
  assert.ok(without > before + 0.2, `${without} of ${before}`);
  await button(page, 'Info panel').focus();
  await page.keyboard.press('Enter');
  assert.equal(await page.locator('#info').isVisible(), false);
  assert.equal(await focused(page), 'fold-info', 'the focus stays');
  assert.ok((await share(page)) > without + 0.1);
  await page.reload();
  await page.waitForFunction(() => (page$('#closure')?.textContent ?? '–') !== '–');
  assert.deepEqual(await Promise.all(['#tables', '#info', '#charts'].map((id) => page.locator(id).isVisible())), [false, false, false]);
  await button(page, 'Info panel').click();
  await button(page, 'Tables').click();
  await unfoldCharts(page);
  await page.reload();
  await page.locator('#charts').waitFor();
  assert.deepEqual(await Promise.all(['#tables', '#info'].map((id) => page.locator(id).isVisible())), [true, true]);
  assert.deepEqual(problems, []);
});

test('what asks for a panel unfolds it', async () => {
  const { page } = await browser.openPage(DESKTOP);
  await button(page, 'Tables').click();
  await page.locator('#skip').focus();
  await page.keyboard.press('Enter');
  assert.ok(await page.evaluate(() => page$('#mechanism').contains(pageFocus())), 'the link to the tables');
  await page.locator('#mechanism input[data-path$=".a"]').first().fill('abc');
  await page.keyboard.press('Enter');
  await page.getByRole('button', { name: 'Go to it' }).waitFor();
  await button(page, 'Tables').click();
  await page.getByRole('button', { name: 'Go to it' }).click();
  assert.match(await page.evaluate(() => pageFocus().dataset.path), /\.a$/, 'the cell at fault');
});

test('nothing of the charts is loaded while they are folded', async () => {
  const { page } = await browser.blankPage({ viewport: { width: 1440, height: 900 } });
  const asked = [];
  page.on('request', (request) => asked.push(request.url()));
  await page.goto(browser.address);
  await page.waitForFunction(() => (page$('#closure')?.textContent ?? '–') !== '–');
  await page.waitForLoadState('networkidle');
  assert.deepEqual(asked.filter((url) => /chart|plot/i.test(url)), []);
  assert.equal(await page.locator('#charts').isVisible(), false);
  await unfoldCharts(page);
  await page.locator('#charts .chart').first().waitFor();
});

test('the view alone: by its key, its button and Escape; nothing hidden has the focus, and it is told', async () => {
  const { page, problems } = await browser.openPage(DESKTOP);
  const seen = () => Promise.all(['header.bar', '#tables', '#info', '#dock', '#canvas', '.transport'].map((id) => page.locator(id).isVisible()));
  const [ALL, ALONE] = [[true, true, true, true, true, true], [false, false, false, false, true, true]];
  await page.locator('#canvas').focus();
  await page.keyboard.press('v');
  assert.deepEqual(await seen(), ALONE);
  assert.ok((await share(page)) > 0.9, `${await share(page)}`);
  assert.equal(await focused(page), 'canvas');
  assert.match(await text(page, 'view-live'), /^Only the view .* Escape/);
  await page.keyboard.press('v');
  assert.deepEqual(await seen(), ALL);
  assert.equal(await text(page, 'view-live'), 'The panels are back.');
  await button(page, 'View only').click();
  assert.deepEqual(await seen(), ALONE);
  assert.equal(await button(page, 'View only').getAttribute('aria-pressed'), 'true');
  await page.keyboard.press('Escape');
  assert.deepEqual(await seen(), ALL);
  assert.equal(await focused(page), 'view-only');
  // From a chart, which goes.
  await unfoldCharts(page);
  const choose = page.getByRole('button', { name: 'Choose charts' });
  await choose.focus();
  await page.keyboard.press('v');
  assert.deepEqual(await seen(), ALONE);
  assert.equal(await focused(page), 'canvas');
  // Escape is first for what is open, then for what is selected.
  await page.getByRole('button', { name: 'Views' }).click();
  await page.keyboard.press('Escape');
  assert.deepEqual(await seen(), ALONE);
  await page.locator('#canvas').focus();
  await page.keyboard.press(']');
  await page.keyboard.press('Enter');
  const things = () => page.evaluate(() => ['selected', 'hovered'].map((name) => document.querySelector('synthetica-linkage').parts.store.view[name]).join(''));
  assert.notEqual(await things(), '');
  while ((await things()) !== '') {
    await page.keyboard.press('Escape');
    assert.deepEqual(await seen(), ALONE, 'it was for what is selected or pointed at');
  }
  await page.keyboard.press('Escape');
  assert.deepEqual(await seen(), ALL);
  // A letter in a field is a letter.
  await page.locator('[data-path="name"]').focus();
  await page.keyboard.type('v');
  await page.selectOption('#loop', 'once');
  await page.locator('#loop').focus();
  await page.keyboard.press('v');
  assert.deepEqual(await seen(), ALL);
  assert.deepEqual(problems, []);
});

test('the view alone on a phone fills the window', async () => {
  const { page } = await browser.openPage({ viewport: { width: 390, height: 844 }, ...TOUCH });
  await button(page, 'View only').tap();
  await page.waitForFunction(() => page$('#tables').getClientRects().length === 0);
  assert.ok((await share(page)) > 0.8, `${await share(page)}`);
  assert.equal(await overflow(page), 0);
  const bar = await page.locator('.transport').boundingBox();
  assert.ok(bar.y + bar.height <= 845, 'the animation bar is in sight');
  await button(page, 'View only').tap();
  await page.locator('#mechanism').waitFor();
});

test('the info panel: verdict, gap and why first, then the certificate under a fold, motion, warnings, mobility', async () => {
  const { page } = await browser.openPage({ viewport: { width: 1280, height: 900 } });
  await scrubTo(page, 60);
  await page.locator('#why .shares li').first().waitFor();
  const order = await page.evaluate(() => {
    const parts = ['#frame-word', '#frame-meaning', '#gap-translation', '#gap-rotation', '#why-title', '#certificate', '#motion-summary', '#warnings', '#mobility-rank'].map(page$);
    return parts.every((part, at) => at === 0 || parts[at - 1].compareDocumentPosition(part) & Node.DOCUMENT_POSITION_FOLLOWING);
  });
  assert.ok(order);
  for (const id of ['frame-word', 'gap-translation', 'gap-rotation', 'why-title']) assert.ok(await page.locator(`#${id}`).isVisible(), id);
  assert.equal(await page.locator('#closure').isVisible(), false, 'closed at first');
  assert.equal(await page.locator('#certificate-fault').isVisible(), false, 'within its bounds');
  await page.locator('#certificate summary').click();
  for (const id of ['metric', 'closure', 'sigma', 'gradient', 'curvature', 'iterations']) assert.ok(await page.locator(`#${id}`).isVisible(), id);
  assert.equal(await page.locator('#certificate #gap-translation').count(), 0);
  await openSample(page, 'bennett.json');
  assert.ok(await page.locator('#closure').isVisible(), 'stays open for another document');
});

test('a certificate that fails is told on its fold', async () => {
  const { page } = await browser.openPage(DESKTOP);
  await page.evaluate(() => {
    const { store } = document.querySelector('synthetica-linkage').parts;
    const { motion } = store.result;
    const open = { ...motion, closure: motion.closure.slice() };
    open.closure[0] = 1e-3;
    store.setResult({ motion: open });
  });
  await page.locator('#certificate-fault').filter({ hasText: 'not within its bound: closure' }).waitFor();
  assert.equal(await page.locator('#closure').isVisible(), false);
  await page.locator('#certificate summary').click();
  assert.equal(await page.locator('#certificate .out').count(), 1);
});

test('until the planner has been asked why, the panel says what it can and offers the rest', async () => {
  const { page, problems } = await openGuestPage(browser, '<div id="here"></div>');
  await page.evaluate(async () => {
    await customElements.whenDefined('synthetica-linkage');
    const element = Object.assign(document.createElement('synthetica-linkage'), { type: '3RPS', controls: true, panels: 'info' });
    // It is not asked, as far as the panel can tell.
    element.parts.planner.explain = () => new Promise(() => {});
    document.querySelector('#here').append(element);
    await element.whenReady();
  });
  const why = page.getByRole('region', { name: 'Why not closer' });
  await why.getByText('The goal is met; nothing holds it back.').waitFor();
  await why.getByRole('button', { name: 'Show the freedoms here' }).waitFor();
  await scrubTo(page, 60);
  await why.getByRole('button', { name: 'Show what holds it back' }).click();
  await why.getByText('The planner is being asked').waitFor();
  assert.equal(await focused(page), 'why', 'the focus is not lost with the button');
  assert.deepEqual(problems, []);
});

// The first minute, the keys, the numbers, the lessons.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { cell, openBrowser, text } from './browser.mjs';

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

const fromMenu = async (page, item) => {
  await page.getByRole('button', { name: 'Help' }).click();
  await page.getByRole('menuitem', { name: item }).click();
};

test('the first minute comes once, walks through the page, and comes again only when asked', async () => {
  const { page, problems } = await browser.openPage({ firstVisit: true });
  const note = page.getByRole('region', { name: 'First minute' });
  await note.waitFor();
  assert.equal(await page.evaluate(() => pageFocus() === document.body), true, 'the focus is left alone');
  const texts = [];
  for (;;) {
    texts.push(await note.locator('p').textContent());
    const box = await note.boundingBox();
    assert.ok(box.x >= 0 && box.y >= 0 && box.x + box.width <= 800 && box.y + box.height <= 600, 'the note is in the window');
    assert.equal(await page.locator('.tour-here').count(), 1, texts.at(-1));
    const next = note.getByRole('button', { name: /Next|Done/ });
    const last = (await next.textContent()) === 'Done';
    await next.click();
    if (last) break;
  }
  assert.equal(new Set(texts).size, texts.length);
  await note.waitFor({ state: 'detached' });

  await page.reload();
  await page.waitForFunction(() => (page$('#closure')?.textContent ?? '–') !== '–');
  assert.equal(await note.count(), 0);
  await fromMenu(page, 'First minute');
  await note.waitFor();
  await page.keyboard.press('Escape');
  await note.waitFor({ state: 'detached' });
  assert.deepEqual(problems, []);
});

test('the first minute can be skipped, and the page is usable beside it', async () => {
  const { page } = await browser.openPage({ firstVisit: true });
  await page.locator('#step-forward').click();
  assert.match(await text(page, 'frame-number'), /^2 \//);
  // Escape in a cell is the cell's; anywhere else it ends the tour.
  const note = page.getByRole('region', { name: 'First minute' });
  await cell(page, 'chains[0].base.x').focus();
  await page.keyboard.press('Escape');
  assert.equal(await note.count(), 1);
  await page.locator('#step-forward').focus();
  await page.keyboard.press('Escape');
  await note.waitFor({ state: 'detached' });
  assert.equal(await page.evaluate(() => pageFocus().id), 'step-forward', 'the focus is left alone');
  await fromMenu(page, 'First minute');
  await page.getByRole('button', { name: 'Skip' }).click();
  await page.reload();
  await page.waitForFunction(() => (page$('#closure')?.textContent ?? '–') !== '–');
  assert.equal(await page.getByRole('region', { name: 'First minute' }).count(), 0);
});

test('? lists the keys, from the menu too; Escape gives the focus back', async () => {
  const { page, problems } = await browser.openPage();
  // The view tells its keys as the list does.
  assert.match((await page.locator('#canvas').getAttribute('aria-label')) ?? '', /^3D view of the linkage\. arrow keys: turn the view\. .* 1 to 7: view from the front, .* Enter: select what is pointed at\.$/);
  await page.locator('#scrub').focus();
  await page.keyboard.press('?');
  const dialog = page.getByRole('dialog', { name: 'Keys' });
  await dialog.getByText('play or pause').waitFor();
  await page.keyboard.press('Escape');
  await dialog.waitFor({ state: 'detached' });
  assert.equal(await page.evaluate(() => pageFocus().id), 'scrub');
  await fromMenu(page, 'Keys');
  await dialog.waitFor();
  assert.deepEqual(problems, []);
});

test('every number of the info panel is explained', async () => {
  const { page } = await browser.openPage({ viewport: { width: 1280, height: 800 } });
  const plain = (list) => list.map((name) => name.replace(/[\s_]|½‖q − g‖²|\[A\]|of/g, '').toLowerCase());
  const named = plain(await page.locator('#info .numbers dt').allTextContents());
  await fromMenu(page, 'What the numbers mean');
  const dialog = page.getByRole('dialog', { name: 'What the numbers mean' });
  await dialog.waitFor();
  const explained = plain(await dialog.locator('dt').allTextContents());
  for (const name of named) assert.ok(explained.includes(name), `${name} is explained`);
  assert.ok((await dialog.locator('math').count()) > 5, 'with equations');
});

test('the pages of the site open beside the applet', async () => {
  const { page } = await browser.openPage();
  for (const [item, heading] of [['Gallery', 'Gallery'], ['Course', 'Mobility, and how close a linkage can come'], ['Method', 'The method'], ['Reference', 'Reference']]) {
    const opened = page.waitForEvent('popup');
    await fromMenu(page, item);
    await (await opened).getByRole('heading', { name: heading, level: 1 }).waitFor();
  }
});

const lessons = JSON.parse(readFileSync(new URL('../../www/lessons/index.json', import.meta.url), 'utf8'));

for (const { id, title } of lessons) {
  test(`lesson “${title}” opens by its address, and everything in it works`, async () => {
    const { page, problems } = await browser.blankPage();
    await page.goto(`${browser.address}?lesson=${id}`);
    const panel = page.getByRole('tabpanel', { name: 'Lesson' });
    await panel.getByRole('heading', { name: title }).waitFor();
    const buttons = panel.locator('article button');
    const count = await buttons.count();
    assert.ok(count >= 3);
    for (let i = 0; i < count; i++) {
      await page.getByRole('tab', { name: 'Lesson' }).click();
      await buttons.nth(i).click();
      await page.waitForFunction(() => [...page$$('.lesson .live output')].some((output) => output.textContent !== ''));
      assert.equal(await page.locator('#notices').textContent(), '', `button ${i + 1} acts`);
      await page.locator('#fault-note').waitFor({ state: 'detached' });
    }
    await page.getByRole('tab', { name: 'Lesson' }).click();
    assert.ok((await panel.locator('details').count()) >= 2, 'has questions');
    await panel.getByRole('button', { name: 'Close the lesson' }).click();
    await page.getByRole('tab', { name: 'Lesson' }).waitFor({ state: 'hidden' });
    assert.deepEqual(problems, []);
  });
}

test('a lesson shows no number of the linkage that was open before', async () => {
  const { page, problems } = await browser.openPage();
  await page.evaluate(() => {
    window.counts = new Set();
    const look = () => {
      for (const output of page$$('.lesson [data-value=count]')) window.counts.add(output.textContent);
    };
    new MutationObserver(look).observe(document.querySelector('#linkage').shadowRoot, { subtree: true, childList: true, characterData: true });
  });
  await fromMenu(page, /How many freedoms/);
  await page.waitForFunction(() => window.counts.has('−2'));
  // The 3RPS has 3, and the lesson says of its four-bar that counting gives −2.
  assert.deepEqual(await page.evaluate(() => [...window.counts]), ['…', '−2']);
  await page.evaluate(() => document.querySelector('#linkage').parts.store.edit((doc) => ({ ...doc, chains: [] })));
  await page.waitForFunction(() => page$('.lesson [data-value=count]').textContent === '…', null, { polling: 50 });
  assert.deepEqual(problems, []);
});

test('a printed lesson is whole: the words of its buttons, the linkage, the answers, the link', async () => {
  const { page } = await browser.blankPage({ colorScheme: 'dark' });
  await page.goto(`${browser.address}?lesson=why`);
  await page.waitForFunction(() => /closest|reached/.test(page$('.lesson [data-value=status]')?.textContent));
  // While the print is made: what is seen of the lesson then, and whether there is a linkage in its picture.
  await page.emulateMedia({ media: 'print', colorScheme: 'dark' });
  await page.evaluate(() =>
    addEventListener('beforeprint', () => {
      const seen = (node) => node.checkVisibility({ visibilityProperty: true }) && node.offsetHeight > 0;
      const canvas = page$('#lesson canvas');
      const pixels = canvas && new Uint32Array(canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data.buffer);
      window.printed = {
        text: page$('#lesson').innerText,
        buttons: page$$('.lesson button').map((button) => [button.textContent, seen(button)]),
        tools: page$$('.lesson-tools button, .bar, #canvas, #tabs').filter(seen).length,
        answers: page$$('.lesson details p').map(seen),
        colours: canvas && seen(canvas) ? new Set(pixels).size : 0,
        ink: getComputedStyle(page$('.lesson p')).color,
      };
    }),
  );
  const pdf = (await page.pdf({ format: 'A4' })).toString('latin1');
  const printed = await page.evaluate(() => window.printed);
  assert.ok(printed.buttons.length >= 3 && printed.buttons.every(([words, seen]) => words && seen), JSON.stringify(printed.buttons));
  assert.ok(printed.answers.length >= 2 && printed.answers.every(Boolean), 'the answers');
  assert.equal(printed.tools, 0, 'nothing to click');
  assert.ok(printed.colours > 200, `${printed.colours} colours in the picture`);
  assert.equal(printed.ink, 'rgb(0, 0, 0)', 'dark on white paper');
  assert.match(printed.text, /Why the 3RPS cannot follow[^]*3 chains \(RPS, RPS, RPS\)[^]*Remove chain 3[^]*\?lesson=why/);
  assert.match(pdf, /\/Subtype \/Image/);
  assert.match(pdf, /\/URI \(http[^)]*\?lesson=why\)/);
  await page.emulateMedia({ media: 'screen' });
  assert.equal(await page.locator('.lesson details[open]').count(), 0, 'on the screen all is as it was');
  assert.equal(await page.locator('.print-only canvas').count(), 0);
});

/** Waits until an output of the lesson reads so. */
const reads = (page, value, wanted) =>
  page.waitForFunction(([name, pattern]) => new RegExp(pattern).test(page$(`.lesson [data-value=${name}]`)?.textContent), [value, wanted]);

test('the lessons’ claims hold: counts, ranks, gaps', async () => {
  const { page } = await browser.blankPage();
  const button = (name) => page.locator('.lesson').getByRole('button', { name, exact: true });
  await page.goto(`${browser.address}?lesson=mobility`);
  await reads(page, 'count', '^−2$');
  await reads(page, 'rank', '^1$');
  await reads(page, 'name', '^Four-bar$');
  await button('Open the 3RPS').click();
  await reads(page, 'name', '^3RPS$');
  await reads(page, 'count', '^3$');
  await reads(page, 'rank', '^3$');
  await button('α = 1°').click();
  await reads(page, 'count', '^3$');
  await button('Open the four-bar').click();
  await reads(page, 'rank', '^1$');
  await button('α = 1°').click();
  await reads(page, 'warnings', 'cannot be closed');
  await button('Open the 3CRR').click();
  await reads(page, 'count', '^0$');
  await reads(page, 'rank', '^3$');

  const worst = async () => {
    const [shift, turn] = (await page.locator('.lesson [data-value=worst]').first().textContent()).split(' and ').map(parseFloat);
    return { shift, turn };
  };
  const after = async (name) => {
    const old = await page.locator('.lesson [data-value=worst]').first().textContent();
    await button(name).first().click();
    // While it is planned there are dots.
    await page.waitForFunction((was) => page$('.lesson [data-value=worst]').textContent.includes(' and ') && page$('.lesson [data-value=worst]').textContent !== was, old);
    return worst();
  };
  await page.goto(`${browser.address}?lesson=metric`);
  await reads(page, 'worst', 'and');
  const paper = await worst();
  const dear = await after('L = 0.3 m');
  assert.ok(dear.shift < paper.shift && dear.turn > paper.turn, 'a small L makes shifts dear');
  const cheap = await after('L = 10 m');
  assert.ok(cheap.shift > paper.shift && cheap.turn < paper.turn, 'a large L makes them cheap');
  assert.deepEqual(await after('L = 1 m'), paper);
  const aside = await after('From (3, 0, 0)');
  assert.ok(aside.shift !== paper.shift || aside.turn !== paper.turn, 'the point of measurement changes the motion');
  await after('Metric: pose');
  assert.deepEqual(await after('Metric: dual quaternion'), aside);
  assert.deepEqual(await after('From the origin'), paper);
  const millimetres = await after('1 m → 1000 mm');
  assert.ok(millimetres.shift / 1000 < 0.9 * paper.shift, 'the unit changes the motion');
  const again = await after('L = 1000 mm');
  assert.ok(Math.abs(again.shift / 1000 - paper.shift) < 1e-4 && again.turn === paper.turn, 'and the metric length mends it');

  await page.goto(`${browser.address}?lesson=why`);
  await reads(page, 'worst', 'and');
  const three = await worst();
  // The info panel says the same.
  const largest = (await page.locator('.lesson [data-value=worst]').first().textContent()).split(' and ');
  for (const gap of largest) assert.ok((await text(page, 'motion-summary')).includes(`${gap}, frame`), gap);
  await button('Go to the largest shift').click();
  await reads(page, 'shift', `^${largest[0]}$`);
  const two = await after('Remove chain 3');
  await reads(page, 'rank', '^4$');
  assert.ok(two.shift + two.turn / 57 < three.shift + three.turn / 57, 'a freedom more, a smaller gap');
});

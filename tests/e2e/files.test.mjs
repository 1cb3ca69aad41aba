// Documents: examples, new, open, save, and the work that the browser keeps.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { cell, keeps, motionIsOfDocument, nameIs, notice, number, openBrowser, openSample, ready, text } from './browser.mjs';

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

const A = 'chains[0].joints[1].rows[0].a';
const fourBar = readFileSync(new URL('../../www/mechanisms/four-bar.json', import.meta.url), 'utf8');

/** A page in a browser without file pickers: it uploads and downloads. */
async function pageWithoutPickers(options) {
  const { page, problems } = await browser.blankPage(options);
  await page.addInitScript(() => {
    delete window.showOpenFilePicker;
    delete window.showSaveFilePicker;
  });
  // From now on file choosers are the test's; asked for only with the key press, they would be too late.
  page.on('filechooser', () => {});
  await page.goto(browser.address);
  await ready(page);
  return { page, problems };
}

/** Chooses a file in answer to an action. */
async function choose(page, act, file) {
  const [chooser] = await Promise.all([page.waitForEvent('filechooser'), act()]);
  await chooser.setFiles(file);
}

const json = (name, content) => ({ name, mimeType: 'application/json', buffer: Buffer.from(content) });

async function edit(page, value = '0.25', path = A) {
  await cell(page, path).fill(value);
  await page.keyboard.press('Enter');
  await page.locator('#unsaved').waitFor({ state: 'visible' });
}

test('new, edit, save, open: the same document comes back', async () => {
  const { page, problems } = await pageWithoutPickers({ viewport: { width: 1280, height: 700 }, acceptDownloads: true });
  // Without a network the form says that it could not ask, and asks again.
  await page.route(/\.wasm$/, (route) => route.abort());
  await page.getByRole('button', { name: 'New', exact: true }).click();
  const dialog = page.getByRole('dialog', { name: 'New linkage' });
  await dialog.getByRole('tabpanel', { name: 'A mechanism by name' }).getByRole('alert').filter({ hasText: /planner could not be loaded/ }).waitFor();
  await dialog.getByRole('tab', { name: 'A type and sizes' }).click();
  await dialog.getByRole('status').filter({ hasText: /The linkage was not made\./ }).waitFor();
  await page.unroute(/\.wasm$/);
  await dialog.getByRole('textbox', { name: 'Type' }).fill('TS');
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => page$$('.chain').length === 1);
  await motionIsOfDocument(page);
  await cell(page, 'name').fill('My arm');
  await page.keyboard.press('Tab');
  assert.ok(await page.locator('#unsaved').isVisible());
  assert.match(await page.title(), /^● My arm/);
  const [download] = await Promise.all([page.waitForEvent('download'), page.keyboard.press('Control+s')]);
  assert.equal(download.suggestedFilename(), 'my-arm.json');
  await page.locator('#unsaved').waitFor({ state: 'hidden' });
  const saved = readFileSync(await download.path(), 'utf8');
  assert.equal(JSON.parse(saved).name, 'My arm');
  assert.ok(saved.split('\n').length > 10, 'laid out for a reader');

  await openSample(page, '2tpr.json');
  await choose(page, () => page.keyboard.press('Control+o'), json('arm.json', saved));
  await nameIs(page, 'My arm');
  assert.ok(await page.locator('#unsaved').isHidden());
  const [again] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: 'Save', exact: true }).click()]);
  assert.equal(readFileSync(await again.path(), 'utf8'), saved);
  assert.deepEqual(problems, []);
});

test('what is no document is refused in words, and the present one stays', async () => {
  const { page, problems } = await pageWithoutPickers();
  const open = () => page.keyboard.press('Control+o');
  await choose(page, open, json('a.json', '{\n  "version": 1,\n  oops\n}'));
  await notice(page, /“a\.json” was not opened.*[Ll]ine 3, column 3/).waitFor();
  await choose(page, open, json('b.json', fourBar.replace('"alpha"', '"alfa"')));
  await notice(page, /“b\.json”.*alfa.*Accepted/).waitFor();
  await choose(page, open, { name: 'c.png', mimeType: 'image/png', buffer: Buffer.from([0x89, 0x50, 0, 0xff]) });
  await notice(page, /“c\.png”.*not a text/).waitFor();
  await choose(page, open, json('d.json', ' '.repeat(32_100_000)));
  await notice(page, /“d\.json”.*32\.1 MB.*at most 32 MB/).waitFor();
  await nameIs(page, '3RPS');
  assert.ok(await page.locator('#undo').isDisabled());
  await page.getByRole('button', { name: 'Close this notice' }).first().click();
  assert.deepEqual(problems, []);
});

test('with file access, saving again writes to the same file', async () => {
  const { page, problems } = await browser.blankPage();
  await page.addInitScript((document) => {
    window.written = [];
    const handle = {
      name: 'mine.json',
      getFile: async () => new File([document], 'mine.json'),
      createWritable: async () => ({ write: async (text) => void window.written.push(text), close: async () => {} }),
    };
    window.showOpenFilePicker = async () => [handle];
    window.showSaveFilePicker = async () => {
      throw new Error('not asked for');
    };
  }, fourBar);
  await page.goto(browser.address);
  await ready(page);
  await page.keyboard.press('Control+o');
  await nameIs(page, JSON.parse(fourBar).name);
  await page.locator('#about-button').click();
  await page.locator('#about-name').fill('Renamed');
  await page.keyboard.press('Control+s');
  await notice(page, 'Saved as mine.json').waitFor();
  assert.equal(await page.evaluate(() => JSON.parse(window.written[0]).name), 'Renamed');
  assert.deepEqual(problems, []);
});

test('a document dropped onto the page is opened, and the drop is hinted at', async () => {
  const { page, problems } = await browser.openPage();
  const transfer = await page.evaluateHandle((content) => {
    const data = new DataTransfer();
    data.items.add(new File([content], 'dropped.json', { type: 'application/json' }));
    return data;
  }, fourBar);
  await page.dispatchEvent('body', 'dragover', { dataTransfer: transfer });
  await page.locator('#drop-hint').waitFor({ state: 'visible' });
  await page.dispatchEvent('body', 'drop', { dataTransfer: transfer });
  await nameIs(page, JSON.parse(fourBar).name);
  await page.locator('#drop-hint').waitFor({ state: 'hidden' });
  assert.deepEqual(problems, []);
});

test('the text of a document is opened where it is pasted onto the page, and left alone in a field', async () => {
  const { page } = await browser.openPage();
  const paste = (selector) =>
    page.locator(selector).evaluate((target, content) => {
      const clipboardData = new DataTransfer();
      clipboardData.setData('text/plain', content);
      target.dispatchEvent(new ClipboardEvent('paste', { clipboardData, bubbles: true }));
    }, fourBar);
  await paste(`[data-path="${A}"]`);
  await paste('body');
  await nameIs(page, JSON.parse(fourBar).name);
  await page.locator('#undo').click();
  assert.ok(await page.locator('#undo').isDisabled(), 'opened once');
});

test('examples open from the keyboard; opening is undone with all steps before it', async () => {
  const { page, problems } = await browser.openPage();
  await edit(page);
  await page.getByRole('button', { name: 'Examples' }).press('Enter');
  await page.locator('.card').first().waitFor();
  const focused = () => page.evaluate(() => pageFocus().dataset.sample);
  assert.equal(await focused(), '3rps.json');
  await page.keyboard.press('ArrowRight');
  assert.equal(await focused(), '2tpr.json');
  for (const picture of await page.locator('.card img').all()) {
    await picture.scrollIntoViewIfNeeded();
    await picture.evaluate((image) => image.decode());
  }
  await page.locator('[data-sample="2tpr.json"]').press('Enter');
  await nameIs(page, '2TPR');
  await page.locator('dialog').waitFor({ state: 'detached' });
  await notice(page, /3RPS, which has changes/).getByRole('button', { name: 'Undo' }).click();
  await nameIs(page, '3RPS');
  assert.equal(number(await cell(page, A).inputValue()), 0.25);
  await page.locator('#undo').click();
  assert.equal(await cell(page, A).inputValue(), '0');
  assert.ok(await page.locator('#unsaved').isHidden());
  await page.keyboard.press('Control+Shift+z');
  await page.keyboard.press('Control+Shift+z');
  await nameIs(page, '2TPR');
  assert.deepEqual(problems, []);
});

test('name and description are read in full and edited below the header, and undone', async () => {
  const { page } = await browser.openPage();
  await page.locator('#about-button').click();
  const about = page.getByLabel('About', { exact: true });
  assert.match(await about.inputValue(), /the one between cannot\.$/);
  await about.fill('Mine now');
  await page.getByLabel('Name', { exact: true }).last().fill('Other');
  await nameIs(page, 'Other');
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  await nameIs(page, '3RPS');
  assert.match(await about.inputValue(), /cannot\.$/);
  await page.keyboard.press('Escape');
  await about.waitFor({ state: 'hidden' });
});

test('the work survives a reload, with its undo steps', async () => {
  const { page, problems } = await browser.openPage();
  await openSample(page, '2tpr.json');
  await edit(page, 'Kept', 'name');
  await keeps(page, 'Kept');
  await page.reload();
  await ready(page);
  await nameIs(page, 'Kept');
  assert.ok(await page.locator('#unsaved').isVisible());
  await page.locator('#undo').click();
  await nameIs(page, '2TPR');
  await page.locator('#undo').click();
  await nameIs(page, '3RPS');
  assert.deepEqual(problems, []);
});

test('a document at fault survives too, over its last good motion', async () => {
  const { page } = await browser.openPage();
  await edit(page, 'abc');
  await page.locator('#fault-note').waitFor();
  await keeps(page, 'abc');
  await page.reload();
  await ready(page);
  await page.locator('#fault-note').waitFor();
  assert.equal(await cell(page, A).inputValue(), 'abc');
  assert.match(await text(page, 'fault-banner'), /last good motion/);
});

for (const [what, breakIt] of [
  ['full', () => {
    Storage.prototype.setItem = () => {
      throw new DOMException('full', 'QuotaExceededError');
    };
  }],
  ['forbidden', () => {
    Object.defineProperty(window, 'localStorage', {
      get() {
        throw new DOMException('forbidden', 'SecurityError');
      },
    });
  }],
]) {
  test(`with a ${what} storage the page works, says so once, and asks before it is left`, async () => {
    const { page, problems } = await browser.blankPage();
    await page.addInitScript(breakIt);
    await page.goto(browser.address);
    await ready(page);
    await edit(page);
    const told = notice(page, 'cannot be kept in this browser');
    await told.waitFor();
    await told.getByRole('button', { name: 'Close this notice' }).click();
    await edit(page, '0.5');
    await page.locator('#theme').click();
    const asked = page.waitForEvent('dialog');
    await page.close({ runBeforeUnload: true });
    const dialog = await asked;
    assert.equal(dialog.type(), 'beforeunload');
    await dialog.dismiss();
    assert.equal(await told.count(), 0, 'said once');
    assert.deepEqual(problems, []);
  });
}

test('with a whole storage the page is left without a question', async () => {
  const { page } = await browser.openPage();
  await edit(page);
  page.on('dialog', () => assert.fail('asked'));
  await Promise.all([page.waitForEvent('close'), page.close({ runBeforeUnload: true })]);
});

async function openEarlierDocuments(page) {
  await page.getByRole('button', { name: 'File', exact: true }).click();
  await page.getByRole('menuitem', { name: 'Earlier documents' }).click();
}

test('kept work that cannot be read is put aside and can be had, at once and later', async () => {
  const { page, problems } = await browser.openPage();
  const broken = '{"chains"';
  await page.evaluate((kept) => localStorage.setItem('synthetica.work.1', kept), broken);
  await page.reload();
  await ready(page);
  await nameIs(page, '3RPS');
  const [download] = await Promise.all([page.waitForEvent('download'), notice(page, 'cannot be read').getByRole('button', { name: 'Download it' }).click()]);
  assert.equal(readFileSync(await download.path(), 'utf8'), broken);
  await page.reload();
  await ready(page);
  assert.equal(await page.locator('#notices p').count(), 0);
  await openEarlierDocuments(page);
  const [again] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: /cannot be read: download it/ }).click()]);
  assert.equal(readFileSync(await again.path(), 'utf8'), broken);
  assert.deepEqual(problems, []);
});

test('kept work with a fault and no motion is put aside, and opened with its fault', async () => {
  const { page, problems } = await browser.openPage();
  const faulty = fourBar.replace('"alpha"', '"alfa"');
  await page.evaluate((kept) => localStorage.setItem('synthetica.work.1', kept), `x 1\n{"document": ${faulty}, "past": [], "future": []}`);
  await page.reload();
  await ready(page);
  await nameIs(page, '3RPS');
  await notice(page, 'has a fault').getByRole('button', { name: 'Close this notice' }).click();
  await openEarlierDocuments(page);
  await page.getByRole('button', { name: new RegExp(`^${JSON.parse(fourBar).name}`) }).click();
  await nameIs(page, JSON.parse(fourBar).name);
  await page.locator('#fault-banner').filter({ hasText: 'alfa' }).waitFor();
  assert.deepEqual(problems, []);
});

test('two tabs: each says that there is another, and neither work is lost', async () => {
  const { page } = await browser.openPage();
  await edit(page, 'First', 'name');
  await keeps(page, 'First');
  const second = await page.context().newPage();
  await second.goto(browser.address);
  await ready(second);
  await nameIs(second, 'First');
  await edit(page, 'First again', 'name');
  await keeps(page, 'First again');
  await notice(second, 'in another tab').waitFor();
  await edit(second, 'Second', 'name');
  await keeps(second, 'Second');
  await second.getByRole('button', { name: 'File', exact: true }).click();
  await second.getByRole('menuitem', { name: 'Earlier documents' }).click();
  await second.getByRole('button', { name: /^First again/ }).click();
  await nameIs(second, 'First again');
});

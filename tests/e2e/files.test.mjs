// Documents: examples, new, open, save, kept work, links, and the header around them.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { cell, motionIsOfDocument, number, openBrowser, openSample, scrubTo, text } from './browser.mjs';

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

const A = 'chains[0].joints[1].rows[0].a';
const fourBar = readFileSync(new URL('../../www/mechanisms/four-bar.json', import.meta.url), 'utf8');

const ready = (page) => page.waitForFunction(() => (page$('#closure')?.textContent ?? '–') !== '–');
const nameIs = (page, name) => page.locator('#document-name').filter({ hasText: new RegExp(`^${name}$`) }).waitFor();
const notice = (page, words) => page.locator('#notices p').filter({ hasText: words });

/** How light the picture of the linkage is, from 0 to 1. */
const lightness = async (page) =>
  page.evaluate(async (bytes) => {
    const bitmap = await createImageBitmap(new Blob([new Uint8Array(bytes)]));
    const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
    context.drawImage(bitmap, 0, 0);
    const { data } = context.getImageData(0, 0, bitmap.width, bitmap.height);
    return data.reduce((sum, value, index) => (index % 4 === 3 ? sum : sum + value), 0) / (data.length * 0.75 * 255);
  }, [...(await page.locator('#canvas').screenshot())]);

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

/** The kept work holds that text. */
const keeps = (page, words) => page.waitForFunction((wanted) => localStorage.getItem('synthetica.work.1')?.includes(wanted), words);

test('new, edit, save, open: the same document comes back', async () => {
  const { page, problems } = await pageWithoutPickers({ viewport: { width: 1280, height: 700 }, acceptDownloads: true });
  // Without a network the form says that it could not ask, and asks again.
  await page.route(/\.wasm$/, (route) => route.abort());
  await page.getByRole('button', { name: 'New', exact: true }).click();
  const dialog = page.getByRole('dialog', { name: 'New linkage' });
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
  await choose(page, open, json('d.json', ' '.repeat(4_200_000)));
  await notice(page, /“d\.json”.*4\.2 MB.*at most 4 MB/).waitFor();
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
});

test('light, dark, as the system: chosen in the header, kept, followed by the view', async () => {
  const { page, problems } = await browser.openPage();
  await scrubTo(page, 60);
  const theme = page.locator('#theme');
  const state = () => page.evaluate(() => {
    const style = getComputedStyle(document.documentElement);
    return { scheme: style.colorScheme, page: style.backgroundColor };
  });
  const light = await state();
  assert.ok((await lightness(page)) > 0.65);
  await theme.click();
  assert.equal((await state()).scheme, 'light');
  await theme.click();
  const dark = await state();
  assert.equal(dark.scheme, 'dark');
  assert.notEqual(dark.page, light.page);
  assert.ok((await lightness(page)) < 0.35);
  assert.match(await theme.getAttribute('aria-label'), /dark.*system/);
  await page.reload();
  assert.equal((await state()).page, dark.page, 'before the scripts ran');
  await ready(page);
  await theme.click();
  assert.deepEqual(await state(), light);
  assert.deepEqual(problems, []);
});

test('on a phone the header is one row, and its menu holds the rest', async () => {
  const { page } = await browser.openPage({ viewport: { width: 390, height: 844 }, isMobile: true, hasTouch: true });
  const bar = await page.locator('.bar').boundingBox();
  assert.ok(bar.height < 60, `${bar.height} pixels high`);
  await openSample(page, '2tpr.json');
  await nameIs(page, '2TPR');
  await page.getByRole('button', { name: 'File', exact: true }).tap();
  for (const name of [/^New/, /^Open/, /^Save/, /^Share/, /^Colours/]) assert.ok(await page.getByRole('menuitem', { name }).first().isVisible(), String(name));
  await page.getByRole('menuitem', { name: /^Colours/ }).tap();
  assert.equal(await page.evaluate(() => document.documentElement.dataset.theme), 'light');
});

// The 3D view: what is pointed at is named, what is clicked is selected, and the keyboard and touch can do the same.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { convertLengths } from '../../www/core/units.js';
import { openBrowser, scrubTo, text } from './browser.mjs';

const sample = JSON.parse(readFileSync('www/mechanisms/3rps.json', 'utf8'));

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

const drawn = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));

/** Where a thing is on the screen: its name stands there once the keyboard points at it. */
async function placeOf(page, thing) {
  await page.locator('#canvas').focus();
  const name = page.locator(`#labels [data-place="${thing}"].pointed`);
  for (let i = 0; i < 60 && !(await name.count()); i++) await page.keyboard.press(']');
  await drawn(page);
  const [[x, y]] = await name.evaluateAll(standing);
  const { x: left, y: top } = await page.locator('#canvas').boundingBox();
  await page.keyboard.press('Escape');
  return [left + x, top + y];
}

/** Of name tags, where they stand in the view, in pixels from its left and its top. */
const standing = (tags) => tags.map((tag) => { const { e, f } = new DOMMatrix(getComputedStyle(tag).transform); return [e, f]; });

const chosen = (page, place) => page.locator(`#canvas[data-selected="${place}"]`).waitFor();

test('hover tells what a thing is, a click selects it, a click beside it ends that', async () => {
  const { page, problems } = await browser.openPage();
  await scrubTo(page, 60);
  const joint = 'chains[1].joints[2]';
  const at = await placeOf(page, joint);
  await page.mouse.move(...at);
  await page.locator('#tip').filter({ hasText: 'chain 2, joint 3: S, spherical' }).waitFor();
  const plain = await page.locator('#canvas').screenshot();
  await page.mouse.down();
  await page.mouse.up();
  await chosen(page, joint);
  await page.locator(`#labels .chosen[data-place="${joint}"]`).waitFor();
  await drawn(page);
  assert.notDeepEqual(await page.locator('#canvas').screenshot(), plain, 'it is outlined');
  const { x, y, height } = await page.locator('#canvas').boundingBox();
  await page.mouse.click(x + 10, y + height - 30);
  await chosen(page, '');
  assert.deepEqual(problems, []);
});

test('turning the view selects nothing', async () => {
  const { page } = await browser.openPage();
  // On the base: what can be moved by hand would move.
  const [x, y] = await placeOf(page, 'chains[0].base');
  const before = await page.locator('#canvas').screenshot();
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 60, y + 20, { steps: 4 });
  await page.mouse.up();
  await drawn(page);
  assert.notDeepEqual(await page.locator('#canvas').screenshot(), before);
  assert.equal((await page.locator('#canvas').getAttribute('data-selected')) || '', '');
});

test('the keyboard goes through the things, says them, and leaves the view with Tab', async () => {
  const { page } = await browser.openPage();
  await page.locator('#canvas').focus();
  await page.keyboard.press(']');
  await page.locator('#view-live').filter({ hasText: /^workpiece, 1 of \d+/ }).waitFor();
  await page.keyboard.press(']');
  await page.locator('#view-live').filter({ hasText: 'base of chain 1' }).waitFor();
  await page.keyboard.press('Enter');
  await chosen(page, 'chains[0].base');
  await page.keyboard.press('Escape');
  await chosen(page, '');
  await page.keyboard.press('Tab');
  assert.notEqual(await page.evaluate(() => pageFocus().id), 'canvas');
});

test('standard views, by key and by menu, each another picture; fitting the selection another still', async () => {
  const { page, problems } = await browser.openPage();
  await scrubTo(page, 60);
  const canvas = page.locator('#canvas');
  await canvas.focus();
  const pictures = new Set();
  for (const key of ['1', '2', '3', '4', '5', '6', '7']) {
    await page.keyboard.press(key);
    await drawn(page);
    pictures.add((await canvas.screenshot()).toString('base64'));
  }
  assert.equal(pictures.size, 7);
  await page.getByRole('button', { name: 'Views' }).click();
  await page.getByRole('menuitem', { name: 'Top' }).click();
  await page.locator('#view-live').filter({ hasText: 'Top view' }).waitFor();
  await canvas.focus();
  await page.keyboard.press(']');
  await page.keyboard.press('Enter');
  await drawn(page);
  const before = await canvas.screenshot();
  await page.keyboard.press('f');
  await drawn(page);
  assert.notDeepEqual(await canvas.screenshot(), before);
  assert.deepEqual(problems, []);
});

test('without reduced motion a standard view is reached too', async () => {
  const { page } = await browser.openPage({ reducedMotion: 'no-preference' });
  await page.getByRole('button', { name: 'Pause' }).click();
  const across = () => page.locator('#labels [data-place="chains[1].base"]').evaluate((tag) => tag.style.transform);
  await page.locator('#canvas').focus();
  await page.keyboard.press('p');
  const before = await across();
  await page.keyboard.press('1');
  await page.waitForFunction((old) => page$('#labels [data-place="chains[1].base"]').style.transform !== old, before);
  let last = '';
  while (last !== (last = await across())) await page.waitForTimeout(300);
  const heights = (await page.locator('#labels [data-place$=".base"]').evaluateAll(standing)).map(([, y]) => y);
  assert.ok(Math.max(...heights) - Math.min(...heights) < 0.5, `bases on one ground are level from the front: ${heights}`);
});

test('orthographic keeps parallel lines parallel, zooms, and goes back', async () => {
  const { page } = await browser.openPage();
  const canvas = page.locator('#canvas');
  await canvas.focus();
  await page.keyboard.press('1');
  await page.keyboard.press('p');
  await page.locator('#canvas[data-projection="orthographic"]').waitFor();
  await drawn(page);
  // From the front, three bases on the ground lie at one height, however far away.
  const places = () => page.locator('#labels [data-place$=".base"]').evaluateAll(standing);
  const flat = await places();
  for (const [, y] of flat) assert.ok(Math.abs(y - flat[0][1]) < 0.2, String(flat));
  await page.keyboard.press('+');
  await drawn(page);
  const near = await places();
  const spread = (all) => Math.max(...all.map(([x]) => x)) - Math.min(...all.map(([x]) => x));
  assert.ok(Math.abs(spread(near) / spread(flat) - 1 / 0.9) < 0.01, 'one step of zoom');
  await page.getByRole('button', { name: 'Orthographic' }).click();
  await page.locator('#canvas[data-projection="perspective"]').waitFor();
});

test('a tap selects', async () => {
  const { page } = await browser.openPage({ viewport: { width: 390, height: 844 }, isMobile: true, hasTouch: true });
  const at = await placeOf(page, 'chains[0].joints[1]');
  await page.touchscreen.tap(...at);
  await chosen(page, 'chains[0].joints[1]');
});

test('at rest nothing is drawn', async () => {
  const { page } = await browser.openPage();
  const draws = () => page.locator('#canvas').getAttribute('data-draws');
  let last = '';
  // Without a graphics card the shadows follow once the picture rests.
  while (last !== (last = await draws())) await page.waitForTimeout(700);
  await page.waitForTimeout(700);
  assert.equal(await draws(), last);
  await page.locator('#canvas').focus();
  await page.keyboard.press('ArrowLeft');
  await page.waitForFunction((old) => page$('#canvas').dataset.draws !== old, last);
});

test('ghosts, and leaving out parts, change the picture; the legend tells the sizes of gaps', async () => {
  const { page, problems } = await browser.openPage();
  await scrubTo(page, 60);
  const canvas = page.locator('#canvas');
  const choose = async (name) => {
    await page.getByRole('button', { name: 'Show' }).click();
    await page.getByRole('menuitemcheckbox', { name }).click();
  };
  await page.locator('#legend').getByText(/^gap ≥ [\d.]+ m$/).first().waitFor();
  await page.keyboard.press('Shift');
  await page.locator('#legend').getByText('force that holds it back').waitFor();
  const picture = async () => (await canvas.screenshot()).toString('base64');
  const pictures = new Set([await picture()]);
  for (const name of ['Ghosts at key frames', /Ghosts every \d+ frames/, 'Ghost at this frame', 'Goal motion', 'Closest motion', 'Gap lines', 'Axes', 'Ground', 'What holds it back']) {
    await choose(name);
    // On a slow machine the picture comes after the menu is closed.
    const until = Date.now() + 30_000;
    let now = await picture();
    while (pictures.has(now) && Date.now() < until) now = await picture();
    pictures.add(now);
  }
  assert.equal(pictures.size, 10, 'each choice is another picture');
  await page.locator('#legend li').waitFor({ state: 'detached' });
  await page.locator('#labels').getByText('between').waitFor();
  await choose('Names');
  await page.locator('#labels span').first().waitFor({ state: 'detached' });
  await page.getByRole('button', { name: 'Show' }).click();
  await page.getByRole('menuitemcheckbox', { name: 'Names', checked: false }).waitFor();
  assert.deepEqual(problems, []);
});

test('another colour scheme repaints the view at once', async () => {
  const { page } = await browser.openPage({ colorScheme: 'light' });
  const draws = await page.locator('#canvas').getAttribute('data-draws');
  await page.emulateMedia({ colorScheme: 'dark' });
  await page.waitForFunction((old) => page$('#canvas').dataset.draws !== old, draws);
});

test('what is pointed at elsewhere is named in the view, and the other way round', async () => {
  const { page } = await browser.openPage();
  const key = 'motion.key_frames[1]';
  const tick = page.locator(`.track [data-place="${key}"]`);
  await tick.hover();
  await page.locator(`#labels .pointed[data-place="${key}"]`).filter({ hasText: 'key frame “between”' }).waitFor();
  await page.mouse.move(0, 0);
  await page.locator('#labels .pointed').waitFor({ state: 'detached' });
  const at = await placeOf(page, key);
  await page.mouse.move(...at);
  await page.locator('#tip').filter({ hasText: 'key frame “between”' }).waitFor();
  await page.locator(`.track .marked[data-place="${key}"]`).waitFor();
});

/** Where a name's point is on the canvas, in pixels. */
const pointsOf = (page, places) =>
  page.locator(places).evaluateAll(standing);

test('in another unit of length the picture is the same, unless a pointer is down; Fit view shows all of a narrow view', async () => {
  const { page, problems } = await browser.openPage({ viewport: { width: 390, height: 844 } });
  const bases = '#labels [data-place$=".base"]';
  const { metric_length: length, ...planner } = sample.planner;
  const millimetres = { ...convertLengths(sample, 1000, 'mm'), planner: { ...planner, metric_length: 1000 * length } };
  const planned = () => page.waitForFunction(() => document.querySelector('synthetica-linkage').parts.store.result.doc === document.querySelector('synthetica-linkage').parts.store.doc);
  const before = await pointsOf(page, bases);
  await page.mouse.move(200, 20);
  await page.mouse.down();
  // An edit, and not another document.
  await page.evaluate((doc) => document.querySelector('synthetica-linkage').parts.store.edit(() => doc), millimetres);
  await planned();
  await drawn(page);
  assert.equal(await page.locator(`${bases}:not([hidden])`).count(), 0, 'the view does not move under a hand');
  await page.mouse.up();
  await drawn(page);
  assert.equal(await page.locator(`${bases}:not([hidden])`).count(), 3);
  const after = await pointsOf(page, bases);
  after.flat().forEach((value, i) => assert.ok(Math.abs(value - before.flat()[i]) < 1.5, `${value} px, before ${before.flat()[i]} px`));

  // Back in metres, at once: no pointer is down.
  await page.evaluate(() => document.querySelector('synthetica-linkage').parts.store.undo());
  await planned();
  await drawn(page);
  assert.equal(await page.locator(`${bases}:not([hidden])`).count(), 3);
  (await pointsOf(page, bases)).flat().forEach((value, i) => assert.ok(Math.abs(value - before.flat()[i]) < 1.5, `${value} px, before ${before.flat()[i]} px`));

  // A view as narrow as a phone in portrait: all names' points are in it.
  await page.locator('#canvas').focus();
  for (let i = 0; i < 6; i++) await page.keyboard.press('+');
  await page.evaluate(() => document.querySelector('synthetica-linkage').style.setProperty('--view-height', '600px'));
  await page.waitForFunction(() => page$('#canvas').clientHeight > 400);
  await page.locator('#fit').click();
  await drawn(page);
  assert.equal(await page.locator('#labels span:not([hidden])').count(), 6);
  for (const [x] of await pointsOf(page, '#labels span')) assert.ok(x > 5 && x < 385, `${x} px`);
  assert.deepEqual(problems, []);
});

test('while a joint is driven, the view has no word about a goal; Ctrl+Z gives the motion back; what is in hand says what its keys do', async () => {
  const { page, problems } = await browser.openPage();
  await scrubTo(page, 40);
  await page.locator('#legend').getByText('goal motion').waitFor();
  await page.getByRole('tab', { name: 'Teach' }).click();
  await page.locator('.teach-row input[type=range]').first().focus();
  await page.keyboard.press('ArrowRight');
  await page.locator('#by-hand').waitFor();
  await page.locator('#canvas').focus();
  await page.keyboard.press(']');
  await page.keyboard.press('Enter');
  await page.locator('.readout').filter({ hasText: 'driven' }).waitFor();
  const words = async () => `${await page.locator('.view').textContent()} ${await page.locator('#canvas-text').textContent()}`;
  assert.doesNotMatch(await words(), /goal|from the hand/);
  assert.match(await words(), /closest motion/);

  const said = page.locator('.drag-bar [role=status]');
  await page.keyboard.press('r');
  await said.filter({ hasText: 'Turn: about the axes of the world.' }).waitFor();
  await page.keyboard.press('d');
  await said.filter({ hasText: /^Freedoms: / }).waitFor();
  await page.keyboard.press('g');
  await said.filter({ hasText: 'Move: along the axes of the world.' }).waitFor();
  await page.keyboard.press('Control+z');
  await page.locator('#by-hand').waitFor({ state: 'hidden' });
  await page.locator('#legend').getByText('goal motion').waitFor();
  assert.equal(await said.textContent(), '', 'what was said is no longer so');
  assert.equal(await text(page, 'frame-number'), '41 / 129');

  // The move bar hides nothing of the picture, and no names stand under the letters of the gizmo.
  const [canvas, bar] = [await page.locator('#canvas').boundingBox(), await page.locator('.drag-bar').boundingBox()];
  assert.ok(bar.y >= canvas.y + canvas.height, 'it stands below');
  const boxes = await page.locator(':is(#labels, .hand-labels) span:not([hidden])').evaluateAll((tags) => tags.map((tag) => tag.getBoundingClientRect().toJSON()));
  assert.ok(boxes.length > 5);
  boxes.forEach((a, i) =>
    boxes.slice(i + 1).forEach((b) => assert.ok(a.right <= b.left + 1 || b.right <= a.left + 1 || a.bottom <= b.top + 1 || b.bottom <= a.top + 1, 'no name covers another')),
  );
  assert.deepEqual(problems, []);
});

test('a motion is as wide on the screen after zooming in, and in proportion in a sharper picture', async () => {
  const { page, problems } = await browser.openPage();
  // From the front the closest motion goes upwards: the middle of its widths, row by row.
  const width = (png) =>
    page.evaluate(async (content) => {
      const image = new Image();
      if (content) {
        image.src = content;
        await image.decode();
      } else document.querySelector('synthetica-linkage').parts.player.draw();
      const source = content ? image : page$('.drawn');
      const pen = new OffscreenCanvas(source.width, source.height).getContext('2d');
      pen.drawImage(source, 0, 0);
      const { data } = pen.getImageData(0, 0, source.width, source.height);
      const widths = [];
      for (let y = 0; y < source.height; y++) {
        let count = 0;
        for (let x = 0; x < source.width; x++) if ([0x35, 0xa3, 0xc9].every((value, i) => Math.abs(data[4 * (y * source.width + x) + i] - value) < 6)) count++;
        if (count) widths.push(count);
      }
      return [widths.sort((a, b) => a - b)[widths.length >> 1], widths.length];
    }, png);
  await page.locator('#canvas').press('1');
  await drawn(page);
  const [before, rows] = await width();
  // 1.5 times as long, of which bodies in front of it cover a part.
  for (let i = 0; i < 4; i++) await page.locator('#canvas').press('+');
  await drawn(page);
  const [after, more] = await width();
  assert.ok(rows > 20 && more > 1.3 * rows, `zoomed in: ${rows} rows, then ${more}`);
  assert.ok(before >= 2 && before <= 4 && Math.abs(after - before) <= 1, `${before} pixels wide, then ${after}`);
  const [twice] = await width(
    await page.evaluate(async () => {
      const { width, height } = page$('#canvas').getBoundingClientRect();
      const blob = await document.querySelector('synthetica-linkage').toImage({ width, height, scale: 4 });
      return new Promise((done) => Object.assign(new FileReader(), { onload: ({ target }) => done(target.result) }).readAsDataURL(blob));
    }),
  );
  assert.ok(twice >= 4 * before - 3 && twice <= 4 * before + 4, `${before} pixels on the screen, ${twice} in a picture four times as sharp`);
  assert.deepEqual(problems, []);
});

test('forced colours leave the lines of the scene and of the legend apart', async () => {
  const { page } = await browser.openPage({ forcedColors: 'active' });
  const lines = await page.locator('#legend li').evaluateAll((items) => items.map((item) => getComputedStyle(item, '::before').backgroundColor).slice(0, 3));
  assert.equal(new Set(lines).size, 3, String(lines));
  const colours = await page.locator('#canvas').evaluate((canvas) => {
    const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d');
    document.querySelector('synthetica-linkage').parts.player.draw();
    copy.drawImage(page$('.drawn'), 0, 0);
    const { data } = copy.getImageData(0, 0, canvas.width, canvas.height);
    let coloured = 0;
    for (let at = 0; at < data.length; at += 4) if (Math.max(...data.slice(at, at + 3)) - Math.min(...data.slice(at, at + 3)) > 60) coloured++;
    return coloured;
  });
  assert.ok(colours > 100, `${colours} pixels with a colour`);
});

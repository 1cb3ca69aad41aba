// What the element takes of pointer, wheel, fingers and keys in somebody else's page.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { openBrowser } from './browser.mjs';
import { LINKAGE, openGuestPage, planned } from './guest-page.mjs';

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

const guestPage = (body, options) => openGuestPage(browser, body, options);

/** How the first linkage is looked at: from where, and how far away. */
const look = (page) =>
  page.evaluate(async () => {
    const { scene } = await document.querySelector('synthetica-linkage').workbench;
    const { position } = scene.camera;
    return { distance: position.distanceTo(scene.size.centre), angle: Math.atan2(scene.camera.matrixWorld.elements[8], -scene.camera.matrixWorld.elements[9]), at: position.toArray().join() };
  });
const nearer = (page, than) =>
  page.waitForFunction(async (old) => {
    const { scene } = await document.querySelector('synthetica-linkage').workbench;
    return scene.camera.position.distanceTo(scene.size.centre) < old;
  }, than);
const scrolled = (page) => page.evaluate(() => scrollY);
const scrolls = (page, past = 0) => page.waitForFunction((before) => scrollY > before, past);
const middle = async (page) => {
  const { x, y, width, height } = await page.locator('.scene').first().boundingBox();
  return [x + width / 2, y + height / 2];
};
/** A page long enough to be scrolled past the linkage. */
const LONG = (interaction) => `<div style="height: 100px"></div>${LINKAGE.replace(' src', ` ${interaction} src`)}<div style="height: 3000px"></div>`;

test('a plain wheel scrolls the page and says how to zoom; Ctrl or Meta and the wheel zoom', async () => {
  const { page, problems } = await guestPage(LONG(''));
  await planned(page);
  await page.evaluate(() => {
    window.wheels = 0;
    addEventListener('wheel', () => window.wheels++);
  });
  const [x, y] = await middle(page);
  const before = await look(page);
  await page.mouse.move(x, y);
  await page.mouse.wheel(0, 60);
  await scrolls(page);
  assert.deepEqual(await look(page), before, 'the view is as it was');
  assert.equal(await page.evaluate(() => window.wheels), 1, 'the page’s own scripts hear the wheel');
  const note = page.locator('.take-note');
  assert.match(await note.textContent(), /^(Ctrl|⌘) and wheel zooms$/);
  assert.equal(await note.getAttribute('aria-hidden'), 'true');
  const layers = await page.evaluate(() => ['.take-note', '#tip', '#labels'].map((one) => Number(getComputedStyle(page$(one)).zIndex) || 0));
  assert.ok(layers[0] > layers[2] && layers[1] > layers[2], 'what is said lies over the names in the view');
  assert.equal(await note.evaluate((one) => getComputedStyle(one).transitionDuration), '0s', 'with less motion it does not fade');
  await page.waitForFunction(() => getComputedStyle(page$('.take-note')).visibility === 'hidden');
  for (const key of ['Control', 'Meta']) {
    const [at, far] = [await scrolled(page), (await look(page)).distance];
    await page.keyboard.down(key);
    await page.mouse.wheel(0, -60);
    await nearer(page, far);
    await page.keyboard.up(key);
    assert.equal(await scrolled(page), at, `${key}: the page does not scroll`);
  }
  await page.mouse.down();
  await page.mouse.move(x + 60, y + 5);
  await page.mouse.up();
  assert.notEqual((await look(page)).angle, before.angle, 'the mouse turns it');
  assert.deepEqual(problems, []);
});

test('interaction full takes the wheel, none takes nothing but by its controls', async () => {
  const { page } = await guestPage(LONG('interaction="full"'));
  await planned(page);
  const [x, y] = await middle(page);
  const { distance } = await look(page);
  await page.mouse.move(x, y);
  await page.mouse.wheel(0, -60);
  await nearer(page, distance);
  assert.equal(await scrolled(page), 0);

  await page.evaluate(() => document.querySelector('synthetica-linkage').setAttribute('interaction', 'none'));
  await page.waitForFunction(() => page$('.bench').dataset.interaction === 'none' && page$('#frame-number').textContent !== '–');
  await page.evaluate(() => {
    window.heard = [];
    for (const type of ['click', 'pointerdown', 'wheel']) document.addEventListener(type, (event) => window.heard.push([type, event.defaultPrevented]));
  });
  const before = await look(page);
  await page.mouse.wheel(0, 60);
  await scrolls(page);
  await page.evaluate(() => scrollTo(0, 0));
  await page.mouse.down();
  await page.mouse.move(x + 60, y + 5);
  await page.mouse.up();
  await page.mouse.click(x, y);
  assert.deepEqual(await look(page), before);
  const heard = await page.evaluate(() => window.heard);
  assert.deepEqual([...new Set(heard.map(([type]) => type))].sort(), ['click', 'pointerdown', 'wheel']);
  assert.ok(heard.every(([, prevented]) => !prevented), 'the page can do with them what it likes');
  assert.equal(await page.evaluate(() => pageFocus().localName), 'body', 'nothing has the focus');
  await page.keyboard.press('Tab');
  assert.ok(await page.evaluate(() => pageFocus().id !== 'canvas' && pageFocus().closest('.bench') !== null), 'the controls can be reached, the view is passed over');
  await page.locator('#step-forward').click();
  assert.equal(await page.evaluate(() => document.querySelector('synthetica-linkage').frame), 1);
  await page.getByRole('button', { name: 'Views' }).click();
  await page.getByRole('menuitem', { name: 'Top' }).click();
  assert.equal(await page.getAttribute('synthetica-linkage', 'view'), 'top');
});

test('an unknown word for interaction is told, and means as much as none', async () => {
  const { page } = await guestPage(LINKAGE.replace(' src', ' interaction="all" src'));
  await planned(page);
  assert.match(await page.evaluate(() => document.querySelector('synthetica-linkage').error.message), /interaction is “all”. Accepted: none, ctrl, full/);
  assert.equal(await page.locator('.bench').getAttribute('data-interaction'), 'ctrl');
});

test('one finger scrolls the page past the view, two turn and zoom it', async () => {
  const { page } = await guestPage(LONG(''), { viewport: { width: 390, height: 700 }, hasTouch: true, isMobile: true });
  await planned(page);
  const client = await page.context().newCDPSession(page);
  const [x, y] = (await middle(page)).map(Math.round);
  const touch = (type, ...points) => client.send('Input.dispatchTouchEvent', { type, touchPoints: points.map(([px, py], id) => ({ x: px, y: py, id })) });
  const drag = async (...paths) => {
    await touch('touchStart', paths[0][0]);
    if (paths[1]) await touch('touchStart', paths[0][0], paths[1][0]);
    for (let step = 1; step <= 10; step++) await touch('touchMove', ...paths.map(([from, to]) => from.map((value, axis) => value + ((to[axis] - value) * step) / 10)));
    await touch('touchEnd');
  };
  const before = await look(page);
  // Once more when what can be moved by hand has come: the finger passes over the workpiece.
  for (let time = 0; time < 2; time++) {
    await page.evaluate(() => {
      scrollTo(0, 0);
      window.rests = false;
      addEventListener('scrollend', () => (window.rests = scrollY > 50));
    });
    await page.waitForFunction(() => scrollY === 0);
    await drag([[x, y], [x, y - 120]]);
    await page.waitForFunction(() => window.rests);
    await page.waitForFunction(() => page$('.hand-labels'));
  }
  assert.deepEqual(await look(page), before, 'one finger does not turn it');
  assert.match(await page.locator('.take-note').textContent(), /Two fingers/);
  await page.evaluate(() => scrollTo(0, 0));
  await page.waitForFunction(() => scrollY === 0);
  await drag([[x - 30, y], [x - 90, y - 40]], [[x + 30, y], [x + 90, y - 40]]);
  const after = await look(page);
  assert.ok(after.distance < before.distance * 0.9, 'two fingers apart: nearer');
  assert.notEqual(after.at, before.at);
  assert.equal(await scrolled(page), 0, 'and the page stays');
  assert.equal(await page.evaluate(() => visualViewport.scale), 1);
  await drag([[x - 30, y], [x + 30, y]], [[x + 30, y], [x + 90, y]]);
  assert.ok(Math.abs((await look(page)).angle - after.angle) > 0.1, 'two fingers turn it');
  await page.touchscreen.tap(x, y);
  // A tap still selects what is there, and nothing where nothing is.
  await page.waitForFunction(() => /Selected|Nothing/.test(page$('#view-live').textContent));
});

test('a frame takes what its address says', async () => {
  const { page } = await browser.blankPage();
  for (const [query, wanted] of [['', 'ctrl'], ['?interaction=full', 'full'], ['?interaction=none', 'none']]) {
    await page.goto(`${browser.address}embed.html${query}#`);
    await page.locator(`.bench[data-interaction="${wanted}"]`).waitFor({ state: 'attached' });
  }
  await page.goto(browser.address);
  await page.locator('.bench[data-interaction="full"]').waitFor({ state: 'attached' });
});

/** Counts the keys that the page around the element hears, by both of its listeners. */
const hearing = `<script>
  window.heard = [];
  for (const place of [document, window]) for (const type of ['keydown', 'keypress', 'keyup']) place.addEventListener(type, ({ key }) => window.heard.push(type + ' ' + key));
</script>`;
const heard = (page) => page.evaluate(() => window.heard.splice(0));

test('the page around does not hear the keys that are typed or handled inside', async () => {
  const { page, problems } = await guestPage(LINKAGE.replace(' src', ' panels="mechanism charts" style="height: 600px" src'), { head: hearing, viewport: { width: 1200, height: 800 } });
  await planned(page);
  await page.locator('[data-path="chains[0].base.x"]').waitFor();
  const press = async (...keys) => {
    for (const key of keys) await page.keyboard.press(key);
  };
  // That Ctrl goes down by itself is nobody's.
  const nothing = async (what) => assert.deepEqual((await heard(page)).filter((one) => !one.endsWith(' Control')), [], what);

  await page.locator('#canvas').focus();
  await press('ArrowLeft', 'ArrowUp', '.', ',', '1', 'f', 'p', '+', 'Home', ' ', ' ', 'Enter');
  await nothing('the view');
  await page.locator('#scrub').focus();
  await press('ArrowRight', '.', ',', 'End', 'PageDown', 'Control+ArrowLeft', ' ', ' ');
  await nothing('the scrub bar');
  await page.locator('#step-back').focus();
  await press('Enter', ' ', '.');
  await nothing('a button');
  await page.locator('#speed').focus();
  await press('ArrowDown', '1');
  await nothing('a choice');
  await page.locator('#frame-number').click();
  await press('1', '2', '.', 'b', 'Backspace', 'ArrowLeft', 'Escape');
  await nothing('the frame’s field');
  const field = page.locator('[data-path="chains[0].base.x"]');
  const old = await field.inputValue();
  await field.focus();
  await press('0', '.', '3', 'Control+a', '5', 'Enter', 'Control+z', 'ArrowDown');
  await nothing('a cell');
  assert.equal(await field.inputValue(), old, 'undo works there');
  await page.locator('#tab-charts').focus();
  await press('ArrowRight', ' ', 'Enter');
  await nothing('a tab');
  await page.getByRole('button', { name: 'Views' }).focus();
  await press('Enter', 'ArrowDown', 'End', 't', 'Escape');
  await nothing('a menu');
  assert.deepEqual(problems, []);
});

test('the page around hears every key that the element has no use for', async () => {
  const { page } = await guestPage(`${LINKAGE.replace(' src', ' panels="mechanism" style="height: 600px" src')}<input id="own">`, { head: hearing, viewport: { width: 1200, height: 800 } });
  await planned(page);
  const all = (key, ...types) => (types.length ? types : ['keydown', 'keyup']).flatMap((type) => [`${type} ${key}`, `${type} ${key}`]);
  const focus = { canvas: '#canvas', cell: '[data-path="chains[0].base.x"]', button: '#step-back', scrub: '#scrub' };
  // Reloading by F5 and leaving by Tab are the browser's; here only the page's scripts matter.
  await page.evaluate(() => addEventListener('keydown', (event) => /^(F5|Tab)$/.test(event.key) && event.preventDefault()));
  for (const [name, selector] of Object.entries(focus)) {
    await page.locator(selector).first().focus();
    for (const key of ['Escape', 'F5', 'Tab', 'F2']) {
      await page.keyboard.press(key);
      assert.deepEqual(await heard(page), all(key), `${key} in the ${name}`);
    }
  }
  await page.locator('#canvas').focus();
  await page.keyboard.press('o');
  assert.deepEqual(await heard(page), all('o', 'keydown', 'keypress', 'keyup'), 'a letter that means nothing in the view');
  await page.locator('#own').focus();
  await page.keyboard.press('.');
  assert.deepEqual(await heard(page), all('.', 'keydown', 'keypress', 'keyup'), 'what is typed elsewhere');
});

test('keys="page" leaves all keys to the page', async () => {
  const { page } = await guestPage(LINKAGE.replace(' src', ' keys="page" src'), { head: hearing });
  await planned(page);
  await page.locator('#frame-number').click();
  await page.keyboard.press('1');
  assert.ok((await heard(page)).includes('keydown 1'));
});

// The manners of the element in somebody else's page: how large it is, what it takes of pointer, wheel and keys, how it prints,
// and what it does not take over from the page.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { openBrowser } from './browser.mjs';

const DOCUMENT = readFileSync(new URL('../../www/mechanisms/2tpr.json', import.meta.url), 'utf8');

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

/** A page of somebody else's, 600 px wide unless told, with this in its body. */
async function guestPage(body, { head = '', html = '<html lang="en">', script = true, ...options } = {}) {
  const { page, problems } = await browser.blankPage({ viewport: { width: 600, height: 700 }, ...options });
  await page.route(`${browser.address}guest.html`, (route) =>
    route.fulfill({
      contentType: 'text/html',
      body: `<!doctype html>${html}<head><meta charset="utf-8"><meta name="viewport" content="width=device-width"><title>A page</title>
        ${script ? '<script type="module" src="./element.js"></script>' : ''}<style>body { margin: 0 }</style>${head}</head><body>${body}</body></html>`,
    }),
  );
  await page.route(`${browser.address}2tpr.json`, (route) => route.fulfill({ contentType: 'application/json', body: DOCUMENT }));
  await page.goto(`${browser.address}guest.html`);
  return { page, problems };
}

const planned = (page) =>
  page.waitForFunction(() => [...document.querySelectorAll('synthetica-linkage')].every((element) => element.trajectory && element.shadowRoot.querySelector('#frame-number')?.textContent !== '–'));

const LINKAGE = '<synthetica-linkage src="2tpr.json" controls></synthetica-linkage>';

test('is seen in every layout, and the author’s own sizes hold', async () => {
  const layouts = {
    block: `<div>${LINKAGE}</div>`,
    flexRow: `<div style="display: flex">${LINKAGE}<p>beside</p></div>`,
    fullRow: `<div style="display: flex">${LINKAGE}<p>${'many words '.repeat(80)}</p></div>`,
    narrowRow: `<div style="display: flex; width: 200px">${LINKAGE}</div>`,
    tableCell: `<table><tr><td>${LINKAGE}</td><td>beside</td></tr></table>`,
    autoColumn: `<div style="display: grid; grid-template-columns: auto 1fr">${LINKAGE}<p>beside</p></div>`,
    float: `<div style="overflow: hidden"><div style="float: left">${LINKAGE}</div></div>`,
    floated: LINKAGE.replace(' src', ' style="float: left" src'),
    inlineBlock: `<div style="clear: both">${LINKAGE.replace(' src', ' style="display: inline-block" src')}</div>`,
    centred: `<div style="display: flex; flex-direction: column; align-items: center">${LINKAGE}</div>`,
    absolute: `<div style="position: relative; height: 480px">${LINKAGE.replace(' src', ' style="position: absolute" src')}</div>`,
    minContent: LINKAGE.replace(' src', ' style="width: min-content" src'),
    flexItself: LINKAGE.replace(' src', ' style="display: flex" src'),
    gridItself: LINKAGE.replace(' src', ' style="display: grid" src'),
    inlineItself: LINKAGE.replace(' src', ' style="display: inline" src'),
    byStyle: LINKAGE.replace(' src', ' class="own" src'),
  };
  const body = Object.entries(layouts).map(([name, html]) => `<section id="${name}">${html}</section>`).join('');
  // One style sheet of the page's, as weak as it can be.
  const { page, problems } = await guestPage(body, { head: '<style>.own { width: 80px; height: 90px }</style>' });
  await page.waitForFunction(() => customElements.get('synthetica-linkage'));
  const found = await page.evaluate(() =>
    Object.fromEntries(
      [...document.querySelectorAll('section')].map((section) => {
        const element = section.querySelector('synthetica-linkage');
        const bench = element.shadowRoot.querySelector('#bench').getBoundingClientRect();
        const own = element.getBoundingClientRect();
        return [section.id, { width: bench.width, height: bench.height, own: getComputedStyle(element).display === 'inline' ? bench.width : own.width }];
      }),
    ),
  );
  for (const [name, { width, height, own }] of Object.entries(found)) {
    assert.equal(width, own, `${name}: what is seen is as wide as the element`);
    if (name === 'byStyle') continue;
    assert.ok(width >= 120 && width <= 600, `${name} is ${width} px wide`);
    assert.ok(height >= 120, `${name} is ${height} px high`);
  }
  assert.deepEqual(
    Object.fromEntries(['block', 'flexRow', 'tableCell', 'float', 'floated', 'inlineBlock', 'centred', 'absolute', 'narrowRow', 'byStyle'].map((name) => [name, found[name].width])),
    { block: 600, flexRow: 300, tableCell: 300, float: 300, floated: 300, inlineBlock: 300, centred: 300, absolute: 300, narrowRow: 200, byStyle: 80 },
  );
  assert.equal(found.byStyle.height, 90);
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 600, 'nothing sticks out');
  assert.deepEqual(problems, []);
});

test('with controls it can be used from 120 px on: what does not fit is left out, playing and scrubbing last', async () => {
  const widths = [120, 150, 200, 240, 300, 320, 400];
  const body = widths.map((width) => LINKAGE.replace(' src', ` id="w${width}" style="width: ${width}px; height: 320px; float: left" src`)).join('');
  const { page } = await guestPage(body, { viewport: { width: 1200, height: 700 } });
  await planned(page);
  for (const width of widths) {
    const boxes = await page.evaluate((id) => {
      const element = document.getElementById(id);
      const own = element.getBoundingClientRect();
      const controls = [...element.shadowRoot.querySelectorAll('.transport button:not(.tick), .transport select, #track, .view-bar > button')].filter((one) => one.checkVisibility());
      return controls.map((one) => {
        const { x, y, width: wide, height: high } = one.getBoundingClientRect();
        const over = one.scrollWidth - one.clientWidth;
        return { id: one.id || one.textContent, x: x - own.x, y: y - own.y, wide, high, cut: one.localName === 'button' && over > 0 };
      });
    }, `w${width}`);
    const ids = boxes.map(({ id }) => id);
    for (const id of ['play', 'track']) assert.ok(ids.includes(id), `${width}: ${id} is there`);
    for (const { id, x, y, wide, high, cut } of boxes) {
      assert.ok(x >= 0 && y >= 0 && x + wide <= width && y + high <= 320 && !cut, `${width}: ${id} is not cut off (${[x, y, wide, high]})`);
      assert.ok(high >= 24 && wide >= 24, `${width}: ${id} can be hit`);
    }
    for (const [at, a] of boxes.entries()) {
      for (const b of boxes.slice(at + 1)) assert.ok(a.x + a.wide <= b.x || b.x + b.wide <= a.x || a.y + a.high <= b.y || b.y + b.high <= a.y, `${width}: ${a.id} overlaps ${b.id}`);
    }
    const scene = await page.locator(`#w${width} .scene`).boundingBox();
    assert.ok(scene.width === width && scene.height >= 110, `${width}: the view has room (${scene.height})`);
  }
  const offered = (width) => page.locator(`#w${width}`).locator('.transport button, .transport select, .view-bar > button').filter({ visible: true }).count();
  assert.ok((await offered(120)) < (await offered(200)) && (await offered(200)) < (await offered(300)) && (await offered(300)) < (await offered(400)));
});

test('with controls it can be used in little height too, down to 120 px', async () => {
  const sizes = [120, 300, 560, 900].flatMap((width) => [120, 150, 180, 200].map((height) => [width, height]));
  const id = ([width, height]) => `s${width}x${height}`;
  const body = sizes.map((size) => LINKAGE.replace(' src', ` id="${id(size)}" style="width: ${size[0]}px; height: ${size[1]}px; float: left" src`)).join('');
  const { page, problems } = await guestPage(body, { viewport: { width: 1200, height: 1700 } });
  await planned(page);
  await page.waitForFunction(() => [...document.querySelectorAll('synthetica-linkage')].every(({ offsetHeight, shadowRoot }) => shadowRoot.querySelector('.low') !== null === offsetHeight < 180));
  for (const size of sizes) {
    const { controls, scroll, scene } = await page.evaluate((one) => {
      const element = document.getElementById(one);
      const own = element.getBoundingClientRect();
      const bench = element.shadowRoot.querySelector('.bench');
      return {
        controls: [...element.shadowRoot.querySelectorAll('.transport button:not(.tick), .transport select, #track, .view-bar > button')]
          .filter((control) => control.checkVisibility())
          .map((control) => {
            const { top, bottom, left, right } = control.getBoundingClientRect();
            return { id: control.id, fits: top >= own.top && bottom <= own.bottom && left >= own.left && right <= own.right, large: right - left >= 24 && bottom - top >= 24 };
          }),
        scroll: bench.scrollHeight - bench.clientHeight,
        scene: element.shadowRoot.querySelector('.scene').offsetHeight,
      };
    }, id(size));
    for (const wanted of ['play', 'track']) assert.ok(controls.some((control) => control.id === wanted), `${size}: ${wanted} is there`);
    assert.deepEqual(controls.filter(({ fits, large }) => !fits || !large), [], `${size}: all that is there can be hit`);
    assert.ok(scroll <= 4 && scene >= 60, `${size}: ${scroll} px stick out, the view is ${scene} px high`);
  }
  assert.deepEqual(problems, []);
});

test('a legend does not hide a low view, and is there again where there is room', async () => {
  const { page } = await guestPage(LINKAGE.replace(' src', ' style="width: 358px; height: 270px" src'), { viewport: { width: 390, height: 700 } });
  await planned(page);
  const legend = page.locator('#legend');
  await legend.waitFor({ state: 'hidden' });
  await page.locator('synthetica-linkage').evaluate((element) => (element.style.height = '440px'));
  await legend.waitFor({ state: 'visible' });
});

/** How the first linkage is looked at: from where, and how far away. */
const look = (page) =>
  page.evaluate(async () => {
    const { scene } = await document.querySelector('synthetica-linkage').workbench;
    const { position } = scene.camera;
    return { distance: scene.controls.getDistance(), angle: scene.controls.getAzimuthalAngle(), at: position.toArray().join() };
  });
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
    await page.waitForFunction(async (old) => (await document.querySelector('synthetica-linkage').workbench).scene.controls.getDistance() < old, far);
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
  await page.waitForFunction(async (old) => (await document.querySelector('synthetica-linkage').workbench).scene.controls.getDistance() < old, distance);
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

const PICTURE = `data:image/svg+xml,${encodeURIComponent('<svg xmlns="http://www.w3.org/2000/svg" width="400" height="200"><rect width="400" height="200" fill="teal"/></svg>')}`;
/** What a view is drawn with: its colours, how many pixels there are to a CSS pixel, its shape. */
const picture = (page, id) =>
  page.evaluate(async (one) => {
    const { scene } = await document.getElementById(one).workbench;
    const { canvas } = scene;
    const colours = [];
    for (const part of scene.pictured) part.traverse(({ material }) => material?.color && colours.push(material.color.getHexString()));
    return { ratio: canvas.width / canvas.clientWidth, shape: canvas.width / canvas.height, colours: colours.join() };
  }, id);

test('on paper the picture is sharp and light, and comes back as it was', async () => {
  const [dark, light] = ['dark', 'light'].map((theme) => LINKAGE.replace(' src', ` id="${theme}" theme="${theme}" style="height: 300px" src`));
  const { page, problems } = await guestPage(dark + light);
  await planned(page);
  await page.waitForFunction(() => page$$('#canvas').every((canvas) => canvas.dataset.draws));
  const before = await picture(page, 'dark');
  assert.notEqual(before.colours, (await picture(page, 'light')).colours, 'on the screen they differ');
  // What a browser does first of all.
  await page.evaluate(() => dispatchEvent(new Event('beforeprint')));
  const [one, other] = [await picture(page, 'dark'), await picture(page, 'light')];
  assert.equal(one.ratio, 2 * before.ratio);
  assert.ok(Math.abs(one.shape - before.shape) < 0.01);
  assert.equal(one.colours, other.colours, 'both are light');
  await page.evaluate(() => dispatchEvent(new Event('afterprint')));
  assert.deepEqual(await picture(page, 'dark'), before);

  const pdf = (await page.pdf({ width: '400px', height: '800px' })).toString('latin1');
  const widths = [...pdf.matchAll(/\/Subtype \/Image\s+\/Width (\d+)/g)].map(([, width]) => Number(width));
  assert.ok(widths.filter((width) => width >= 2 * 600).length >= 2, `the pictures in the file are ${widths} px wide`);
  assert.deepEqual(problems, []);
});

test('on paper there are no controls, and the names stay where they belong in a picture of another size', async () => {
  const { page } = await guestPage(LINKAGE.replace(' src', ' panels="mechanism charts" style="height: 500px" src') + LINKAGE, { viewport: { width: 1000, height: 1200 } });
  await planned(page);
  await page.waitForFunction(() => page$$('#labels > span:not([hidden])').length > 3);
  // As a browser that lays out for paper without telling the page's scripts of the new size.
  const places = () =>
    page.evaluate(() => {
      const element = [...document.querySelectorAll('synthetica-linkage')].at(-1);
      const inside = (selector) => [...element.shadowRoot.querySelectorAll(selector)];
      const box = inside('#canvas')[0].getBoundingClientRect();
      return {
        box: { width: box.width, height: box.height },
        names: inside('#labels > span:not([hidden])').map((tag) => {
          const { x, y } = tag.getBoundingClientRect();
          // From the name to its point the distance is one of letters, the same in every size.
          return [(x - parseFloat(tag.style.left) - box.x) / box.width, (y - parseFloat(tag.style.top) - box.y) / box.height];
        }),
      };
    });
  const screen = await places();
  await page.evaluate(() => {
    dispatchEvent(new Event('beforeprint'));
    const element = [...document.querySelectorAll('synthetica-linkage')].at(-1);
    element.style.width = '500px';
  });
  await page.emulateMedia({ media: 'print' });
  const paper = await places();
  assert.deepEqual([paper.box.width, screen.box.width], [500, 1000]);
  assert.ok(Math.abs(paper.box.width / paper.box.height - screen.box.width / screen.box.height) < 0.02, 'the picture has its shape');
  for (const [at, [x, y]] of screen.names.entries()) {
    assert.ok(Math.abs(x - paper.names[at][0]) < 0.003 && Math.abs(y - paper.names[at][1]) < 0.01, `${[x, y]} against ${paper.names[at]}`);
  }
  const controls = '.transport, .view-bar, .tabs, .dock-bar, .notices, #dock-handle, .menu-button, .bench .icon';
  assert.deepEqual(await page.evaluate((all) => page$$(all).filter((one) => one.checkVisibility()).map((one) => one.className), controls), []);
  assert.ok(await page.locator('#legend').last().isVisible(), 'the legend is no control');
  assert.equal(await page.locator('.bench').first().evaluate((bench) => getComputedStyle(bench).colorScheme), 'light');
});

test('what was never loaded prints its poster, its content, or a line that says what it is', async () => {
  const { page } = await guestPage(
    `<div style="height: 20000px"></div>
     <synthetica-linkage id="empty" type="3RPS" controls></synthetica-linkage>
     <synthetica-linkage id="address" src="2tpr.json" controls>
       <script type="application/json">{}</script></synthetica-linkage>
     <synthetica-linkage id="content" src="2tpr.json" controls><p style="height: 700px">A plate on three legs</p></synthetica-linkage>
     <synthetica-linkage id="poster" src="2tpr.json" poster="${PICTURE}" controls><p>A plate</p></synthetica-linkage>`,
  );
  await page.waitForFunction(() => document.getElementById('poster').shadowRoot?.querySelector('img').complete);
  await page.evaluate(() => dispatchEvent(new Event('beforeprint')));
  await page.emulateMedia({ media: 'print' });
  const found = await page.evaluate(() =>
    Object.fromEntries(
      [...document.querySelectorAll('synthetica-linkage')].map((element) => {
        const inside = (selector) => element.shadowRoot.querySelector(selector);
        const { width, height } = inside('img').getBoundingClientRect();
        return [
          element.id,
          {
            height: element.offsetHeight,
            line: getComputedStyle(inside('.fallback'), '::after').content,
            poster: [width, height],
            controls: [...element.shadowRoot.querySelectorAll('.transport, .view-bar')].filter((one) => one.checkVisibility()).length,
            never: inside('#canvas').dataset.draws === undefined,
          },
        ];
      }),
    ),
  );
  assert.ok(Object.values(found).every(({ never, controls }) => never && controls === 0));
  assert.equal(found.empty.line, '"Linkage 3RPS"');
  assert.equal(found.address.line, '"Linkage 2tpr.json"');
  assert.ok(found.empty.height > 15 && found.empty.height < 100, `a line is ${found.empty.height} px high`);
  assert.equal(found.content.line, '""');
  assert.ok(found.content.height >= 700, 'nothing of the content is cut off');
  assert.deepEqual(found.poster.poster, [600, 300]);
  assert.ok(found.poster.height >= 300 && found.poster.height < 320);
});

test('nothing of the page’s type, direction and cursor comes in, its own content keeps its direction', async () => {
  const styles = `<style>
    body, synthetica-linkage, synthetica-linkage * { direction: rtl; text-align: right; letter-spacing: 9px; word-spacing: 20px; text-transform: uppercase; line-height: 4; font: italic bold 40px/4 cursive;
      cursor: wait; white-space: pre; text-indent: 50px; text-shadow: 2px 2px red; -webkit-text-stroke: 1px red; list-style: square; writing-mode: vertical-rl; color: red; font-variant-caps: small-caps; user-select: none; }
  </style>`;
  const element = LINKAGE.replace(' src', ' panels="mechanism" style="width: 900px; height: 500px; display: block" src').replace('></synth', '><p>طريقة</p></synth');
  const look = async (page) =>
    page.evaluate(() => {
      const inside = [...document.querySelector('synthetica-linkage').shadowRoot.querySelectorAll('#play, #frame-number, #scrub, #views, .legend li, .view-bar > button, #labels > span, .cell, .tabs button, #canvas, .notices, #speed, th, summary')];
      const outer = document.querySelector('synthetica-linkage').getBoundingClientRect();
      const names = ['direction', 'textAlign', 'letterSpacing', 'wordSpacing', 'textTransform', 'lineHeight', 'fontSize', 'fontFamily', 'fontStyle', 'fontWeight', 'fontVariantCaps', 'cursor', 'whiteSpace', 'textIndent', 'textShadow', 'webkitTextStrokeWidth', 'listStyleType', 'writingMode', 'color', 'visibility'];
      return inside.filter((one) => one.checkVisibility()).map((one) => {
        const style = getComputedStyle(one);
        const { x, y, width, height } = one.getBoundingClientRect();
        return [one.id || one.className || one.localName, ...names.map((name) => style[name]), ...[x - outer.x, y - outer.y, width, height].map(Math.round)].join(' | ');
      });
    });
  const pages = [];
  for (const options of [{}, { html: '<html lang="ar" dir="rtl">', head: styles }]) {
    const { page } = await guestPage(element, { viewport: { width: 1000, height: 700 }, ...options });
    await planned(page);
    await page.locator('[data-path="chains[0].base.x"]').waitFor();
    await page.waitForFunction(() => page$$('#labels > span:not([hidden])').length > 0);
    pages.push(page);
  }
  const [plain, strange] = [await look(pages[0]), await look(pages[1])];
  assert.ok(plain.length > 30);
  for (const [at, line] of plain.entries()) assert.equal(strange[at], line);
  assert.equal(await pages[1].evaluate(() => getComputedStyle(page$('.fallback')).direction), 'rtl');
  assert.equal(await pages[0].evaluate(() => getComputedStyle(page$('.fallback')).direction), 'ltr');
  // What does come in: whether it is seen, whether it takes pointers.
  await pages[0].evaluate(() => (document.querySelector('synthetica-linkage').style.cssText += '; visibility: hidden; pointer-events: none'));
  assert.deepEqual(await pages[0].evaluate(() => [getComputedStyle(page$('#play')).visibility, getComputedStyle(page$('#play')).pointerEvents]), ['hidden', 'none']);
});

// How large the element is in somebody else's page, and what of its controls is left where there is little room.
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
  assert.ok(await page.getByRole('button', { name: 'Legend' }).isHidden());
  await legend.waitFor({ state: 'hidden' });
  await page.locator('synthetica-linkage').evaluate((element) => (element.style.height = '440px'));
  await legend.waitFor({ state: 'visible' });
});

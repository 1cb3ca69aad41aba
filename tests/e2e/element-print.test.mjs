// How the element prints, and what it does not take over from the page around it.
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
          const [right, down] = tag.style.translate.split(' ').map(parseFloat);
          return [(x - right - box.x) / box.width, (y - down - box.y) / box.height];
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

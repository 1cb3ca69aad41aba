// What lies over the view covers nothing of the linkage: it is fitted into what is free, and the legend folds.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { openBrowser, openSample } from './browser.mjs';
import { LINKAGE, openGuestPage, planned } from './guest-page.mjs';

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

const TOUCH = { isMobile: true, hasTouch: true };

/** The box around all that is drawn of the linkage and its motions, at several frames, and the boxes over the view; pixels of the view. */
const boxes = (page) =>
  page.evaluate(async () => {
    const element = document.querySelector('synthetica-linkage');
    const { scene, player, store } = await element.workbench;
    const { motion } = store.result;
    const { left: x0, top: y0, width, height } = scene.canvas.getBoundingClientRect();
    const box = { left: Infinity, top: Infinity, right: -Infinity, bottom: -Infinity };
    const see = (matrix, x, y, z) => {
      const m = matrix.elements;
      const w = m[3] * x + m[7] * y + m[11] * z + m[15];
      const [across, up] = [0, 1].map((row) => (m[row] * x + m[row + 4] * y + m[row + 8] * z + m[row + 12]) / w);
      const [px, py] = [((across + 1) / 2) * width, ((1 - up) / 2) * height];
      Object.assign(box, { left: Math.min(box.left, px), top: Math.min(box.top, py), right: Math.max(box.right, px), bottom: Math.max(box.bottom, py) });
    };
    const view = () => scene.camera.projectionMatrix.clone().multiply(scene.camera.matrixWorldInverse);
    const [linkage] = scene.pictured.slice(-2);
    for (const frame of [0, 0.25, 0.5, 0.75, 1].map((share) => Math.round(share * (motion.frames - 1)))) {
      player.frame = frame;
      await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
      linkage.traverseVisible((object) => {
        const position = object.isMesh && object.material.visible && object.geometry.getAttribute('position');
        if (!position) return;
        const matrix = view().multiply(object.matrixWorld);
        for (let at = 0; at < position.count; at++) see(matrix, position.getX(at), position.getY(at), position.getZ(at));
      });
    }
    for (const column of [motion.goal, motion.pose]) for (let at = 0; at < column.length; at += 7) if (Number.isFinite(column[at])) see(view(), column[at], column[at + 1], column[at + 2]);
    const over = [...element.shadowRoot.querySelectorAll('.view-bar, .legend, .cube, .banner, .by-hand')]
      .map((one) => [one.className, one.getBoundingClientRect()])
      .filter(([, { width: wide }]) => wide > 0)
      .map(([name, { left, top, right, bottom }]) => ({ name, left: left - x0, top: top - y0, right: right - x0, bottom: bottom - y0 }));
    return { box, over, width, height };
  });

function isClear({ box, over, width, height }, name) {
  assert.ok(box.left >= 0 && box.top >= 0 && box.right <= width && box.bottom <= height, `${name}: all is in view: ${JSON.stringify(box)} of ${width} × ${height}`);
  for (const one of over) {
    const apart = one.right <= box.left || box.right <= one.left || one.bottom <= box.top || box.bottom <= one.top;
    assert.ok(apart, `${name}: ${one.name} lies over the linkage: ${JSON.stringify([one, box])}`);
  }
  const share = Math.max((box.right - box.left) / width, (box.bottom - box.top) / height);
  assert.ok(share > 0.45, `${name}: the linkage is as large as can be, not ${share} of the view`);
}

for (const [name, options] of Object.entries({
  desktop: { viewport: { width: 1440, height: 900 } },
  phone: { viewport: { width: 390, height: 844 }, ...TOUCH },
  'phone across': { viewport: { width: 844, height: 390 }, ...TOUCH },
})) {
  test(`after Fit nothing lies over linkage and motions: ${name}`, async () => {
    const { page, problems } = await browser.openPage({ ...options, legend: null });
    isClear(await boxes(page), `${name}, at first`);
    await page.locator('#canvas').focus();
    for (const key of ['1', '5', '7', 'p', '+', '+', '+', 'Shift+ArrowLeft', 'Home']) await page.keyboard.press(key);
    isClear(await boxes(page), `${name}, in parallel lines`);
    await openSample(page, 'slider-crank.json');
    isClear(await boxes(page), `${name}, a slider crank`);
    assert.deepEqual(problems, []);
  });
}

test('after Fit nothing lies over linkage and motions: small and low elements', async () => {
  for (const [width, height] of [[300, 220], [600, 190], [400, 300], [240, 320]]) {
    const { page } = await openGuestPage(browser, LINKAGE.replace(' src', ` style="width: ${width}px; height: ${height}px" src`), { viewport: { width: 700, height: 700 }, legend: null });
    await planned(page);
    isClear(await boxes(page), `${width} × ${height}`);
    await page.close();
  }
});

test('the legend folds to its button, is folded at first where there is little room, and stays as it was left', async () => {
  const context = { viewport: { width: 390, height: 844 }, ...TOUCH };
  const { page } = await browser.openPage({ ...context, legend: null });
  const list = page.locator('#legend');
  const button = page.getByRole('button', { name: 'Legend' });
  assert.equal(await button.getAttribute('aria-expanded'), 'false');
  assert.ok(await list.isHidden());
  await button.click();
  await list.getByText('goal motion').waitFor();
  assert.equal(await button.getAttribute('aria-expanded'), 'true');
  isClear(await boxes(page), 'unfolded');
  await page.reload();
  await list.getByText('goal motion').waitFor();
  const desktop = await browser.openPage({ viewport: { width: 1440, height: 900 }, legend: null });
  await desktop.page.locator('#legend').getByText('goal motion').waitFor();
  await desktop.page.getByRole('button', { name: 'Legend' }).click();
  await desktop.page.locator('#legend').waitFor({ state: 'hidden' });
  await desktop.page.reload();
  await desktop.page.getByRole('button', { name: 'Legend' }).waitFor();
  assert.ok(await desktop.page.locator('#legend').isHidden());
});

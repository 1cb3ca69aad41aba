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
    const [, linkage] = scene.pictured.filter(({ type }) => type === 'Group');
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
    const over = [...element.shadowRoot.querySelectorAll('.view-bar, .legend, .cube, .banner, .by-hand, .fold, #view-only')]
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
    const { page, problems } = await browser.openPage({ ...options, legend: false });
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
    const { page } = await openGuestPage(browser, LINKAGE.replace(' src', ` style="width: ${width}px; height: ${height}px" src`), { viewport: { width: 700, height: 700 }, legend: false });
    await planned(page);
    isClear(await boxes(page), `${width} × ${height}`);
    await page.close();
  }
});

test('the legend folds to its button, is folded at first where there is little room, and stays as it was left', async () => {
  const context = { viewport: { width: 390, height: 844 }, ...TOUCH };
  const { page } = await browser.openPage({ ...context, legend: false });
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
  const desktop = await browser.openPage({ viewport: { width: 1440, height: 900 }, legend: false });
  await desktop.page.locator('#legend').getByText('goal motion').waitFor();
  await desktop.page.getByRole('button', { name: 'Legend' }).click();
  await desktop.page.locator('#legend').waitFor({ state: 'hidden' });
  await desktop.page.reload();
  await desktop.page.getByRole('button', { name: 'Legend' }).waitFor();
  assert.ok(await desktop.page.locator('#legend').isHidden());
});

const drawn = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));

/** Flags that are shown, with their points and the ends of their leaders, and the handle of what is in hand; pixels of the window. */
const flags = (page) =>
  page.evaluate(() => {
    const canvas = page$('#canvas');
    const room = canvas.getBoundingClientRect();
    return {
      room: room.toJSON(),
      hand: canvas.dataset.hand?.split(' ').map(Number).map((value, axis) => value + [room.x, room.y][axis]),
      flags: page$$('#labels span:not([hidden])').map((tag) => {
        const { e, f } = new DOMMatrix(getComputedStyle(tag).transform);
        const box = tag.getBoundingClientRect();
        const style = (name) => parseFloat(tag.style.getPropertyValue(`--${name}`));
        // From the flag's near end back along the leader.
        const [across, below] = [style('across'), style('below')];
        const from = [box.x + ((1 - across) * box.width) / 2, box.y + ((1 - below) * box.height) / 2];
        const end = [from[0] + style('leader') * Math.cos(style('back')), from[1] + style('leader') * Math.sin(style('back'))];
        return { text: tag.textContent, place: tag.dataset.place, box: box.toJSON(), point: [room.x + e, room.y + f], end, line: getComputedStyle(tag, '::before').borderTopWidth };
      }),
    };
  });

const away = ({ x, y, width, height }, [px, py]) => Math.hypot(Math.max(x - px, px - x - width, 0), Math.max(y - py, py - y - height, 0));

for (const [name, options, chosen] of [
  ['desktop', { viewport: { width: 1440, height: 900 } }, 'motion.key_frames[1]'],
  ['phone', { viewport: { width: 390, height: 844 }, ...TOUCH }, 'workpiece'],
]) {
  test(`flags stand off what they name, at the ends of their leaders, clear of each other and of the handle, also while it plays: ${name}`, async () => {
    const { page, problems } = await browser.openPage({ ...options, legend: false });
    const choose = (place) => page.evaluate((what) => document.querySelector('synthetica-linkage').parts.store.setView({ selected: what }), place);
    let sides = 0;
    let before = null;
    for (const [selected, frame] of [['', 0], ['', 30], ['', 60], ['', 90], ['', 120], [chosen, 120], [chosen, 60], [chosen, 0]]) {
      await page.locator('#scrub').fill(String(frame));
      await choose(selected);
      if (selected) await page.waitForFunction(() => page$('#canvas').dataset.hand !== undefined);
      await drawn(page);
      await drawn(page);
      const { room, hand, flags: all } = await flags(page);
      assert.ok(all.length >= 6, `${name}: ${all.length} flags are shown`);
      for (const [at, one] of all.entries()) {
        assert.ok(away(one.box, one.point) >= 8, `${one.text} lies on what it names`);
        assert.ok(Math.hypot(one.end[0] - one.point[0], one.end[1] - one.point[1]) < 9, `${one.text}: its leader ends at its point: ${one.end}, ${one.point}`);
        assert.equal(one.line, '1px');
        if (hand) assert.ok(away(one.box, hand) > 6, `${one.text} lies on the handle`);
        assert.ok(one.box.left >= room.left && one.box.right <= room.right && one.box.top >= room.top && one.box.bottom <= room.bottom, `${one.text} is inside`);
        for (const other of all.slice(at + 1)) {
          const apart = one.box.right <= other.box.left + 0.5 || other.box.right <= one.box.left + 0.5 || one.box.bottom <= other.box.top + 0.5 || other.box.bottom <= one.box.top + 0.5;
          assert.ok(apart, `${one.text} covers ${other.text}`);
        }
      }
      const now = new Map(all.map(({ place, box, point }) => [place, [box.x - point[0], box.y - point[1]]]));
      if (before && !selected) for (const [place, [x, y]] of now) if (Math.hypot(x - before.get(place)[0], y - before.get(place)[1]) > 1) sides++;
      before = now;
    }
    assert.equal(sides, 0, 'no flag jumps while the motion plays');
    assert.deepEqual(problems, []);
  });
}

test('the gizmo is 90 px from its middle to the ends of its arrows, whatever the zoom, the projection and the unit, and clear of flags', async () => {
  const { page } = await browser.openPage({ viewport: { width: 1440, height: 900 } });
  await page.locator('#labels [data-place="motion.key_frames[1]"]').click();
  await page.locator('.hand-labels span').first().waitFor();
  const look = async () => {
    await drawn(page);
    return page.evaluate(async () => {
      const { scene } = await document.querySelector('synthetica-linkage').workbench;
      const helper = scene.root.children.find(({ isTransformControlsRoot }) => isTransformControlsRoot);
      const { controls } = helper;
      const { camera } = scene;
      const at = controls.object.getWorldPosition(controls.object.position.clone());
      const factor = camera.isPerspectiveCamera ? at.distanceTo(camera.position) * 1.9 * Math.tan((camera.fov * Math.PI) / 360) : (camera.top - camera.bottom) / camera.zoom;
      const arm = ((0.6 * controls.size) / 4) * factor;
      // Across the line of sight, where nothing is foreshortened.
      const right = at.clone().setFromMatrixColumn(camera.matrixWorld, 0);
      const flat = (point) => { const seen = point.clone().project(camera); return [((seen.x + 1) / 2) * scene.canvas.clientWidth, ((1 - seen.y) / 2) * scene.canvas.clientHeight]; };
      const [a, b] = [flat(at), flat(at.clone().addScaledVector(right, arm))];
      const box = scene.canvas.getBoundingClientRect();
      const letters = page$$('.hand-labels span:not([hidden])').map((tag) => tag.getBoundingClientRect()).map(({ x, y, width, height }) => [x + width / 2, y + height / 2]);
      const names = page$$('#labels span:not([hidden])').map((tag) => tag.getBoundingClientRect().toJSON());
      return { long: Math.hypot(b[0] - a[0], b[1] - a[1]), middle: [box.x + a[0], box.y + a[1]], letters, names };
    });
  };
  const isRight = ({ long, middle, letters, names }, what) => {
    assert.ok(Math.abs(long - 90) < 1, `${what}: ${long} px`);
    for (const [x, y] of letters) for (let share = 0.1; share < 0.95; share += 0.05) for (const one of names) assert.ok(away(one, [middle[0] + share * (x - middle[0]), middle[1] + share * (y - middle[1])]) > 0, `${what}: a flag lies on an arrow`);
  };
  isRight(await look(), 'at first');
  await page.locator('#canvas').focus();
  for (let i = 0; i < 5; i++) await page.keyboard.press('+');
  isRight(await look(), 'nearer');
  await page.keyboard.press('p');
  isRight(await look(), 'in parallel lines');
  for (let i = 0; i < 12; i++) await page.keyboard.press('-');
  isRight(await look(), 'far away');
});

test('the view cube shows the direction; a face, an edge and a corner look from there, a drag turns, and small views have none', async () => {
  const { page, problems } = await browser.openPage({ viewport: { width: 1440, height: 900 } });
  const cube = page.locator('#cube');
  const { x, y, width, height } = await cube.boundingBox();
  const [mx, my] = [x + width / 2, y + height / 2];
  const direction = () =>
    page.evaluate(async () => {
      const { scene } = await document.querySelector('synthetica-linkage').workbench;
      return scene.camera.matrixWorld.elements.slice(8, 11).map((value) => Math.round(value * 1000) / 1000);
    });
  /** A slow machine draws late. */
  async function looksFrom(wanted) {
    for (let tries = 0; tries < 100 && String(await direction()) !== String(wanted); tries++) await drawn(page);
    assert.deepEqual(await direction(), wanted);
  }
  const turn = () => page.locator('#cube div').evaluate((node) => node.style.transform);
  await page.locator('#canvas').focus();
  await page.keyboard.press('1');
  await drawn(page);
  assert.deepEqual((await direction()).map(Math.abs), [0, 1, 0]);
  assert.match(await turn(), /^rotateX\(-?0rad\) rotateY\(-?0rad\)$/);
  // The right edge of the front face, then the corner above, then the top by its face.
  await page.mouse.click(mx + 20, my);
  await looksFrom([0.707, -0.707, 0]);
  await page.mouse.click(mx, my - 20);
  await looksFrom([0.577, -0.577, 0.577]);
  await page.mouse.click(mx, my - 18);
  await page.locator('#view-live').filter({ hasText: 'Top view.' }).waitFor();
  await drawn(page);
  assert.deepEqual((await direction()).map((value) => Math.abs(Math.round(value))), [0, 0, 1]);
  isClear(await boxes(page), 'from the top');
  const old = await turn();
  await page.mouse.move(mx, my);
  await page.mouse.down();
  await page.mouse.move(mx + 30, my - 40, { steps: 5 });
  await page.mouse.up();
  await drawn(page);
  assert.notEqual(await turn(), old);
  const [, , up] = await direction();
  assert.ok(up > 0.5 && up < 0.95, `turned by the drag: ${up}`);
  assert.equal(await page.evaluate(() => pageFocus().id), 'canvas', 'the view has the keys');
  await page.locator('#play').focus();
  await page.locator('#labels [data-place="motion.key_frames[1]"]').click();
  assert.equal(await page.evaluate(() => pageFocus().id), 'canvas', 'after a click on a name too');
  assert.equal(await page.evaluate(() => String(getSelection())), '', 'no letters of the cube are marked');
  assert.equal(await page.locator('.corner').getAttribute('aria-hidden'), 'true', 'the menu of views does the same');
  assert.deepEqual(problems, []);
  const small = await openGuestPage(browser, LINKAGE.replace(' src', ' style="width: 300px; height: 220px" src') + LINKAGE.replace(' controls', ''));
  await planned(small.page);
  for (const one of await small.page.locator('#cube').all()) assert.ok(await one.isHidden());
});

test('a double click or tap on a thing looks at it, on empty ground at all again', async () => {
  for (const options of [{ viewport: { width: 1440, height: 900 } }, { viewport: { width: 390, height: 844 }, ...TOUCH }]) {
    const { page, problems } = await browser.openPage({ ...options, legend: false });
    const seen = () =>
      page.evaluate(async () => {
        const { scene } = await document.querySelector('synthetica-linkage').workbench;
        const at = scene.names.find(({ place }) => place === 'chains[0].base').at;
        const flat = at.clone().project(scene.camera);
        const box = scene.canvas.getBoundingClientRect();
        return { x: box.x + ((flat.x + 1) / 2) * box.width, y: box.y + ((1 - flat.y) / 2) * box.height, far: scene.camera.position.distanceTo(at), box: box.toJSON() };
      });
    /** Taps come late on a loaded machine: until two have been near enough in time. */
    const twice = async (x, y, isDone) => {
      for (let tries = 0; tries < 20; tries++) {
        if (options.hasTouch) for (let i = 0; i < 2; i++) await page.touchscreen.tap(x, y);
        else await page.mouse.dblclick(x, y);
        await drawn(page);
        if (!options.hasTouch || isDone(await seen())) return;
      }
    };
    const first = await seen();
    // What a hand can do is loaded when one comes.
    if (!options.hasTouch) {
      await page.mouse.move(first.x, first.y);
      await page.locator('.hand-labels').waitFor({ state: 'attached' });
    }
    await twice(first.x, first.y, ({ far }) => far < 0.5 * first.far);
    const near = await seen();
    assert.ok(near.far < 0.5 * first.far, `nearer: ${near.far} of ${first.far}`);
    const off = Math.hypot(near.x - near.box.x - near.box.width / 2, near.y - near.box.y - near.box.height / 2);
    assert.ok(off < 0.3 * near.box.height, `it is in the middle, ${off} px off`);
    await page.keyboard.press('Escape');
    await drawn(page);
    // Beside the linkage.
    const { box } = await seen();
    await twice(box.x + 30, box.y + 0.7 * box.height, ({ far }) => far > 0.8 * first.far);
    const last = await seen();
    assert.ok(Math.abs(last.far / first.far - 1) < 0.2, `all again: ${last.far} of ${first.far}`);
    isClear(await boxes(page), 'again');
    assert.deepEqual(problems, []);
  }
});

// The custom element in pages of other people: what it is given, what it tells, and that many live side by side.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { violations } from './axe.mjs';
import { openBrowser } from './browser.mjs';

const sample = (name) => readFileSync(new URL(`../../www/mechanisms/${name}.json`, import.meta.url), 'utf8');

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

/** A page of somebody else's, on the same server, with this in its body; `asked` is told all that is asked for, by its workers too. */
async function course(body, { head = '', script = true, asked = () => {}, ...options } = {}) {
  const { page, problems } = await browser.blankPage(options);
  page.context().on('request', (request) => asked(request.url()));
  // All of them, wherever they are; what is loaded late is seen to in element-life.test.mjs.
  const hurried = body.replaceAll('<synthetica-linkage', '<synthetica-linkage loading="eager"');
  const html = `<!doctype html><html lang="en"><head><meta charset="utf-8"><title>A course</title>${head}
    ${script ? '<script type="module" src="./element.js"></script>' : ''}</head><body><main><h1>A course</h1>${hurried}</main></body></html>`;
  await page.route(`${browser.address}course.html`, (route) => route.fulfill({ contentType: 'text/html', body: html }));
  for (const name of ['3rps', '2tpr', 'bennett']) {
    await page.route(`${browser.address}${name}.json`, (route) => route.fulfill({ contentType: 'application/json', body: sample(name) }));
  }
  await page.route(`${browser.address}no-such.json`, (route) => route.fulfill({ status: 404, body: '' }));
  await page.goto(`${browser.address}course.html`);
  return { page, problems };
}

const planned = (page, selector = 'synthetica-linkage') =>
  page.waitForFunction((one) => [...document.querySelectorAll(one)].every((element) => element.trajectory !== null && element.trajectory !== undefined), selector);

test('takes its document from an address, from its content, from a property and by type: the same motion', async () => {
  const { page, problems } = await course(`
    <synthetica-linkage id="src" src="2tpr.json"></synthetica-linkage>
    <synthetica-linkage id="inside"><script type="application/json">${sample('2tpr')}</script></synthetica-linkage>
    <synthetica-linkage id="property"></synthetica-linkage>
    <synthetica-linkage id="type" type="2TPR"></synthetica-linkage>`);
  await page.evaluate((text) => {
    document.querySelector('#property').document = JSON.parse(text);
  }, sample('2tpr'));
  await planned(page);
  const joints = await page.evaluate(() => [...document.querySelectorAll('synthetica-linkage')].map(({ trajectory }) => [...trajectory.joints].join()));
  assert.equal(joints.length, 4);
  assert.ok(joints[0].length > 1000);
  for (const one of joints) assert.equal(one, joints[0]);
  assert.equal(await page.evaluate(() => document.querySelector('#src').document.chains.length), 2);
  assert.deepEqual(problems, []);
});

test('makes what a maker makes, in given sizes', async () => {
  const { page, problems } = await course('<synthetica-linkage type="delta?base=400&amp;platform=50&amp;arms=300,580&amp;unit=mm"></synthetica-linkage>');
  await page.waitForFunction(() => document.querySelector('synthetica-linkage').trajectory);
  const made = await page.evaluate(() => {
    const { document: doc, trajectory } = document.querySelector('synthetica-linkage');
    return [doc.parameters.base, doc.parameters.lower, doc.length_unit, trajectory.report.mobility_rank, Math.max(...trajectory.closure) <= 1e-10];
  });
  assert.deepEqual(made, [400, 580, 'mm', 3, true]);
  assert.deepEqual(problems, []);
});

test('makes a linkage of any type', async () => {
  const { page, problems } = await course(['3RRS', 'rps + 2ts', 'RPRRR'].map((type) => `<synthetica-linkage type="${type}"></synthetica-linkage>`).join(''));
  await planned(page);
  const made = await page.evaluate(() =>
    [...document.querySelectorAll('synthetica-linkage')].map(({ trajectory: { report, closure } }) => [report.chains.map(({ type }) => type).join(), Math.max(...closure) <= 1e-10]),
  );
  assert.deepEqual(made, [['RRS,RRS,RRS', true], ['RPS,TS,TS', true], ['RPRRR', true]]);
  assert.deepEqual(problems, []);
});

test('a property that was set before the element was defined holds', async () => {
  const { page } = await course('<synthetica-linkage controls></synthetica-linkage>', { script: false });
  await page.evaluate((text) => {
    Object.assign(document.querySelector('synthetica-linkage'), { document: text, bounce: true });
  }, sample('bennett'));
  await page.addScriptTag({ type: 'module', url: './element.js' });
  await planned(page);
  assert.equal(await page.getAttribute('synthetica-linkage', 'bounce'), '');
});

test('attributes and properties go both ways, and follow what the reader does', async () => {
  const { page } = await course('<synthetica-linkage src="2tpr.json" controls bounce speed="0.5" frame="10" view="top"></synthetica-linkage>');
  await planned(page);
  const state = () =>
    page.evaluate(() => {
      const { loop, bounce, speed, frame, view, controls, src } = document.querySelector('synthetica-linkage');
      return { loop, bounce, speed, frame, view, controls, src };
    });
  assert.deepEqual(await state(), { loop: false, bounce: true, speed: 0.5, frame: 10, view: 'top', controls: true, src: '2tpr.json' });
  await page.evaluate(() => Object.assign(document.querySelector('synthetica-linkage'), { loop: true, bounce: false, speed: 3, frame: 20, view: 'front', controls: false, theme: 'dark', panels: 'info' }));
  const attributes = (...names) => page.evaluate((all) => all.map((name) => document.querySelector('synthetica-linkage').getAttribute(name)), names);
  assert.deepEqual(await attributes('loop', 'bounce', 'speed', 'frame', 'view', 'controls', 'theme', 'panels'), ['', null, '3', '20', 'front', null, 'dark', 'info']);
  await page.evaluate(() => Object.assign(document.querySelector('synthetica-linkage'), { controls: true, panels: '' }));
  await page.locator('#loop').selectOption('once');
  await page.locator('#speed').selectOption('2');
  await page.locator('#scrub').fill('7');
  assert.deepEqual(await attributes('loop', 'speed', 'frame'), [null, '2', '7']);
  await page.getByRole('button', { name: 'Views' }).click();
  await page.getByRole('menuitem', { name: 'Left' }).click();
  assert.deepEqual(await attributes('view'), ['left']);
  await page.locator('#canvas').focus();
  await page.keyboard.press('ArrowLeft');
  assert.deepEqual(await attributes('view'), [null], 'turned by hand it is no standard view');
});

test('speaks the media element’s words, and tells what happens', async () => {
  const { page } = await course(
    `<script>addEventListener('DOMContentLoaded', () => {
      window.told = [];
      for (const name of ['ready', 'play', 'pause', 'framechange', 'input', 'change', 'error'])
        document.querySelector('synthetica-linkage').addEventListener(name, (event) => told.push([name, event.detail?.frame]));
    })</script><synthetica-linkage src="2tpr.json" controls panels="mechanism"></synthetica-linkage>`,
  );
  await planned(page);
  const told = () => page.evaluate(() => window.told.splice(0).map(([name]) => name));
  assert.deepEqual(await told(), ['ready']);
  const one = (act) => page.evaluate(act);
  assert.equal(await one(() => document.querySelector('synthetica-linkage').paused), true);
  assert.ok((await one(() => document.querySelector('synthetica-linkage').duration)) > 0);
  await one(() => document.querySelector('synthetica-linkage').play());
  await page.waitForFunction(() => document.querySelector('synthetica-linkage').frame > 2);
  await one(() => document.querySelector('synthetica-linkage').pause());
  const played = await told();
  assert.deepEqual([played[0], played.at(-1)], ['play', 'pause']);
  assert.ok(played.includes('framechange'));
  await one(() => {
    const element = document.querySelector('synthetica-linkage');
    element.currentTime = element.duration / 2;
  });
  assert.equal(await one(() => document.querySelector('synthetica-linkage').frame), 64);
  await told();
  const cell = page.locator('[data-path="chains[0].base.x"]');
  await cell.fill('0.1');
  await cell.blur();
  await page.waitForFunction(() => window.told.some(([name]) => name === 'change'));
  assert.deepEqual((await told()).filter((name) => name !== 'framechange'), ['input', 'change']);
  assert.equal(await one(() => document.querySelector('synthetica-linkage').document.chains[0].base.x), 0.1);
});

test('gives the motion as a table and the view as a picture', async () => {
  const { page } = await course('<synthetica-linkage src="2tpr.json"></synthetica-linkage>');
  await planned(page);
  const made = await page.evaluate(async () => {
    const element = document.querySelector('synthetica-linkage');
    const [csv, png, svg] = await Promise.all([element.toCSV(), element.toImage({ width: 320, height: 200, scale: 1 }), element.toImage({ type: 'svg' })]);
    const bitmap = await createImageBitmap(png);
    const pen = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
    pen.drawImage(bitmap, 0, 0);
    window.colours = new Set(new Uint32Array(pen.getImageData(0, 0, bitmap.width, bitmap.height).data.buffer)).size;
    return { lines: csv.trim().split('\n').length, type: png.type, size: [bitmap.width, bitmap.height], svg: (await svg.text()).slice(0, 4) };
  });
  assert.deepEqual(made, { lines: 130, type: 'image/png', size: [320, 200], svg: '<svg' });
  assert.ok((await page.evaluate(() => window.colours)) > 200, 'a linkage is in it');
  const heads = await page.evaluate(async () => {
    const element = document.querySelector('synthetica-linkage');
    const head = async (options) => (await element.toCSV(options)).split('\n').slice(0, 2).map((line) => line.split(',').slice(2, 4).join());
    return [await head(), await head({}), await head({ headings: 'plain' }), await head({ headings: 'two-rows' }), await element.toCSV({ headings: 'none' }).catch(({ message }) => message), await element.toCSV({ gravity: true }).catch(({ message }) => message)];
  });
  assert.deepEqual(heads.slice(0, 4).map(([first, second]) => [first, second.split(',')[1] === 'm' ? second : '']), [['status,x[m]', ''], ['status,x[m]', ''], ['status,x', ''], ['status,x', ',m']]);
  assert.match(heads[4], /none.*Accepted: .*units, plain, two-rows/);
  assert.match(heads[5], /Accepted: gravity with the format mjcf/);
});

test('a picture of no size is refused in words', async () => {
  const { page } = await course('<synthetica-linkage src="2tpr.json"></synthetica-linkage>');
  await planned(page);
  const told = await page.evaluate(() => {
    const element = document.querySelector('synthetica-linkage');
    const wishes = [{ width: 0 }, { height: -5 }, { scale: NaN }, { width: 'wide', type: 'svg' }, { height: Infinity, type: 'svg' }];
    return Promise.all(wishes.map((wish) => element.toImage(wish).then(({ type }) => type, ({ message }) => message)));
  });
  assert.deepEqual(told, [['width', '0'], ['height', '-5'], ['scale', 'NaN'], ['width', 'wide'], ['height', 'Infinity']].map(([name, value]) => `The ${name} of a picture is “${value}”. Accepted: a number above zero.`));
});

test('ten on a page share one worker and one planner, and all move', async () => {
  /** What was asked for before the page was there is counted too. @type {string[]} */
  const wasm = [];
  const { page, problems } = await course('<synthetica-linkage src="bennett.json" autoplay loop style="width: 180px; height: 90px; float: left"></synthetica-linkage>'.repeat(10), {
    reducedMotion: 'no-preference',
    asked: (url) => url.endsWith('.wasm') && wasm.push(url),
  });
  await planned(page);
  assert.equal(page.workers().length, 1);
  await page.waitForFunction(() => [...document.querySelectorAll('synthetica-linkage')].every(({ frame }) => frame > 0));
  assert.equal(wasm.length, 1, `one planner is loaded: ${wasm}`);
  assert.deepEqual(problems, []);
});

/** How many colours a picture has. @param {Buffer} bytes a PNG file */
const coloursOf = (page, bytes) =>
  page.evaluate(async (base64) => {
    const bitmap = await createImageBitmap(await (await fetch(`data:image/png;base64,${base64}`)).blob());
    const pen = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
    pen.drawImage(bitmap, 0, 0);
    return new Set(new Uint32Array(pen.getImageData(0, 0, bitmap.width, bitmap.height).data.buffer)).size;
  }, bytes.toString('base64'));

test('out of sight nothing is drawn, and the last picture stays; in sight it goes on', async () => {
  const { page, problems } = await course('<synthetica-linkage src="bennett.json" autoplay loop style="height: 300px; margin-bottom: 500px"></synthetica-linkage>'.repeat(20), {
    reducedMotion: 'no-preference',
  });
  await planned(page);
  await page.waitForFunction(() => document.querySelector('synthetica-linkage').frame > 0);
  assert.equal(await page.evaluate(() => document.querySelectorAll('synthetica-linkage')[5].frame), 0, 'what is not seen rests');
  for (let index = 0; index < 20; index++) {
    await page.evaluate((at) => document.querySelectorAll('synthetica-linkage')[at].scrollIntoView(), index);
    await page.waitForFunction((at) => document.querySelectorAll('synthetica-linkage')[at].frame > 0, index);
  }
  const first = () =>
    page.evaluate(() => {
      const canvas = document.querySelector('synthetica-linkage').shadowRoot.querySelector('#canvas');
      const pen = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d');
      pen.drawImage(canvas, 0, 0);
      return { draws: Number(canvas.dataset.draws), colours: new Set(new Uint32Array(pen.getImageData(0, 0, canvas.width, canvas.height).data.buffer)).size };
    });
  const rested = await first();
  assert.ok(rested.colours > 100, 'its last picture stands there');
  // The last one goes on meanwhile.
  const { frame } = await page.evaluate(() => ({ frame: document.querySelectorAll('synthetica-linkage')[19].frame }));
  await page.waitForFunction((old) => document.querySelectorAll('synthetica-linkage')[19].frame !== old, frame);
  assert.equal((await first()).draws, rested.draws);
  await page.evaluate(() => scrollTo(0, 0));
  await page.waitForFunction((old) => document.querySelector('synthetica-linkage').shadowRoot.querySelector('#canvas').dataset.draws > old + 2, rested.draws);
  const picture = await page.locator('synthetica-linkage').first().screenshot();
  assert.ok((await coloursOf(page, picture)) > 100, 'there is a picture');
  assert.deepEqual(problems, []);
});

test('taken out and put back it goes on where it was; moved within the page too', async () => {
  const { page, problems } = await course('<div id="here"><synthetica-linkage src="2tpr.json" controls panels="mechanism"></synthetica-linkage></div><div id="there"></div>');
  await planned(page);
  await page.locator('[data-path="chains[0].base.x"]').fill('0.1');
  await page.locator('#scrub').fill('40');
  await page.evaluate(() => {
    window.element = document.querySelector('synthetica-linkage');
    element.remove();
  });
  await page.waitForFunction(() => element.shadowRoot.childElementCount === 0);
  await page.evaluate(() => document.querySelector('#there').append(element));
  await page.waitForFunction(() => element.shadowRoot.querySelector('#canvas')?.dataset.draws > 0);
  assert.equal(await page.locator('#scrub').inputValue(), '40');
  assert.equal(await page.locator('[data-path="chains[0].base.x"]').inputValue(), '0.1');
  const canvas = await page.evaluateHandle(() => element.shadowRoot.querySelector('#canvas'));
  await page.evaluate(() => document.querySelector('#here').append(element));
  assert.ok(await page.evaluate((old) => element.shadowRoot.querySelector('#canvas') === old, canvas), 'a move keeps what is seen');
  await page.locator('#scrub').fill('41');
  assert.equal(await page.evaluate(() => element.frame), 41);
  await page.keyboard.press('Control+z');
  assert.equal(await page.locator('[data-path="chains[0].base.x"]').inputValue(), '-1', 'undo remembers');
  // A document that is on its way into the element when that is taken out is opened when it is put back.
  const opened = await page.evaluate(async (text) => {
    const fresh = document.createElement('synthetica-linkage');
    document.querySelector('#here').append(fresh);
    fresh.document = text;
    fresh.remove();
    await new Promise((turn) => setTimeout(turn));
    const meanwhile = [fresh.document, fresh.error];
    document.querySelector('#here').append(fresh);
    await new Promise((resolve) => fresh.addEventListener('ready', resolve, { once: true }));
    return [...meanwhile, fresh.trajectory.frames];
  }, sample('bennett'));
  assert.deepEqual(opened, [null, null, 65]);
  assert.deepEqual(problems, []);
});

test('a document that arrives late does not take the place of a newer one, nor does what is wrong with it', async () => {
  const { page, problems } = await course('<synthetica-linkage src="2tpr.json"></synthetica-linkage>');
  await planned(page);
  let arrive;
  const late = new Promise((resolve) => (arrive = resolve));
  for (const [name, text] of [['late', sample('3rps')], ['faulty', '{']]) {
    await page.route(`${browser.address}${name}.json`, async (route) => {
      await late;
      await route.fulfill({ contentType: 'application/json', body: text });
    });
  }
  await page.evaluate(() => {
    const element = document.querySelector('synthetica-linkage');
    window.names = [];
    window.errors = [];
    element.parts.store.subscribe('document', () => names.push(element.document.name));
    element.addEventListener('error', ({ detail }) => errors.push(detail.message));
    element.src = 'late.json';
    element.src = 'faulty.json';
    element.src = 'bennett.json';
  });
  await page.waitForFunction(() => window.names.length > 0);
  const arrived = Promise.all(['late', 'faulty'].map((name) => page.waitForResponse(`${browser.address}${name}.json`).then((answer) => answer.finished())));
  arrive();
  await arrived;
  // The second is asked about after the first was answered.
  const { name, other } = await page.evaluate(async () => {
    const element = document.querySelector('synthetica-linkage');
    const { name, ...given } = element.document;
    element.document = '{';
    element.document = { ...given, name: 'first' };
    element.document = { ...given, name: 'second' };
    await new Promise((resolve) => element.addEventListener('ready', resolve, { once: true }));
    // One more answer of the planner: all that was asked before is answered.
    await element.toCSV();
    return { name, other: element.document.name };
  });
  assert.deepEqual(await page.evaluate(() => [names, errors]), [[name, 'second'], []]);
  assert.equal(other, 'second');
  assert.deepEqual(problems, []);
});

test('what was taken out for good is forgotten: no listener keeps it', async () => {
  const { page } = await course('<div id="here"></div>', { viewport: { width: 1000, height: 1100 } });
  const left = await page.evaluate(async () => {
    await customElements.whenDefined('synthetica-linkage');
    const until = async (holds) => {
      for (let tries = 0; !holds(); tries++) {
        if (tries > 400) throw new Error(`never: ${holds}`);
        await new Promise((next) => setTimeout(next, 50));
      }
    };
    const old = [];
    for (let k = 0; k < 6; k++) {
      const element = document.createElement('synthetica-linkage');
      Object.assign(element, { type: 'Bennett', controls: true, panels: 'mechanism charts algorithm' });
      element.style.height = '900px';
      document.querySelector('#here').append(element);
      await until(() => element.shadowRoot.querySelector('.uplot') && element.shadowRoot.querySelector('#canvas').dataset.draws > 0);
      // What moves things by hand is there too.
      element.shadowRoot.querySelector('#canvas').focus();
      await until(() => element.shadowRoot.querySelector('.hand-labels'));
      old.push(new WeakRef(element));
      element.remove();
    }
    for (let round = 0; round < 25 && old.some((one) => one.deref()); round++) {
      await new Promise((next) => setTimeout(next, 200));
      globalThis.gc();
    }
    return old.flatMap((one, index) => (one.deref() ? [index] : []));
  });
  assert.deepEqual(left, [], 'which of the six are still there');
});

test('two never clash: keys, edits, selection, ids', async () => {
  const { page } = await course('<synthetica-linkage src="2tpr.json" controls panels="mechanism motion info" style="height: 400px"></synthetica-linkage>'.repeat(2));
  await planned(page);
  const [one, two] = [page.locator('synthetica-linkage').nth(0), page.locator('synthetica-linkage').nth(1)];
  // Panels come after the motion, and all that keys do with them.
  for (const element of [one, two]) await element.getByRole('tab', { name: 'Motion', exact: true }).waitFor();
  await two.locator('#scrub').focus();
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press(' ');
  await page.waitForFunction(() => !document.querySelectorAll('synthetica-linkage')[1].paused);
  const states = () => page.evaluate(() => [...document.querySelectorAll('synthetica-linkage')].map(({ frame, paused, document: { chains } }) => [frame > 0, paused, chains[0].base.x]));
  assert.deepEqual(await states(), [[false, true, -1], [true, false, -1]]);
  await two.evaluate((element) => element.pause());
  await two.getByRole('tab', { name: 'Motion', exact: true }).click();
  await two.locator('[data-path="motion.key_frames[0].name"]').focus();
  assert.equal(await one.locator('.chosen').count(), 0);
  assert.ok((await two.locator('.chosen').count()) > 0);
  assert.equal(await one.getByRole('tab', { name: 'Mechanism' }).getAttribute('aria-selected'), 'true');
  await one.locator('[data-path="chains[0].base.x"]').fill('0.2');
  await page.keyboard.press('Enter');
  await two.locator('#canvas').focus();
  await page.keyboard.press('Control+z');
  assert.equal((await states())[0][2], 0.2, 'the other’s undo leaves it alone');
});

test('what is wrong is said in the element and told: address, type, document, attribute, nothing', async () => {
  const { page } = await course(`
    <synthetica-linkage id="gone" src="no-such.json"></synthetica-linkage>
    <synthetica-linkage id="type" type="9XYZ"></synthetica-linkage>
    <synthetica-linkage id="fault"><script type="application/json">{"version": 1, "chains": [], "motion": {"key_frames": []}}</script></synthetica-linkage>
    <synthetica-linkage id="speed" src="2tpr.json" speed="fast"></synthetica-linkage>
    <synthetica-linkage id="nothing"></synthetica-linkage>
    <synthetica-linkage id="address" src="http://"></synthetica-linkage>
    <synthetica-linkage id="panels" src="2tpr.json" controls panels="info tables"></synthetica-linkage>
    <synthetica-linkage id="frame" src="2tpr.json" controls frame="999"></synthetica-linkage>
    <synthetica-linkage id="good" src="2tpr.json"></synthetica-linkage>`);
  await planned(page, '#good');
  await page.waitForFunction(() => ['gone', 'type', 'fault', 'speed', 'nothing', 'address', 'panels', 'frame'].every((id) => document.getElementById(id).error));
  const errors = await page.evaluate(() => Object.fromEntries(['gone', 'type', 'fault', 'nothing', 'address', 'panels', 'frame', 'good'].map((id) => [id, document.getElementById(id).error])));
  assert.match(errors.gone.message, /no-such\.json could not be loaded \(404.*Accepted/);
  assert.match(errors.type.message, /“9XYZ” is no type of linkage.*RPS \+ 2TS/);
  assert.match(errors.address.message, /“http:\/\/” is no address/);
  assert.equal(errors.fault.where, 'chains');
  assert.match(errors.nothing.message, /No linkage is given.*src/);
  assert.match(errors.panels.message, /panels is “tables”.*mechanism/);
  assert.match(errors.frame.message, /frame is “999”.*0 to 128/);
  assert.equal(errors.good, null);
  // A refused attribute costs nothing else.
  for (const id of ['panels', 'frame']) {
    await page.locator(`synthetica-linkage#${id}`).scrollIntoViewIfNeeded();
    await page.locator(`synthetica-linkage#${id} #frame-number`, { hasText: '1 / 129' }).waitFor();
    await page.locator(`synthetica-linkage#${id} #notices`, { hasText: `The attribute ${id} is` }).waitFor();
  }
  for (const [id, words] of [['gone', 'could not be loaded'], ['fault', 'chains']]) {
    await page.locator(`synthetica-linkage#${id}`).scrollIntoViewIfNeeded();
    await page.locator(`synthetica-linkage#${id} .banner`).filter({ hasText: words }).waitFor();
  }
});

test('its content is there to be read where no script runs', async () => {
  const body = '<p id="script">No script</p><script>document.querySelector("#script").textContent = "A script"</script><synthetica-linkage src="2tpr.json"><p>Two chains of three joints each.</p></synthetica-linkage>';
  const content = (page) => page.getByText('Two chains of three joints each.');
  const { page } = await course(body, { javaScriptEnabled: false });
  assert.ok(await content(page).isVisible());
  assert.equal(await page.locator('#script').textContent(), 'No script');
  // Where scripts run, the linkage stands there in place of its content.
  const { page: other } = await course(body);
  await planned(other);
  assert.equal(await other.locator('#script').textContent(), 'A script');
  await content(other).waitFor({ state: 'hidden' });
});

test('readonly: nothing can be edited, everything can be looked at', async () => {
  const { page } = await course('<synthetica-linkage src="2tpr.json" controls readonly panels="mechanism motion teach types info" style="height: 560px"></synthetica-linkage>');
  await planned(page);
  const field = page.locator('[data-path="chains[0].base.x"]');
  assert.equal(await field.getAttribute('readonly'), '');
  assert.ok(await page.locator('[data-path="chains[0].joints[0].type"]').isDisabled());
  assert.equal(await page.getByRole('button', { name: /^Actions of/ }).count(), 0);
  assert.equal(await page.getByRole('button', { name: '+ chain' }).count(), 0);
  await page.locator('#scrub').fill('30');
  await page.getByRole('tab', { name: 'Teach' }).click();
  await page.locator('.teach-row input[type=range]').first().press('ArrowRight');
  await page.locator('#frame-word').filter({ hasText: 'Driven' }).waitFor({ state: 'attached' });
  await page.evaluate(() => document.querySelector('synthetica-linkage').removeAttribute('readonly'));
  await page.locator('[data-path="chains[0].base.x"]').fill('0.1');
  assert.equal(await page.evaluate(() => document.querySelector('synthetica-linkage').document.chains[0].base.x), 0.1);
});

test('theme and colours: the page’s own scheme, a chosen one, and custom properties', async () => {
  const { page } = await course(
    `<synthetica-linkage id="own" src="2tpr.json" controls></synthetica-linkage>
     <synthetica-linkage id="dark" src="2tpr.json" controls theme="dark"></synthetica-linkage>
     <synthetica-linkage id="auto" src="2tpr.json" controls theme="auto"></synthetica-linkage>`,
    { head: '<style>#own { --accent: rgb(1, 2, 3); } #own::part(controls) { border-top-width: 7px; }</style>', colorScheme: 'dark' },
  );
  await planned(page);
  const look = (id) =>
    page.evaluate((one) => {
      const element = document.getElementById(one);
      const controls = getComputedStyle(element.shadowRoot.querySelector('.transport'));
      const play = element.shadowRoot.querySelector('#play');
      return { background: controls.backgroundColor, border: controls.borderTopWidth, play: getComputedStyle(play).backgroundColor };
    }, id);
  const [own, dark, auto] = await Promise.all(['own', 'dark', 'auto'].map(look));
  assert.deepEqual([own.play, own.border], ['rgb(1, 2, 3)', '7px']);
  assert.notEqual(own.background, dark.background, 'the page is light');
  assert.equal(auto.background, dark.background, 'the system is dark');
});

test('axe finds nothing in a page with elements, with and without panels', async () => {
  for (const colorScheme of ['light', 'dark']) {
    const { page } = await course(
      `<synthetica-linkage src="2tpr.json" controls theme="auto"></synthetica-linkage>
       <synthetica-linkage src="3rps.json" controls theme="auto" panels="mechanism info charts" style="height: 500px"></synthetica-linkage>`,
      { colorScheme, head: '<meta name="color-scheme" content="light dark">' },
    );
    await planned(page);
    await page.waitForFunction(() => [...document.querySelectorAll('synthetica-linkage')].at(-1).shadowRoot.querySelector('#closure')?.textContent !== '–');
    assert.deepEqual(await violations(page), [], colorScheme);
  }
});

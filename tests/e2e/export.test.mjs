// What the Export menu saves: every file is caught and read.
import assert from 'node:assert/strict';
import { mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { number, openBrowser, scrubTo, text } from './browser.mjs';

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

/** Chooses an item of the Export menu. */
async function choose(page, item) {
  await page.getByRole('button', { name: 'Export', exact: true }).click();
  await page.getByRole('menuitem', { name: item }).click();
}

/** What is saved when `act` is done: its name and its bytes. */
async function saved(page, act) {
  const [download] = await Promise.all([page.waitForEvent('download'), act()]);
  return { name: download.suggestedFilename(), bytes: await readFile(await download.path()) };
}

test('the table has the numbers that are shown', async () => {
  const { page, problems } = await browser.openPage();
  await scrubTo(page, 63);
  const { name, bytes } = await saved(page, () => choose(page, /^Table \(CSV\)/));
  assert.equal(name, '3rps.csv');
  const [headings, ...lines] = bytes.toString().trimEnd().split('\n').map((line) => line.split(','));
  assert.equal(lines.length, Number((await text(page, 'frame-number')).split(' / ')[1]));
  const at = (heading) => {
    assert.ok(headings.includes(heading), `${heading} among ${headings}`);
    return Number(lines[63][headings.indexOf(heading)]);
  };
  assert.ok(Math.abs(at('translation_gap[m]') - number(await text(page, 'gap-translation'))) < 1e-4);
  assert.ok(Math.abs(at('rotation_gap[deg]') - number(await text(page, 'gap-rotation'))) < 1e-2);
  assert.ok(at('chain1_theta1[deg]') > 3 && at('chain1_d2[m]') > 0, 'degrees and metres');
  assert.equal(at('frame'), 63, 'frames count from 0');
  for (const [item, rows] of /** @type {[RegExp, string[]][]} */ ([[/plain headings/, ['frame,time,status,x,', '0,0,']], [/second row/, ['frame,time,status,x,', ',,,m,', '0,0,']]])) {
    const table = (await saved(page, () => choose(page, item))).bytes.toString().split('\n');
    rows.forEach((row, i) => assert.ok(table[i].startsWith(row), table[i]));
  }
  assert.deepEqual(problems, []);
});

test('the data hold every frame and the document', async () => {
  const { page } = await browser.openPage();
  const { name, bytes } = await saved(page, () => choose(page, /JSON/));
  assert.equal(name, '3rps.motion.json');
  const motion = JSON.parse(bytes.toString());
  assert.equal(motion.frames, 129);
  assert.ok(motion.columns.length > 30 && motion.columns.every(({ values }) => values.length === 129));
  assert.equal(motion.document.chains.length, 3);
});

test('the MuJoCo model has every joint and closes the loops', async () => {
  const { page } = await browser.openPage();
  const { name, bytes } = await saved(page, () => choose(page, /^MuJoCo model \(MJCF\)/));
  assert.equal(name, '3rps.mjcf.xml');
  const counts = await page.evaluate((xml) => {
    const model = new DOMParser().parseFromString(xml, 'application/xml');
    return ['parsererror', 'joint[type]', 'weld', 'key', 'actuator > position', 'sensor > *'].map((query) => model.querySelectorAll(query).length);
  }, bytes.toString());
  assert.deepEqual(counts, [0, 15, 2, 129, 3, 4]);
  assert.match(bytes.toString(), /<option gravity="0 0 0"/);
  const heavy = await saved(page, () => choose(page, /with gravity/));
  assert.match(heavy.bytes.toString(), /<option gravity="0 0 -9.81"/);
});

/** The drawing that its dialog offers. */
async function drawn(page) {
  await choose(page, /SVG/);
  return saved(page, () => page.getByRole('button', { name: 'Save drawing' }).click());
}

/** Size of a picture, its share of clear pixels, and how many colours it has. */
const looked = (page, bytes) =>
  page.evaluate(async (base64) => {
    const data = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
    const bitmap = await createImageBitmap(new Blob([data]));
    const pen = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
    pen.drawImage(bitmap, 0, 0);
    const pixels = new Uint32Array(pen.getImageData(0, 0, bitmap.width, bitmap.height).data.buffer);
    const clear = pixels.filter((pixel) => pixel >>> 24 === 0).length / pixels.length;
    return { width: bitmap.width, height: bitmap.height, clear, colours: new Set(pixels).size };
  }, bytes.toString('base64'));

test('the picture has the size that was asked for, the linkage, and no background if so wished', async () => {
  const { page, problems } = await browser.openPage();
  const view = await page.locator('#canvas').evaluate((canvas) => [canvas.clientWidth, canvas.clientHeight, canvas.width]);
  await choose(page, /PNG/);
  const plain = await saved(page, () => page.getByRole('button', { name: 'Save picture' }).click());
  assert.equal(plain.name, '3rps.png');
  const first = await looked(page, plain.bytes);
  assert.deepEqual([first.width, first.height, first.clear], [2 * view[0], 2 * view[1], 0]);
  assert.ok(first.colours > 500, `${first.colours} colours`);

  await choose(page, /PNG/);
  await page.getByLabel('Size in pixels').selectOption({ label: 'Slide: 1920 × 1080' });
  await page.getByLabel('Background').selectOption('Clear');
  const slide = await saved(page, () => page.getByRole('button', { name: 'Save picture' }).click());
  const second = await looked(page, slide.bytes);
  assert.deepEqual([second.width, second.height], [1920, 1080]);
  assert.ok(second.clear > 0.3 && second.clear < 0.98, `${second.clear} clear`);
  assert.equal(await page.locator('#canvas').evaluate((canvas) => canvas.width), view[2], 'the view stays as it is');
  assert.deepEqual(problems, []);
});

/** A picture's pixels that are not its ground: the box around those above the legend, and whether a colour is in the legend's row. */
const inked = (page, bytes, [red, green, blue] = [-1, -1, -1]) =>
  page.evaluate(async ([base64, wanted]) => {
    const bitmap = await createImageBitmap(new Blob([Uint8Array.from(atob(base64), (c) => c.charCodeAt(0))]));
    const { width, height } = bitmap;
    const pen = new OffscreenCanvas(width, height).getContext('2d');
    pen.drawImage(bitmap, 0, 0);
    const { data } = pen.getImageData(0, 0, width, height);
    const foot = height - 80;
    let [left, right, top, bottom, found] = [1, 0, 1, 0, 0];
    for (let y = 0; y < height; y += 1) {
      for (let x = 0; x < width; x += 1) {
        const at = 4 * (y * width + x);
        const pixel = [data[at], data[at + 1], data[at + 2]];
        if (y > foot && pixel.every((value, i) => Math.abs(value - wanted[i]) < 12)) found += 1;
        // A shadow is grey and faint.
        if (y > foot || Math.max(...pixel) - Math.min(...pixel) < 40) continue;
        [left, right, top, bottom] = [Math.min(left, x / width), Math.max(right, x / width), Math.min(top, y / height), Math.max(bottom, y / height)];
      }
    }
    return { left, right, top, bottom, found, corner: [...data.slice(0, 4)] };
  }, [bytes.toString('base64'), [red, green, blue]]);

test('the picture has the whole linkage, on white in the light colours also in the dark scheme, with its legend, as the preview shows it', async () => {
  const { page, problems } = await browser.openPage({ colorScheme: 'dark' });
  // So near that the view does not show all of it.
  await page.locator('#canvas').focus();
  for (let i = 0; i < 8; i += 1) await page.keyboard.press('+');
  await choose(page, /PNG/);
  await page.getByLabel('Size in pixels').selectOption({ label: 'Slide: 1920 × 1080' });
  await page.getByLabel('Background').selectOption('White');
  await page.getByLabel('Names of key frames').uncheck();
  const preview = await page.locator('canvas.preview').evaluate((canvas) => ({ shape: canvas.width / canvas.height, label: canvas.getAttribute('aria-label'), pixel: [...canvas.getContext('2d').getImageData(2, 2, 1, 1).data] }));
  assert.ok(Math.abs(preview.shape - 1920 / 1080) < 0.02, `${preview.shape}`);
  assert.match(preview.label, /3 chains/);
  assert.deepEqual(preview.pixel, [255, 255, 255, 255]);
  const closest = await page.evaluate(() => {
    const probe = document.body.appendChild(Object.assign(document.createElement('i'), { style: 'color-scheme: light' }));
    const view = page$('#canvas').parentElement;
    view.append(probe);
    probe.style.color = 'var(--scene-closest)';
    const colour = getComputedStyle(probe).color.match(/\d+/g).map(Number);
    probe.remove();
    return colour;
  });
  const { bytes } = await saved(page, () => page.getByRole('button', { name: 'Save picture' }).click());
  const whole = await inked(page, bytes, closest);
  // --scene-gap-2 of the light scheme, see style/colours.css.
  const dashed = await inked(page, bytes, [0xb8, 0x34, 0x1f]);
  assert.ok(dashed.found > 20, `the legend's line of a large gap: ${dashed.found} pixels`);
  assert.deepEqual(whole.corner, [255, 255, 255, 255]);
  assert.ok(whole.found > 100, `the legend's line of the closest motion: ${whole.found} pixels`);
  assert.ok(whole.left > 0.03 && whole.right < 0.97 && whole.top > 0.03, JSON.stringify(whole));
  assert.ok(whole.bottom - whole.top > 0.6 || whole.right - whole.left > 0.8, JSON.stringify(whole));

  await choose(page, /PNG/);
  await page.getByLabel('Background').selectOption('White');
  await page.getByLabel('The whole linkage with its motions').uncheck();
  await page.getByRole('checkbox', { name: 'Legend' }).uncheck();
  const near = await inked(page, (await saved(page, () => page.getByRole('button', { name: 'Save picture' }).click())).bytes, closest);
  assert.ok(near.left < 0.01 || near.right > 0.99 || near.top < 0.01, `as the view, which is cut: ${JSON.stringify(near)}`);
  const dark = await page.evaluate(() => getComputedStyle(page$('#canvas').parentElement).colorScheme);
  assert.ok(!/^light$/.test(dark), 'the view has its own scheme again');
  assert.deepEqual(problems, []);
});

test('the saved page plays from a file, without a network', async () => {
  const { page } = await browser.openPage();
  const { name, bytes } = await saved(page, () => choose(page, /HTML/));
  assert.equal(name, '3rps.html');
  const folder = await mkdtemp(join(tmpdir(), 'synthetica-'));
  const file = join(folder, name);
  await writeFile(file, bytes);
  const address = String(pathToFileURL(file));
  for (const colorScheme of ['light', 'dark']) {
    const { page: alone, problems } = await browser.blankPage({ offline: true, colorScheme });
    const requests = [];
    alone.on('request', (request) => requests.push(request.url()));
    await alone.goto(address);
    const status = alone.locator('#status');
    await status.filter({ hasText: 'Reached' }).waitFor();
    assert.equal(await alone.title(), '3RPS – Synthetica');
    assert.equal(await alone.locator('#frame-number').textContent(), '1 / 129');
    await alone.keyboard.press('Space');
    await alone.waitForFunction(() => Number(page$('#scrub').value) > 3);
    await alone.getByRole('button', { name: 'Pause' }).click();
    await alone.locator('#scrub').fill('63');
    assert.match(await status.textContent(), /Closest: 0\.1\d+ m and 12\.\d+° from the goal/);
    const canvas = alone.locator('#canvas');
    const drawn = () => alone.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
    await drawn();
    const before = await canvas.screenshot();
    assert.ok((await looked(page, before)).colours > 200, 'the linkage is drawn');
    await canvas.focus();
    await alone.keyboard.press('ArrowLeft');
    await drawn();
    assert.notDeepEqual(await canvas.screenshot(), before, 'the view turns');
    assert.deepEqual(requests, [address]);
    assert.deepEqual(problems, [`asks for ${address}`]);
    await alone.context().close();
  }
  await rm(folder, { recursive: true });
});

/** A name that would be markup, end an element, or be a part of an attribute, if it were not escaped. */
const AWKWARD = `</title></text><script>document.title = "run"</script> & "quoted" <b>`;

/** The applet's linkage with that name, and the same for its first key frame. */
async function pageOfAwkwardNames() {
  const { page, problems } = await browser.openPage();
  await page.evaluate((name) => {
    const { store } = document.querySelector('#linkage').parts;
    store.edit((doc) => ({ ...doc, name, motion: { ...doc.motion, key_frames: doc.motion.key_frames.map((key, at) => (at ? key : { ...key, name })) } }));
  }, AWKWARD);
  await page.waitForFunction(() => document.querySelector('#linkage').parts.store.result.doc === document.querySelector('#linkage').parts.store.doc);
  return { page, problems };
}

test('names stand in the drawing as they are, whatever signs are in them', async () => {
  const { page, problems } = await pageOfAwkwardNames();
  const { bytes } = await drawn(page);
  const found = await page.evaluate((xml) => {
    const drawing = new DOMParser().parseFromString(xml, 'image/svg+xml');
    const texts = (query) => [...drawing.querySelectorAll(query)].map((node) => node.textContent);
    return { bad: texts('parsererror, script, b'), title: texts('title'), description: texts('desc')[0], names: texts('#names text'), children: drawing.querySelectorAll('title *, desc *, text *').length };
  }, bytes.toString());
  assert.deepEqual([found.bad, found.title, found.children], [[], [AWKWARD], 0]);
  assert.ok(found.names.includes(AWKWARD), `${found.names}`);
  assert.ok(found.description.startsWith(`${AWKWARD}: 3 chains`), found.description);
  assert.deepEqual(problems, []);
});

/** Opens a saved page from a file, without a network. */
async function opened(bytes, options) {
  const folder = await mkdtemp(join(tmpdir(), 'synthetica-'));
  const file = join(folder, 'saved.html');
  await writeFile(file, bytes);
  const { page, problems } = await browser.blankPage({ offline: true, ...options });
  const address = String(pathToFileURL(file));
  await page.goto(address);
  return { page, problems, address, leave: async () => { await page.context().close(); await rm(folder, { recursive: true }); } };
}

test('the saved page has its names as they are, and runs its one script, wears its one style and loads nothing', async () => {
  const { page } = await pageOfAwkwardNames();
  const { bytes } = await saved(page, () => choose(page, /HTML/));
  const { page: alone, leave } = await opened(bytes);
  await alone.locator('#status').filter({ hasText: 'Reached' }).waitFor();
  assert.equal(await alone.title(), `${AWKWARD} – Synthetica`);
  assert.equal(await alone.locator('h1').textContent(), AWKWARD);
  assert.equal(await alone.locator('script').count(), 2, 'the motion, and what plays it');

  const policy = await alone.locator('meta[http-equiv="Content-Security-Policy"]').getAttribute('content');
  const rules = Object.fromEntries(policy.split(';').map((rule) => rule.trim().split(/ (.*)/)));
  const hash = /^'sha256-[\w+/]{43}='$/;
  assert.deepEqual(Object.keys(rules).sort(), ['base-uri', 'default-src', 'form-action', 'script-src', 'style-src']);
  assert.deepEqual([rules['default-src'], rules['base-uri'], rules['form-action']], ["'none'", "'none'", "'none'"]);
  assert.match(rules['script-src'], hash);
  assert.match(rules['style-src'], hash);

  // What the policy forbids is tried where it holds, and where it does not: there it works.
  const tried = (where) =>
    where.evaluate(async () => {
      const script = Object.assign(document.createElement('script'), { textContent: 'window.ran = true' });
      const style = Object.assign(document.createElement('style'), { textContent: 'body { outline: 7px solid red }' });
      document.body.append(script, style);
      const image = new Image();
      image.src = 'data:image/gif;base64,R0lGODlhAQABAAAAACwAAAAAAQABAAA=';
      const loaded = await image.decode().then(() => true, () => false);
      const fetched = await fetch('data:text/plain,x').then(() => true, () => false);
      return { ran: window.ran === true, worn: getComputedStyle(document.body).outlineWidth === '7px', loaded, fetched };
    });
  assert.deepEqual(await tried(alone), { ran: false, worn: false, loaded: false, fetched: false });
  await leave();
  const { page: free, leave: leaveFree } = await opened('<!doctype html><title>Without a policy</title><body>');
  assert.deepEqual(await tried(free), { ran: true, worn: true, loaded: true, fetched: true });
  await leaveFree();
});

/** The applet with its first motion, in a browser that lacks or has something else: `change` is run before its scripts. */
async function pageWith(change) {
  const { page, problems } = await browser.blankPage();
  await page.addInitScript(change);
  await page.goto(browser.address);
  await page.waitForFunction(() => (page$('#closure')?.textContent ?? '–') !== '–');
  return { page, problems };
}

/** A film as a <video> plays it: size, length, at each share of it how many values differ from the first picture, and the colour of a pixel. */
async function watched(bytes, shares, [x, y]) {
  // The page's own policy has no room for films.
  const { page: cinema } = await browser.blankPage();
  const seen = await cinema.evaluate(async ([base64, times, at]) => {
    const data = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
    const video = Object.assign(document.createElement('video'), { src: URL.createObjectURL(new Blob([data], { type: 'video/webm' })), muted: true });
    const comes = (event) => new Promise((done, fail) => {
      video.addEventListener(event, done, { once: true });
      video.addEventListener('error', () => fail(new Error(video.error.message)), { once: true });
    });
    await comes('loadeddata');
    const { duration, videoWidth: width, videoHeight: height } = video;
    const pen = new OffscreenCanvas(width, height).getContext('2d');
    const changed = (one, other) => one.reduce((sum, value, index) => sum + (Math.abs(value - other[index]) > 40), 0);
    // On a loaded machine the picture comes after the event: it is waited for, while there is none or still the one before.
    const pictureAt = async (time, before) => {
      video.currentTime = time;
      await comes('seeked');
      for (let tries = 0; ; tries++) {
        pen.drawImage(video, 0, 0);
        const { data } = pen.getImageData(0, 0, width, height);
        if (tries === 50 || (before ? changed(before, data) > 0 : data[3] > 0)) return data;
        await new Promise((next) => setTimeout(next, 50));
      }
    };
    const first = await pictureAt(0.01);
    const pixel = [...pen.getImageData(...at, 1, 1).data];
    const changes = [];
    let later = first;
    for (const share of times) {
      later = await pictureAt(share * duration, later);
      changes.push(changed(first, later));
    }
    return { duration, width, height, changes, pixel };
  }, [bytes.toString('base64'), shares, [x, y]]);
  await cinema.context().close();
  return seen;
}

for (const [how, change] of [
  ['picture by picture', () => delete globalThis.MediaRecorder],
  ['recorded, where pictures cannot be encoded one by one', () => delete globalThis.VideoEncoder],
  ['recorded, where there is no codec for WebM', () => (VideoEncoder.isConfigSupported = async (config) => ({ supported: false, config }))],
]) {
  test(`the film has the motion, its length, the view's size and the legend: ${how}`, async () => {
    const { page, problems } = await pageWith(change);
    // So wide that the legend is one row.
    await page.setViewportSize({ width: 1500, height: 800 });
    await page.selectOption('#speed', '4');
    await scrubTo(page, 20);
    const { name, bytes } = await saved(page, () => choose(page, /WebM/));
    assert.equal(name, '3rps.webm');
    await page.locator('dialog').waitFor({ state: 'detached' });
    assert.match(await text(page, 'frame-number'), /^21 \//, 'the playhead is where it was');
    assert.deepEqual(problems, []);

    const view = await page.locator('#canvas').evaluate((canvas) => [canvas.clientWidth, canvas.clientHeight]);
    // The sample of the line of “closest motion”, the second in the row at the foot; the film may be a pixel lower, for an even height.
    const line = await page.evaluate(() => {
      const pen = new OffscreenCanvas(1, 1).getContext('2d');
      const view = page$('.view');
      pen.font = `11.5px ${getComputedStyle(page$('#canvas').parentElement).fontFamily}`;
      const probe = view.appendChild(Object.assign(document.createElement('i'), { style: 'color: var(--scene-closest)' }));
      const colour = getComputedStyle(probe).color.match(/\d+/g).map(Number);
      probe.remove();
      return { at: [Math.round(8 + 7 + 20 + 5 + pen.measureText('goal motion').width + 12 + 10), page$('#canvas').clientHeight - 8 - 3 - 9 - 1], colour };
    });
    const seen = await watched(bytes, [0.25, 0.5, 0.75, 0.999], line.at);
    // Without times a motion takes five seconds, here at four times its speed.
    assert.ok(Math.abs(seen.duration - 5 / 4) <= 0.05 * (5 / 4), `${seen.duration} s`);
    assert.ok(Math.abs(seen.width - view[0]) < 2 && Math.abs(seen.height - view[1]) < 2, `${seen.width} × ${seen.height}`);
    assert.ok(seen.changes[3] > 500, `${seen.changes} values change`);
    // What is recorded loses pictures where the machine has other things to do.
    if (how === 'picture by picture') assert.equal(new Set(seen.changes).size, 4, `${seen.changes} values change`);
    assert.ok(line.colour.every((value, index) => Math.abs(value - seen.pixel[index]) < 40), `${seen.pixel} where the legend has ${line.colour}`);
  });
}

test('the library that writes films is loaded for a film only, and its licence is there to be read', async () => {
  const { page, problems } = await browser.openPage();
  const scripts = [];
  page.on('request', (request) => scripts.push(request.url()));
  await choose(page, /WebM/);
  await page.getByRole('dialog', { name: 'Making the film' }).waitFor();
  assert.ok(scripts.some((url) => /\/film-[\w-]+\.js$/.test(url)), `${scripts}`);
  assert.deepEqual(problems, []);
  const others = await (await fetch(`${browser.address}licences.txt`)).text();
  assert.match(others, /^mediabunny \S+\n\nMozilla Public License Version 2\.0/m);
});

test('a film without pictures is not saved, and the page says why', async () => {
  const { page, problems } = await pageWith(() => {
    delete globalThis.VideoEncoder;
    // As a browser does that has no room for a codec: a head, and nothing after it.
    globalThis.MediaRecorder = class extends EventTarget {
      static isTypeSupported = () => true;
      state = 'inactive';
      start = () => (this.state = 'recording');
      pause = () => (this.state = 'paused');
      resume = this.start;
      stop = () => {
        this.state = 'inactive';
        this.dispatchEvent(Object.assign(new Event('dataavailable'), { data: new Blob([new Uint8Array(110)]) }));
        this.dispatchEvent(new Event('stop'));
      };
    };
  });
  page.on('download', () => problems.push('a film was saved'));
  await page.selectOption('#speed', '4');
  await choose(page, /WebM/);
  await page.locator('#notices').filter({ hasText: 'could not be made (the browser made a file of 110 bytes that is no film)' }).waitFor();
  await page.locator('dialog').waitFor({ state: 'detached' });
  assert.deepEqual(problems.filter((problem) => !problem.includes('110 bytes')), []);
});

test('a film that is cancelled leaves nothing behind', async () => {
  const { page, problems } = await browser.openPage();
  await scrubTo(page, 20);
  await page.selectOption('#speed', '0.25');
  page.on('download', () => problems.push('a film was saved'));
  await choose(page, /WebM/);
  await page.waitForFunction(() => page$('dialog progress')?.value > 0.05);
  await page.getByRole('button', { name: 'Cancel' }).click();
  await page.locator('#notices').filter({ hasText: 'cancelled' }).waitFor();
  assert.equal(await page.locator('dialog').count(), 0);
  assert.match(await text(page, 'frame-number'), /^21 \//);
  assert.deepEqual(problems, []);
});

test('a browser that cannot make films says so in the menu, also to the keyboard', async () => {
  const { page, problems } = await pageWith(() => {
    delete globalThis.MediaRecorder;
    delete globalThis.VideoEncoder;
  });
  page.on('download', () => problems.push('a film was saved'));
  await page.getByRole('button', { name: 'Export', exact: true }).click();
  const item = page.getByRole('menuitem', { name: /WebM/ });
  assert.ok(await item.isDisabled());
  assert.match(await item.textContent(), /can neither encode nor record/);
  await page.keyboard.press('f');
  assert.match(await page.evaluate(() => pageFocus().textContent), /^Film/);
  await page.keyboard.press('Enter');
  assert.ok(await item.isVisible(), 'the menu stays');
  assert.deepEqual(problems, []);
});

test('while the document is at fault, planned, or planned in part, the menu says that the motion is not its motion', async () => {
  const { page } = await browser.openPage();
  const button = page.getByRole('button', { name: 'Export', exact: true });
  /** What the menu says of each thing to save, and which can be saved. */
  const items = async () => {
    await button.click();
    await page.getByRole('menuitem').first().waitFor();
    const all = await page.getByRole('menuitem').evaluateAll((nodes) => nodes.map((node) => [node.firstChild.textContent, node.ariaDisabled !== 'true', node.querySelector('small').textContent]));
    await page.keyboard.press('Escape');
    return all;
  };
  const able = (all) => all.filter(([, can]) => can).map(([label]) => label.split(' ')[0]);
  assert.equal(able(await items()).length, 10);
  await page.locator('[data-path="chains[0].base.x"]').fill('far');
  await page.keyboard.press('Enter');
  await page.locator('#fault-banner').waitFor();
  const faulty = await items();
  assert.deepEqual(able(faulty), ['Picture', 'Drawing']);
  for (const [label, , hint] of faulty) assert.match(hint, /The document has a fault, and the motion that is shown is of an earlier one: mend it first/, label);
  await page.locator('[data-path="chains[0].base.x"]').focus();
  await page.keyboard.press('Escape');
  await page.locator('#fault-banner').waitFor({ state: 'hidden' });
  // A plan that takes long, and its stop. The last plan's motion is shown until then.
  await page.evaluate(() =>
    document.querySelector('#linkage').parts.store.edit((doc) => ({ ...doc, motion: { ...doc.motion, frames: 10_000 }, planner: { ...doc.planner, method: 'gradient' } })),
  );
  await page.locator('#planning-stop').waitFor();
  const planning = await items();
  assert.deepEqual(able(planning), ['Picture', 'Drawing']);
  for (const [label, , hint] of planning) assert.match(hint, /The document is still being planned, and the motion that is shown is of an earlier one/, label);
  await page.locator('#planning-stop').click();
  await page.locator('#planning-on').waitFor();
  const part = await items();
  assert.deepEqual(able(part), ['Picture', 'Drawing']);
  for (const [label, , hint] of part) assert.match(hint, /planned only in part: plan the rest first/, label);
});

test('the drawing is made of shapes, says what it shows, and looks like the view', async () => {
  const { page, problems } = await browser.openPage();
  await scrubTo(page, 63);
  const { name, bytes } = await drawn(page);
  assert.equal(name, '3rps.svg');
  assert.ok(bytes.length > 50_000 && bytes.length < 1_500_000, `${bytes.length} bytes`);
  const found = await page.evaluate((xml) => {
    const drawing = new DOMParser().parseFromString(xml, 'image/svg+xml');
    const count = (query) => drawing.querySelectorAll(query).length;
    return {
      bad: count('parsererror, script, image, foreignObject'),
      paths: count('#linkage path'),
      shadow: count('#shadow'),
      ground: count('#ground path'),
      colours: new Set([...drawing.querySelectorAll('#linkage path')].map((path) => path.getAttribute('color'))).size,
      names: [...drawing.querySelectorAll('text')].map((node) => node.textContent),
      title: drawing.querySelector('title').textContent,
      description: drawing.querySelector('desc').textContent,
    };
  }, bytes.toString());
  assert.equal(found.bad, 0);
  assert.ok(found.paths > 500 && found.colours > 50 && found.shadow === 1 && found.ground > 3, JSON.stringify(found));
  assert.ok(['begin', 'between', 'end', '1', '2', '3'].every((wanted) => found.names.includes(wanted)), `${found.names}`);
  assert.equal(found.title, '3RPS');
  assert.match(found.description, /3 chains \(RPS, RPS, RPS\).*Frame 64 of 129: closest/);

  // The same picture as the PNG has, small and blurred: mean difference of a channel.
  await choose(page, /PNG/);
  const picture = await saved(page, () => page.getByRole('button', { name: 'Save picture' }).click());
  const { page: blank } = await browser.blankPage();
  const apart = await blank.evaluate(async ([svg, png]) => {
    const small = async (url) => {
      const image = new Image();
      image.src = url;
      await image.decode();
      const pen = new OffscreenCanvas(80, 60).getContext('2d');
      pen.imageSmoothingQuality = 'high';
      pen.drawImage(image, 0, 0, 80, 60);
      return pen.getImageData(0, 0, 80, 60).data;
    };
    const [a, b] = await Promise.all([small(`data:image/svg+xml;base64,${svg}`), small(`data:image/png;base64,${png}`)]);
    const flat = a.reduce((sum, value, index) => sum + Math.abs(value - a[index % 4]), 0) / a.length;
    return [a.reduce((sum, value, index) => sum + Math.abs(value - b[index]), 0) / a.length, flat];
  }, [bytes.toString('base64'), picture.bytes.toString('base64')]);
  assert.ok(apart[0] < 6 && apart[1] > 6, `${apart}`);
  assert.deepEqual(problems, []);
});

// What everybody does with the page, in Firefox and in WebKit: tests/e2e has the same and the rest in Chromium.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, describe, test } from 'node:test';
import { number } from '../e2e/browser.mjs';
import { open, serve } from './browser.mjs';
import { ENGINES, missing } from './start.mjs';

const sample = (name) => readFileSync(new URL(`../../www/mechanisms/${name}.json`, import.meta.url), 'utf8');

let server;
before(async () => {
  server = await serve();
});
after(() => server.close());

/** A page of somebody else's with this in its body. */
const aPage = (body, head = '') => `<!doctype html><html lang="en"><head><meta charset="utf-8"><title>A course</title>${head}</head><body><h1>A course</h1>${body}</body></html>`;

for (const engine of ENGINES) {
  const absent = missing(engine);
  const skip = absent.length > 0 && `${engine.name} is not tested: not installed ${absent.length > 1 ? 'are' : 'is'} ${absent.join(', ')}`;

  describe(engine.name, { skip }, () => {
    let page;
    before(async () => {
      page = await open(engine);
    });
    after(() => page?.end());

    const planned = () => page.until(() => (page$('#closure')?.textContent ?? '–') !== '–');
    /** The applet as on a first visit, at rest on its first frame. */
    async function openApplet() {
      await page.go(`${server.address}blank.html`);
      await page.run(() => localStorage.clear());
      await page.go(server.address);
      await planned();
      await page.until(() => page$('#play').getAttribute('aria-label') === 'Pause');
      await page.click('#play');
      await scrubTo(0);
    }
    /** As a person does who drags the scrub bar. */
    const scrubTo = (frame) =>
      page.run((at) => {
        page$('#scrub').value = String(at);
        page$('#scrub').dispatchEvent(new Event('input'));
        return new Promise((drawn) => requestAnimationFrame(() => requestAnimationFrame(drawn)));
      }, frame);
    const metricBecomes = (value) => page.until((wanted) => page$('#metric').textContent === wanted, value);
    async function otherMetric(old) {
      await page.until((value) => page$('#metric').textContent !== value, old);
      assert.ok(number(await page.text('#closure')) <= 1e-10);
      return page.text('#metric');
    }
    /** A name's flag is shifted from the point that it names. */
    const placeOf = (selector) =>
      page.run((wanted) => {
        const node = page$(wanted);
        const { x, y } = node.getBoundingClientRect();
        const [right, down] = node.style.translate.split(' ').map(parseFloat);
        return { x: x - right, y: y - down };
      }, selector);
    const by = ({ x, y }, dx, dy) => [0, 0.25, 0.5, 0.75, 1].map((share) => ({ x: x + dx * share, y: y + dy * share }));
    const noProblem = async () => assert.deepEqual(await page.problems(), []);

    test('opens on a moving linkage', async () => {
      await page.go(server.address);
      await planned();
      const from = await page.run(() => page$('#scrub').value);
      await page.until((frame) => page$('#scrub').value !== frame, from);
      await page.click('#play');
      await scrubTo(0);
      const first = await page.look('#canvas');
      assert.ok(first.colours > 500, `${first.colours} colours`);
      await scrubTo(60);
      assert.notEqual((await page.look('#canvas')).sum, first.sum, 'the picture has changed');
      assert.match(await page.text('#frame-number'), /^61 \/ 129/);
      await noProblem();
    });

    test('an edit by keyboard is planned, and taken back', async () => {
      await openApplet();
      const old = await page.text('#metric');
      await page.click('[data-path="chains[0].base.x"]');
      await page.press('Control+a', ...'0.25', 'Enter');
      await otherMetric(old);
      await page.press('Control+z');
      await metricBecomes(old);
      await noProblem();
    });

    test('a fault is said beside its cell', async () => {
      await openApplet();
      await page.click('[data-path="chains[0].base.x"]');
      await page.press('Control+a', ...'far', 'Enter');
      await page.boxOf('#fault-note', 'Accepted');
      await page.press('Escape');
      await page.until(() => !page$('#fault-note'));
      await noProblem();
    });

    test('a key frame is dragged by its gizmo, and one undo takes the drag back', async () => {
      await openApplet();
      await scrubTo(64);
      const key = '#labels [data-place="motion.key_frames[1]"]';
      await page.click(key);
      await page.boxOf('.drag-bar', 'between');
      await page.boxOf(key);
      const old = await page.text('#metric');
      await page.drag(...by(await placeOf(key), 40, -30));
      await otherMetric(old);
      await page.press('Control+z');
      await metricBecomes(old);
      assert.equal(await page.run(() => page$('#undo').disabled), true);
      await noProblem();
    });

    test('the workpiece is dragged with closed loops, and goes back', async () => {
      await openApplet();
      await scrubTo(40);
      await page.run(() => page$('#canvas').focus());
      await page.press(']', 'Enter');
      await page.boxOf('.drag-bar', 'workpiece');
      const old = await page.text('#metric');
      const hand = await page.run(() => {
        const [box, [x, y]] = [page$('#canvas').getBoundingClientRect(), page$('#canvas').dataset.hand.split(' ').map(Number)];
        return { x: box.x + x, y: box.y + y };
      });
      await page.drag(...by(hand, 70, 20));
      await page.boxOf('#by-hand');
      await otherMetric(old);
      await page.click('button', 'Back to the motion');
      await metricBecomes(old);
      await noProblem();
    });

    test('the charts are there and drawn, and a click in one moves the playhead', async () => {
      await openApplet();
      await page.until(() => {
        if (page$$('.chart .u-over').some((node) => node.checkVisibility())) return true;
        page$('#tab-charts, [role=tab][aria-controls=charts]').click();
        return false;
      });
      const drawn = await page.look('.chart canvas');
      assert.ok(drawn.colours > 10, `${drawn.colours} colours`);
      const { x, y, width, height } = await page.boxOf('.chart .u-over');
      await page.drag({ x: x + width / 2, y: y + height / 2 });
      await page.until(() => Math.abs(page$('#scrub').value - 64) <= 2);
      assert.notEqual((await page.look('.chart')).sum, drawn.sum);
      await noProblem();
    });

    test('an example is opened from the gallery, and a menu goes by keys', async () => {
      await openApplet();
      await page.click('#examples');
      await page.click('[data-sample="bennett.json"]');
      await page.until(() => page$('#document-name').textContent === "Bennett's linkage" && page$('#mobility-rank').textContent === '1');
      await page.click('.menu-button', 'Export');
      await page.boxOf('[role=menu]', 'Table (CSV)');
      await page.press('ArrowDown', 'ArrowDown');
      assert.match(await page.run(() => pageFocus().textContent), /^Film/);
      await page.press('Escape');
      assert.equal(await page.run(() => pageFocus().textContent), 'Export');
      await noProblem();
    });

    test('a share link opens the same document in a fresh page', async () => {
      await openApplet();
      await page.click('[data-path="chains[0].base.x"]');
      await page.press('Control+a', ...'0.25', 'Enter');
      const old = await page.text('#metric');
      await page.click('#share');
      await page.boxOf('dialog.share');
      const link = await page.until(() => page$$('dialog textarea').map(({ value }) => value).find((value) => value.includes('#d=1.')));
      await page.go(`${server.address}blank.html`);
      await page.run(() => localStorage.clear());
      await page.go(link);
      await planned();
      assert.equal(await page.run(() => page$('[data-path="chains[0].base.x"]').value), '0.25');
      assert.equal(await page.run(() => page$('#unsaved').checkVisibility()), false);
      assert.ok(old.length > 0);
      await noProblem();
    });

    test('the table and the MuJoCo model are saved', async () => {
      await openApplet();
      const save = (item) => async () => {
        await page.click('.menu-button', 'Export');
        await page.click('[role=menuitem]', item);
      };
      const table = await page.saved('.csv', save('CSV'));
      assert.equal(table.name, '3rps.csv');
      const [headings, ...lines] = table.text.trimEnd().split('\n').map((line) => line.split(','));
      assert.equal(lines.length, 129);
      assert.ok(lines.every((line) => line.length === headings.length && line.every((value) => value !== '')));
      const model = await page.saved('.mjcf.xml', save('MJCF'));
      assert.equal(model.name, '3rps.mjcf.xml');
      const counts = await page.run((xml) => {
        const read = new DOMParser().parseFromString(xml, 'application/xml');
        return ['parsererror', 'joint[type]', 'weld'].map((query) => read.querySelectorAll(query).length);
      }, model.text);
      assert.equal(counts[0], 0);
      assert.ok(counts[1] > 0 && counts[2] > 0, `${counts}`);
      await noProblem();
    });

    test('a picture is saved by the page', async () => {
      await openApplet();
      await page.click('.menu-button', 'Export');
      await page.click('[role=menuitem]', 'Picture (PNG)');
      const { text } = await page.saved('.png', () => page.click('dialog button', 'Save picture'));
      assert.match(text, /^.PNG\r\n/);
      await noProblem();
    });

    test('the element in a page of another’s: planned, drawn, played, told, a picture', async () => {
      server.pages.set('of-another.html', aPage('<synthetica-linkage src="mine.json" controls style="height: 400px"></synthetica-linkage>', '<script type="module" src="./element.js"></script>'));
      server.pages.set('mine.json', sample('2tpr'));
      await page.go(`${server.address}of-another.html`);
      await page.until(() => document.querySelector('synthetica-linkage').trajectory?.frames === 129);
      const drawn = await page.look('#canvas');
      assert.ok(drawn.colours > 300, `${drawn.colours} colours`);
      await page.click('#play');
      await page.until(() => document.querySelector('synthetica-linkage').frame > 3);
      await page.click('#play');
      const [type, size, colours, rows] = await page.run(async () => {
        const element = document.querySelector('synthetica-linkage');
        const blob = await element.toImage();
        const bitmap = await createImageBitmap(blob);
        const canvas = Object.assign(document.createElement('canvas'), { width: bitmap.width, height: bitmap.height });
        const pen = canvas.getContext('2d');
        pen.drawImage(bitmap, 0, 0);
        const pixels = new Uint32Array(pen.getImageData(0, 0, canvas.width, canvas.height).data.buffer);
        return [blob.type, bitmap.width * bitmap.height, new Set(pixels).size, (await element.toCSV()).trimEnd().split('\n').length];
      });
      assert.equal(type, 'image/png');
      assert.ok(size > 10_000 && colours > 300, `${size} pixels of ${colours} colours`);
      assert.equal(rows, 130);
      await page.run((text) => void (document.querySelector('synthetica-linkage').document = text), sample('bennett'));
      await page.until(() => document.querySelector('synthetica-linkage').trajectory?.frames === 65);
      await noProblem();
    });

    // WebKit finds that 'self' in the content policy of embed.html is nobody where a sandbox has taken the origin: no script runs.
    const noSelf = engine.name === 'WebKit' && "'self' of a content policy is nothing in a sandbox";
    for (const [where, sandbox, todo] of [['', '', false], [', in a sandbox', 'sandbox="allow-scripts"', noSelf]]) {
      test(`a frame in a page of another origin says and is told${where}`, { todo }, async () => {
        const keep = `<script>window.heard = []; addEventListener('message', ({ data, source }) => heard.push({ ...data, own: source === document.querySelector('iframe').contentWindow }));</script>`;
        const frame = `<iframe src="${server.address}embed.html?sample=2tpr" width="700" height="420" ${sandbox}></iframe>`;
        server.pages.set('around.html', aPage(`${keep}${frame}`));
        await page.go(`${server.elsewhere}around.html`);
        const heard = (type) => page.until((wanted) => window.heard.findLast((message) => message.type === wanted), type);
        assert.equal((await heard('ready')).own, true);
        assert.equal((await heard('document')).document.name, '2TPR');
        const send = (message) => page.run((one) => document.querySelector('iframe').contentWindow.postMessage(one, '*'), message);
        await send({ synthetica: 1, type: 'state', state: { frame: 40 } });
        await page.until(() => window.heard.some(({ type, state }) => type === 'state' && state.frame === 40));
        await send({ synthetica: 1, type: 'get', what: 'trajectory', id: 7 });
        assert.equal(await page.until(() => window.heard.find(({ id }) => id === 7)?.trajectory?.closure.length), 129);
        assert.ok((await page.look('iframe')).colours > 300, 'it is drawn');
        await noProblem();
      });
    }
  });
}

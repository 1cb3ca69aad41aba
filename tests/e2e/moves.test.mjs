// What one move of a hand touches: what follows it is one picture and one question, and what is only read waits until it rests.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { openBrowser } from './browser.mjs';

const KEY = 'motion.key_frames[1]';
const MOVES = 8;

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

/** In the page, before its scripts: counts questions, pictures, new buffers; no hand rests, and each picture waits for its answer, however slow the machine. */
function count() {
  // By worker and number: what comes before the page listens is told to it once more, see www/planner/start-worker.js.
  const waiting = new Set();
  let workers = 0;
  const counts = (window.counts = {
    asked: {},
    get open() {
      return waiting.size;
    },
    buffers: 0,
    touched: new Set(),
  });
  const Plain = Worker;
  globalThis.Worker = class extends Plain {
    number = (workers += 1);
    constructor(...args) {
      super(...args);
      this.addEventListener('message', ({ data }) => {
        if (['value', 'fault', 'failure', 'cancelled'].includes(data.kind)) waiting.delete(`${this.number} ${data.id}`);
      });
    }
    postMessage(message) {
      if (message.kind === 'ask') {
        waiting.add(`${this.number} ${message.id}`);
        counts.asked[message.call] = (counts.asked[message.call] ?? 0) + 1;
      }
      super.postMessage(message);
    }
  };
  const { createBuffer } = WebGL2RenderingContext.prototype;
  WebGL2RenderingContext.prototype.createBuffer = function () {
    counts.buffers += 1;
    return createBuffer.call(this);
  };
  const { setTimeout } = window;
  window.setTimeout = (act, ms, ...args) => setTimeout(act, window.steady && (ms === 500 || ms === 50) ? 1e6 : ms, ...args);
}

/** What takes hold of a thing, and goes twice around with it; what the second round touched. @param {string} place */
async function goAround(place) {
  const { page, problems } = await browser.blankPage({ viewport: { width: 1280, height: 800 } });
  await page.addInitScript(count);
  await page.goto(browser.address);
  await page.waitForFunction(() => (page$('#closure')?.textContent ?? '–') !== '–');
  await page.getByRole('tab', { name: 'Motion', exact: true }).click();
  await page.locator('#motion .keys').waitFor();
  await page.locator('#canvas').focus();
  const pointed = page.locator(`#canvas[data-hovered="${place}"]`);
  for (let i = 0; i < 60 && !(await pointed.count()); i++) await page.keyboard.press(']');
  await page.keyboard.press('Enter');
  await page.locator('#canvas[data-hand]').waitFor();
  const [x, y] = (await page.locator('#canvas').getAttribute('data-hand')).split(' ').map(Number);
  const box = await page.locator('#canvas').boundingBox();
  const at = { x: box.x + x, y: box.y + y };
  await page.evaluate(() => (window.steady = true));
  await page.mouse.move(at.x, at.y);
  await page.mouse.down();
  const round = async () => {
    for (let i = 1; i <= MOVES; i++) {
      const angle = (2 * Math.PI * i) / MOVES;
      const draws = await page.locator('#canvas').getAttribute('data-draws');
      await page.mouse.move(at.x + 30 * Math.sin(angle), at.y + 8 + 30 * (1 - Math.cos(angle)));
      await page.waitForFunction((before) => window.counts.open === 0 && page$('#canvas').dataset.draws !== before, draws);
    }
  };
  await round();
  await page.evaluate(() => {
    Object.assign(window.counts, { asked: {}, buffers: 0, draws: Number(page$('#canvas').dataset.draws) });
    const partOf = (node) => (node.nodeType === Node.ELEMENT_NODE ? node : node.parentElement)?.closest('[data-path], [id]');
    window.eye = new MutationObserver((changes) => {
      for (const { target } of changes) {
        const part = partOf(target);
        window.counts.touched.add(part?.dataset.path ?? `#${part?.id}`);
      }
    });
    for (const id of ['mechanism', 'motion', 'charts', 'objects', 'why', 'info', 'legend']) {
      const part = page$(`#${id}`);
      if (part) window.eye.observe(part, { subtree: true, childList: true, attributes: true, characterData: true });
    }
  });
  await round();
  const touched = await page.evaluate(() => {
    const { counts, eye } = window;
    eye.disconnect();
    return { ...counts, touched: [...counts.touched], draws: Number(page$('#canvas').dataset.draws) - counts.draws };
  });
  return { page, problems, touched };
}

/** The numbers of the shown frame, which follow the hand in the info panel. */
const NUMBERS = /^#(frame-|gap-|metric|closure|misfit|sigma|gradient|curvature|iterations|certificate)/;

test('a move of a key frame asks for one plan, draws one picture, writes its own cells only and makes no new bodies', async () => {
  const { page, problems, touched } = await goAround(KEY);
  assert.deepEqual(touched.asked, { plan: MOVES });
  assert.equal(touched.draws, MOVES);
  assert.equal(touched.buffers, 0);
  const others = touched.touched.filter((place) => !place.startsWith(`${KEY}.`) && !NUMBERS.test(place));
  assert.deepEqual(others, []);
  assert.ok(touched.touched.some((place) => place.startsWith(`${KEY}.`)), 'its own cells follow');
  // Let go, all that is read is that of the last motion.
  const summary = await page.locator('#motion-summary').textContent();
  await page.mouse.up();
  await page.waitForFunction((before) => page$('#motion-summary').textContent !== before, summary);
  await page.waitForFunction(() => window.counts.asked.explain > 0 && !page$('#why').matches('.waiting, .unsaid'));
  assert.deepEqual(problems, []);
  await page.context().close();
});

test('a move of the workpiece is one pull and one picture, and touches no table and no chart', async () => {
  const { page, problems, touched } = await goAround('workpiece');
  assert.deepEqual(touched.asked, { pull: MOVES });
  assert.equal(touched.draws, MOVES);
  assert.equal(touched.buffers, 0);
  assert.deepEqual(touched.touched.filter((place) => !NUMBERS.test(place)), []);
  await page.mouse.up();
  await page.waitForFunction(() => window.counts.asked.explain > 0);
  assert.deepEqual(problems, []);
  await page.context().close();
});

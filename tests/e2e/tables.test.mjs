// Chains, joints and key frames come, go and change places, by menu and by keyboard.
import assert from 'node:assert/strict';
import { after, afterEach, before, beforeEach, test } from 'node:test';
import { cell, doTo, openBrowser, scrubTo, text } from './browser.mjs';

let browser;
let page;
let problems;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());
beforeEach(async () => {
  ({ page, problems } = await browser.openPage());
});
afterEach(() => assert.deepEqual(problems, []));

const joints = (chain) => page.locator(`[data-path^="chains[${chain}].joints"][data-path$=".type"]`).evaluateAll((all) => all.map((s) => s.value).join(''));
const names = () => page.locator('#mechanism h3 input:not(.type)').evaluateAll((all) => all.map((input) => input.value));
const active = () => page.evaluate(() => pageFocus().dataset.path ?? pageFocus().dataset.menu);

test('a joint is inserted, moved by its menu and by Alt and an arrow, removed; each is one step of undo', async () => {
  assert.equal(await joints(0), 'RPS');
  await doTo(page, 'joint 2 of chain 1', 'Insert a joint before');
  await cell(page, 'chains[0].joints[3].type').waitFor();
  assert.equal(await joints(0), 'RRPS');
  await doTo(page, 'joint 3 of chain 1', 'Move up');
  assert.equal(await joints(0), 'RPRS');
  assert.equal(await active(), 'chains[0].joints[1]', 'the focus goes with the joint');
  await cell(page, 'chains[0].joints[1].rows[0].alpha').focus();
  await page.keyboard.press('Alt+ArrowDown');
  assert.equal(await joints(0), 'RRPS');
  assert.equal(await active(), 'chains[0].joints[2].rows[0].alpha');
  await doTo(page, 'joint 2 of chain 1', 'Remove');
  assert.equal(await joints(0), 'RPS');
  for (let i = 0; i < 4; i++) await page.keyboard.press('Control+z');
  assert.equal(await joints(0), 'RPS');
  await page.locator('#fault-note').waitFor({ state: 'detached' });
});

test('chains change places', async () => {
  await doTo(page, 'chain 1', 'Move down');
  assert.deepEqual(await names(), ['chain 2', 'chain 1', 'chain 3']);
  await cell(page, 'chains[1].base.x').focus();
  await page.keyboard.press('Alt+ArrowDown');
  assert.deepEqual(await names(), ['chain 2', 'chain 3', 'chain 1']);
  assert.equal(await active(), 'chains[2].base.x');
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  assert.deepEqual(await names(), ['chain 1', 'chain 2', 'chain 3']);
  await doTo(page, 'chain 3', 'Remove');
  assert.equal(await active(), 'chains[1]', 'the focus goes to the chain before it');
});

test('key frames come at the shown pose, and change places', async () => {
  await scrubTo(page, 40);
  await page.getByRole('tab', { name: 'Motion', exact: true }).click();
  await page.getByRole('button', { name: '+ at the shown pose' }).click();
  await cell(page, 'motion.key_frames[3].x').waitFor();
  await page.keyboard.press('Control+z');
  await cell(page, 'motion.key_frames[3].x').waitFor({ state: 'detached' });

  await doTo(page, 'key frame 1', 'Move down');
  const order = await page.locator('#motion .key th input').evaluateAll((all) => all.map((input) => input.value));
  assert.deepEqual(order, ['between', 'begin', 'end']);
  await page.getByRole('button', { name: 'Go to key frame 3' }).click();
  const [at, of] = (await text(page, 'frame-number')).split(' / ');
  assert.equal(at, of);
});

test('a key frame at the shown goal is where the goal is', async () => {
  await page.getByRole('tab', { name: 'Motion', exact: true }).click();
  await scrubTo(page, 128);
  await page.getByRole('button', { name: '+ at the shown goal' }).click();
  await cell(page, 'motion.key_frames[3].x').waitFor();
  for (const key of ['x', 'y', 'z', 'longitude', 'latitude', 'roll']) {
    const [last, fresh] = await Promise.all([2, 3].map(async (index) => Number(await cell(page, `motion.key_frames[${index}].${key}`).inputValue())));
    assert.ok(Math.abs(last - fresh) < 1e-3, key);
  }
});

test('a key frame at the shown pose can be reached', async () => {
  await scrubTo(page, 64);
  await page.getByRole('tab', { name: 'Motion', exact: true }).click();
  await doTo(page, 'key frame 2', 'Take the shown pose');
  await page.getByRole('button', { name: 'Go to key frame 2' }).click();
  await page.waitForFunction(() => page$('#frame-word').textContent === 'Reached');
});

test('a cell that is being typed in keeps its node, its text and its caret, whatever else changes', async () => {
  /** Changes the document as somebody else does, without the focus; waits for the planner's answer. */
  const change = async (how) => {
    await page.evaluate((body) => {
      const { store } = document.querySelector('synthetica-linkage').parts;
      if (body === 'undo') page$('#undo').click();
      else store.edit((doc) => new Function('doc', body)(structuredClone(doc)));
    }, how);
    await page.waitForFunction(() => {
      const { store } = document.querySelector('synthetica-linkage').parts;
      return store.result.doc === store.doc || store.result.fault;
    });
  };
  const stays = async (what, path, wanted) => {
    const now = await page.evaluate(() => {
      const { value, selectionStart, selectionEnd, dataset } = pageFocus();
      return { same: pageFocus() === window.typed, path: dataset.path, text: [value, selectionStart, selectionEnd] };
    });
    assert.deepEqual(now, { same: true, path, text: wanted }, what);
  };
  const enter = async (path, text, from, to) => {
    await cell(page, path).focus();
    await page.keyboard.type(text);
    await page.evaluate(([start, end]) => {
      window.typed = pageFocus();
      window.typed.setSelectionRange(start, end);
    }, [from, to]);
  };

  await enter('chains[1].joints[1].rows[0].theta', '1e', 1, 2);
  const half = ['1e', 1, 2];
  await change('doc.chains[0].joints[1].rows[0].alpha = 80; return doc');
  await stays('another cell, and the planner’s answer', 'chains[1].joints[1].rows[0].theta', half);
  await change('undo');
  await stays('undo', 'chains[1].joints[1].rows[0].theta', half);
  await change('return { ...doc, length_unit: "mm" }');
  await stays('another unit', 'chains[1].joints[1].rows[0].theta', half);
  assert.match(await cell(page, 'chains[1].base.x').getAttribute('aria-label'), /in mm/);
  await change('doc.chains[1].joints.unshift({ type: "R", rows: [{ alpha: 12, a: 0, theta: 0, d: 0 }] }); return doc');
  await stays('a joint above it', 'chains[1].joints[2].rows[0].theta', half);
  await change('doc.chains.shift(); return doc');
  await stays('a chain above it is gone', 'chains[0].joints[2].rows[0].theta', half);
  await page.keyboard.press('Alt+ArrowUp');
  await stays('its joint is moved', 'chains[0].joints[1].rows[0].theta', half);
  await change('undo');
  await stays('and moved back by undo', 'chains[0].joints[2].rows[0].theta', half);
  await page.keyboard.press('End');
  await page.keyboard.type('1');
  assert.equal(await page.evaluate(() => document.querySelector('synthetica-linkage').parts.store.doc.chains[0].joints[2].rows[0].theta), 10, 'it is written where its row is now');

  const type = page.getByRole('textbox', { name: 'type of chain 2' });
  await type.focus();
  await enter('chains[1].type', 'RR', 1, 1);
  await change('return { ...doc, name: "another" }');
  await stays('a type that is half typed', 'chains[1].type', ['RR', 1, 1]);
  await page.getByText('Enter makes this chain RR; Escape keeps RPS.').waitFor();

  await page.getByRole('tab', { name: 'Motion', exact: true }).click();
  await enter('motion.key_frames[1].x', '0.', 2, 2);
  await change('doc.motion.key_frames.splice(1, 0, { ...doc.motion.key_frames[0], name: "fresh" }); return doc');
  await stays('a key frame above it', 'motion.key_frames[2].x', ['0.', 2, 2]);
  await change('undo');
  await stays('and its undo', 'motion.key_frames[1].x', ['0.', 2, 2]);
  await page.keyboard.press('Escape');
});

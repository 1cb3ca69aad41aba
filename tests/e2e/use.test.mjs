// Nothing is left behind by use: heap, nodes and listeners are flat from round to round, each the same use of the page.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { LIMITS } from '../../scripts/bench/limits.mjs';
import { openBrowser } from './browser.mjs';
import { growthOf, useRounds } from './use.mjs';

test('heap, nodes and listeners are flat under use, and what is left behind in each round is found', { timeout: 600_000 }, async () => {
  const browser = await openBrowser();
  try {
    const { page, problems } = await browser.openPage({ viewport: { width: 1280, height: 800 } });
    const held = await useRounds(page, { before: 2, rounds: 4 });
    const growth = growthOf(held);
    console.log(`left behind by a round of use: ${JSON.stringify(growth)}`);
    for (const what of ['heap', 'nodes', 'listeners']) assert.ok(growth[what] <= LIMITS.use[what], `${what}: ${JSON.stringify(held.map((one) => one[what]))}`);
    // Rounds with a listener, nodes and memory that no round takes back.
    const leaky = await useRounds(page, {
      before: 0,
      rounds: 3,
      round: () =>
        page.evaluate((most) => {
          window.addEventListener('resize', () => {});
          (window.leftBehind ??= []).push(Array.from({ length: most.nodes + 1 }, () => document.createElement('p')), Array(most.heap).fill(0.5));
        }, LIMITS.use),
    });
    const found = growthOf(leaky);
    for (const what of ['heap', 'nodes', 'listeners']) assert.ok(found[what] > LIMITS.use[what], `${what} that is left behind is not found: ${JSON.stringify(leaky.map((one) => one[what]))}`);
    assert.deepEqual(problems, []);
  } finally {
    await browser.close();
  }
});

// What use leaves behind: heap, nodes and listeners that a round of use adds, when all garbage is collected.
import { useRounds, growthOf } from '../../tests/e2e/use.mjs';
import { LIMITS } from './limits.mjs';
import { planned } from './page.mjs';
import { kilobytes } from './print.mjs';

/** Longest time of all rounds, in ms. */
const TIME = Number(process.env.MINUTES ?? 2) * 60_000;
const BEFORE = 2;

/** @param {import('./page.mjs').Bench} bench @returns {Promise<import('./print.mjs').Bar[]>} */
export async function use(bench) {
  const { context, page } = await bench.load({ reducedMotion: 'reduce' });
  await planned(page);
  const held = await useRounds(page, { before: BEFORE, rounds: 1000, until: Date.now() + TIME });
  await context.close();
  const growth = growthOf(held);
  const [first, last] = [held[0], held[held.length - 1]];
  const plain = (/** @type {number} */ value) => value.toFixed(1);
  return [
    { what: 'heap that a round of use adds', value: growth.heap, limit: LIMITS.use.heap, write: kilobytes, more: `${held.length} rounds, ${kilobytes(first.heap)} to ${kilobytes(last.heap)}` },
    { what: 'nodes that a round of use adds', value: growth.nodes, limit: LIMITS.use.nodes, write: plain, more: `${first.nodes} to ${last.nodes}` },
    { what: 'listeners that a round of use adds', value: growth.listeners, limit: LIMITS.use.listeners, write: plain, more: `${first.listeners} to ${last.listeners}` },
  ];
}

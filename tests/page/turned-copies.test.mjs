// A chain copied around an axis: the copies close at the same start values, and the planner moves what they make.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { turnedCopies, whyNotCopied, workpieceAt } from '../../www/core/turned-copies.js';

const at = (path) => new URL(`../../www/${path}`, import.meta.url);
const { initSync, Session } = await import(at('pkg/synthetica.js'));
initSync({ module: readFileSync(at('pkg/synthetica_bg.wasm')) });
const sample = (name) => JSON.parse(readFileSync(at(`mechanisms/${name}`), 'utf8'));

/** One leg of a sample, with a start that is not that of the paper. */
function oneLeg(name, chain = 0) {
  const doc = sample(name);
  return { ...doc, chains: [doc.chains[chain]] };
}
const apart = (a, b) => Math.max(...a.elements.map((value, i) => Math.abs(value - b.elements[i])));

for (const [name, chain] of [['3rps.json', 0], ['2tpr.json', 1], ['scara.json', 0], ['bennett.json', 1]]) {
  for (const around of [{ count: 3, axis: 'z', point: [0, 0.25, 0] }, { count: 5, axis: 'x', point: [0.3, -0.2, 1.5] }, { count: 2, axis: 'y', point: [0, 0, 7] }]) {
    test(`${name}: ${around.count} around ${around.axis} through ${around.point} close at the same start values`, () => {
      const doc = oneLeg(name, chain);
      const { start } = doc.chains[0];
      const before = JSON.stringify(doc);
      const { chains } = turnedCopies(doc, 0, around, start);
      assert.equal(JSON.stringify(doc), before);
      assert.equal(chains.length, around.count);
      assert.equal(new Set(chains.map(({ name: own }) => own)).size, around.count, 'each has a name of its own');
      const workpiece = workpieceAt(doc.chains[0], start);
      const base = doc.chains[0].base;
      for (const copy of chains) {
        assert.deepEqual(copy.joints, doc.chains[0].joints);
        assert.deepEqual(copy.start, start);
        assert.ok(apart(workpieceAt(copy, start), workpiece) < 1e-12, `${copy.name} is open by ${apart(workpieceAt(copy, start), workpiece)}`);
      }
      // Turned by a full circle over the count: the second base is as far from the axis as the first.
      const { axis, point } = around;
      const arm = (frame) => ['x', 'y', 'z'].map((key, i) => (frame?.[key] ?? 0) - point[i]).filter((_, i) => 'xyz'[i] !== axis);
      const [one, other] = [arm(base), arm(chains[1].base)];
      assert.ok(Math.abs(Math.hypot(...one) - Math.hypot(...other)) < 1e-12);
      const cosine = (one[0] * other[0] + one[1] * other[1]) / Math.hypot(...one) ** 2;
      assert.ok(Math.abs(cosine - Math.cos((2 * Math.PI) / around.count)) < 1e-12);
    });
  }
}

test('copies are named after their chain', () => {
  const doc = oneLeg('3rps.json');
  const names = (name) => turnedCopies({ ...doc, chains: [{ ...doc.chains[0], name }] }, 0, { count: 3, axis: 'z', point: [0, 0, 0] }, doc.chains[0].start).chains.map((chain) => chain.name);
  assert.deepEqual(names('RPS 1'), ['RPS 1', 'RPS 2', 'RPS 3']);
  assert.deepEqual(names('left leg'), ['left leg', 'left leg 2', 'left leg 3']);
  assert.deepEqual(names('7'), ['7', 'chain 2', 'chain 3']);
  assert.ok(names('x'.repeat(100)).every((name) => name.length <= 100));
  assert.deepEqual(names(undefined), [undefined, 'chain 2', 'chain 3']);
});

test('a 3RPS made of one leg plans: its loops are closed in every frame, and it has the 3RPS’s freedoms', () => {
  const leg = oneLeg('3rps.json');
  const { start } = leg.chains[0];
  const session = Session.open(JSON.stringify(turnedCopies(leg, 0, { count: 3, axis: 'z', point: [0, 0, 0] }, start)));
  const motion = session.plan();
  assert.equal(motion.report.chains.length, 3);
  assert.equal(motion.report.mobility_count, 3);
  for (let chain = 0; chain < 3; chain++) {
    motion.report.start[chain].forEach((value, i) => assert.ok(Math.abs(value - start[i]) < 1e-8, 'the planner takes the start as it is'));
  }
  assert.ok(Math.max(...motion.closure) <= 1e-10);
  assert.ok(!motion.report.warnings.some(({ code }) => code === 'start-open'));
  session.free();
});

test('a chain without start values, or with a bad number, says why it is not copied', () => {
  const [chain] = sample('3rps.json').chains;
  assert.equal(whyNotCopied(chain, chain.start), '');
  assert.match(whyNotCopied(chain, undefined), /start values/);
  assert.match(whyNotCopied(chain, chain.start.slice(1)), /start values/);
  assert.match(whyNotCopied({ ...chain, base: { ...chain.base, x: 'abc' } }, chain.start), /at fault/);
});

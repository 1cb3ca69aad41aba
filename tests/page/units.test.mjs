// A mechanism in another unit of length is the same mechanism.
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { test } from 'node:test';
import { convertLengths, factorBetween } from '../../www/core/units.js';

const folder = new URL('../../www/mechanisms/', import.meta.url);
const read = (name) => JSON.parse(readFileSync(new URL(name, folder), 'utf8'));
/** Those of makers are lengths by parameters. */
const documents = readdirSync(folder).filter((name) => name.endsWith('.json') && name !== 'index.json' && !read(name).parameters);

for (const name of documents) {
  test(`${name}: lengths are converted, angles are not, and back again`, () => {
    const before = read(name);
    const after = convertLengths(before, 1000, 'mm');
    assert.equal(after.length_unit, 'mm');
    const [chain, scaled] = [before.chains[0], after.chains[0]];
    if (chain.base) {
      assert.equal(scaled.base.x, Number((chain.base.x * 1000).toPrecision(12)));
      assert.equal(scaled.base.longitude, chain.base.longitude);
    }
    assert.equal(scaled.joints[0].rows?.[0].alpha, chain.joints[0].rows?.[0].alpha);
    const { metric_length: metric } = before.planner ?? {};
    assert.equal(after.planner?.metric_length, typeof metric === 'number' ? Number((metric * 1000).toPrecision(12)) : metric);
    assert.equal(after.planner?.dimension_tolerance, before.planner?.dimension_tolerance);
    assert.deepEqual(convertLengths(after, 1 / 1000, before.length_unit), before);
  });
}

test('of a start and of limits only the sliders’ values are lengths', () => {
  const rps = read('3rps.json');
  rps.chains[0].joints[1].limits = [{ min: 1, max: 2 }];
  rps.chains[0].joints[0].limits = [{ min: -90 }];
  const { start, joints } = convertLengths(rps, 10, 'dm').chains[0];
  const [r, p, ...s] = rps.chains[0].start;
  assert.deepEqual(start, [r, Number((p * 10).toPrecision(12)), ...s]);
  assert.deepEqual(joints[1].limits, [{ min: 10, max: 20 }]);
  assert.deepEqual(joints[0].limits, [{ min: -90 }]);
});

test('the point of reference and the radius are lengths; none stays none', () => {
  const rps = read('3rps.json');
  rps.motion.reference = [1, -0.5, 0];
  const { motion } = convertLengths(rps, 1000, 'mm');
  assert.deepEqual([motion.reference, motion.radius], [[1000, -500, 0], 20000]);
  rps.motion.reference = null;
  assert.equal(convertLengths(rps, 1000, 'mm').motion.reference, null);
  delete rps.motion.reference;
  assert.ok(!('reference' in convertLengths(rps, 1000, 'mm').motion));
});

test('the point about which the metric measures is one of lengths; the metric length follows where it is given', () => {
  const rps = read('3rps.json');
  rps.planner.metric_origin = [0.5, 0, -1];
  const { planner } = convertLengths(rps, 1000, 'mm');
  assert.deepEqual([planner.metric_origin, planner.metric_length], [[500, 0, -1000], 1000 * rps.planner.metric_length]);
  rps.planner.metric_origin = null;
  assert.equal(convertLengths(rps, 1000, 'mm').planner.metric_origin, null);
  rps.planner.metric_length = null;
  assert.equal(convertLengths(rps, 1000, 'mm').planner.metric_length, null);
  delete rps.planner.metric_length;
  assert.ok(!('metric_length' in convertLengths(rps, 1000, 'mm').planner));
});

test('between known units the factor is known', () => {
  assert.deepEqual([factorBetween('m', 'mm'), factorBetween('mm', 'm'), factorBetween('in', 'mm'), factorBetween('ft', 'in')], [1000, 0.001, 25.4, 12]);
  for (const [from, to] of [['m', 'ell'], ['', 'mm'], [undefined, 'mm'], ['m', 'toString']]) assert.equal(factorBetween(from, to), null);
});

// Steps of a number: degrees for angles, the linkage's size for lengths.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { stepOf, stepped } from '../../www/core/number-steps.js';
import { convertLengths } from '../../www/core/units.js';

const rps = JSON.parse(readFileSync(new URL('../../www/mechanisms/3rps.json', import.meta.url), 'utf8'));
const STEPS = {
  'chains[0].joints[1].rows[0].alpha': 1,
  'chains[0].joints[1].rows[0].a': 0.01,
  'chains[2].base.x': 0.01,
  'chains[2].gripper.latitude': 1,
  'chains[0].start[0]': 1,
  'chains[0].start[1]': 0.01,
  'chains[0].joints[1].limits[0].min': 0.01,
  'chains[0].joints[2].limits[2].max': 1,
  'motion.reference[2]': 0.01,
  'motion.frames': 1,
};

test('an angle steps by a degree, a length with the size of the linkage, a count by one', () => {
  for (const [path, step] of Object.entries(STEPS)) assert.equal(stepOf(rps, path, 1), step, path);
  const small = convertLengths(rps, 1000, 'mm');
  for (const [path, step] of Object.entries(STEPS)) assert.equal(stepOf(small, path, 1), step === 0.01 ? 10 : step, `${path} in mm`);
});

test('other numbers step in digits of their own', () => {
  assert.equal(stepOf(rps, 'motion.key_frames[0].time', 2.5), 0.1);
  assert.equal(stepOf(rps, 'motion.key_frames[0].time', 0), 0.01);
  assert.equal(stepOf(rps, 'planner.dimension_tolerance', 0.0001), 0.00001);
});

test('steps leave no spoilt digits', () => {
  assert.equal(stepped(0.1, 0.1, 2), 0.3);
  assert.equal(stepped(1.509051435, 0.01, -3), 1.479051435);
});

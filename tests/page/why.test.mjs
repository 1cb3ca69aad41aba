// Why not closer, and the iterations, in words.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { contraction, iterateInWords } from '../../www/panels/algorithm/algorithm-words.js';
import { postureOf } from '../../www/panels/algorithm/posture-of.js';
import { atLimits, certificate, direction, freedomInWords, mostHolding, percentages, twistInWords } from '../../www/panels/info/why-words.js';

test('shares are whole percent that sum to 100', () => {
  assert.deepEqual(percentages([1 / 3, 1 / 3, 1 / 3]), [34, 33, 33]);
  assert.deepEqual(percentages([0.005, 0.995]).reduce((a, b) => a + b), 100);
  assert.deepEqual(percentages([0, 0]), [0, 0]);
});

test('motions are told as shifts, turns and screws', () => {
  assert.equal(direction([0.1, 0, -0.2]), '(0.5, 0, −1)');
  assert.equal(twistInWords([0, 0, 0, 0, 0, 0], 'm'), 'nothing');
  assert.equal(twistInWords([0, 0, 0.1, 0.1, 0, 0], 'm'), 'a shift of 0.1 m along (0, 0, 1) and a turn of 5.73° about (1, 0, 0)');
  const screw = { twist: [], point: [1, 0, 0], direction: [0, 0, 1] };
  assert.equal(freedomInWords({ ...screw, pitch: null }), 'Shift along (0, 0, 1)');
  assert.equal(freedomInWords({ ...screw, pitch: 0 }), 'Turn about the axis through (1, 0, 0) along (0, 0, 1)');
  assert.match(freedomInWords({ ...screw, pitch: -1 }, 'm'), /^Screw .* 6.2832 m a turn, left-handed$/);
});

test('a certificate says what is certain, and what is not', () => {
  const bounds = { projected_gradient: 2.5e-10 };
  const insight = { projected_gradient: 1e-12, stationary: 2.5e-10, least_curvature: 0.1, flat: 1e-9 };
  assert.match(certificate(insight, 'closest', bounds), /^Certified closest/);
  assert.match(certificate({ ...insight, least_curvature: null }, 'closest', bounds), /no direction is free/);
  assert.match(certificate({ ...insight, least_curvature: -0.1 }, 'stalled', bounds), /^Not certified: .* downwards/);
  assert.match(certificate({ ...insight, projected_gradient: 1e-3 }, 'stalled', bounds), /^Not certified: the distance still falls/);
});

test('the bounds of a certificate are the planner’s, and stand beside the numbers', () => {
  const bounds = { projected_gradient: 1e-7 };
  const insight = { projected_gradient: 3.1e-12, stationary: 2.5e-10, least_curvature: -4e-10, flat: 1e-9 };
  assert.match(certificate(insight, 'closest', bounds), /\(projected gradient 3\.1e−12, at most 2\.5e−10; least curvature −4\.0e−10, at least −1\.0e−9\)\.$/);
  // The same numbers against tighter bounds.
  assert.match(certificate({ ...insight, stationary: 1e-12 }, 'stalled', bounds), /^Not certified: the distance still falls .*at most 1\.0e−12/);
  assert.match(certificate({ ...insight, flat: 1e-10 }, 'stalled', bounds), /^Not certified: .*downwards/);
  // The gradient method has a bound of its own, which is the motion's.
  assert.match(certificate({ ...insight, projected_gradient: 5e-8 }, 'closest', bounds), /gradient method \(projected gradient 5\.0e−8, at most 1\.0e−7;.* stops at 2\.5e−10\.$/);
});

test('an iterate reached the goal by the bound of its motion', () => {
  const course = { iteration: Uint32Array.of(4), last: 4, converged: true, ...Object.fromEntries(['joints', 'closure', 'misfit', 'projected_gradient', 'sigma_min'].map((name) => [name, Float64Array.of(0)])) };
  const pose = Float64Array.of(0, 0, 0, 0, 0, 0, 1);
  const trace = { goal: pose, newton: { ...course, pose, rows: pose, metric: Float64Array.of(1e-18) } };
  assert.equal(postureOf(trace, 'newton', 0, { reached: 1e-17 }).status, 'reached');
  assert.equal(postureOf(trace, 'newton', 0, { reached: 1e-19 }).status, 'closest');
});

test('the chain that holds most is named with what it forbids', () => {
  const chain = (share, wrench) => ({ share, wrench });
  const doc = { chains: [{}, { name: 'left leg' }], planner: {} };
  const insight = { chains: [chain(0.36, [1, 0, 0, 0, 0, 0]), chain(0.64, [0, 0, 2, 0, 0, 0])] };
  assert.equal(mostHolding(insight, doc, 1), 'Left leg holds it back most (64 %): it allows no shift along (0, 0, 1).');
  assert.equal(mostHolding({ chains: [chain(0, [0, 0, 0, 0, 0, 0])] }, doc, 1), '');
});

test('a joint at a limit is found, in degrees or lengths', () => {
  const report = { chains: [{ variables: [{ label: 'θ1', unit: 'rad', joint: 0 }, { label: 'd2', unit: 'length', joint: 1 }] }] };
  const doc = { length_unit: 'm', chains: [{ joints: [{ limits: [{ min: -90, max: 90 }] }, { limits: [{ max: 1.3 }] }] }] };
  assert.deepEqual(atLimits(doc, report, [Math.PI / 2, 1]).map(({ text }) => text), ['θ1 of chain 1 is at its largest value, 90°.']);
  assert.deepEqual(atLimits(doc, report, [0, 1.3]).map(({ text }) => text), ['d2 of chain 1 is at its largest value, 1.3 m.']);
});

test('a linear course contracts by its factor; the last iterate stops', () => {
  const count = 30;
  const course = {
    iteration: Uint32Array.from({ length: count }, (_, i) => i),
    metric: Float64Array.from({ length: count }, (_, i) => 1 + 0.5 ** i),
    projected_gradient: new Float64Array(count), closure: new Float64Array(count), last: count - 1, converged: true,
    share: new Float64Array(count).fill(1), opening: new Float64Array(count), corrections: new Float64Array(count), correction: new Float64Array(count),
  };
  assert.ok(Math.abs(contraction(course, 1) - 0.5) < 1e-9);
  assert.match(iterateInWords('gradient', course, count - 1, { frame: 3 }).steps.at(-1)[0], /stop/);
  assert.equal(iterateInWords('gradient', course, 0, { frame: 3 }).heading, 'The start: the answer of frame 3.');
});

// Why not closer, and the iterations, in words.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { contraction, iterateInWords } from '../../www/view/algorithm-words.js';
import { atLimits, certificate, direction, freedomInWords, mostHolding, percentages, twistInWords } from '../../www/view/why-words.js';

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
  const insight = { projected_gradient: 1e-12, least_curvature: 0.1 };
  assert.match(certificate(insight, 'closest'), /^Certified closest/);
  assert.match(certificate({ ...insight, least_curvature: null }, 'closest'), /no direction is free/);
  assert.match(certificate({ ...insight, least_curvature: -0.1 }, 'stalled'), /^Not certified: .* downwards/);
  assert.match(certificate({ ...insight, projected_gradient: 1e-3 }, 'stalled'), /^Not certified: the distance still falls/);
});

test('the chain that holds most is named with what it forbids', () => {
  const chain = (share, wrench) => ({ share, wrench });
  const document = { chains: [{}, { name: 'left leg' }], planner: {} };
  const insight = { chains: [chain(0.36, [1, 0, 0, 0, 0, 0]), chain(0.64, [0, 0, 2, 0, 0, 0])] };
  assert.equal(mostHolding(insight, document), 'Left leg holds it back most (64 %): it allows no shift along (0, 0, 1).');
  assert.equal(mostHolding({ chains: [chain(0, [0, 0, 0, 0, 0, 0])] }, document), '');
});

test('a joint at a limit is found, in degrees or lengths', () => {
  const report = { chains: [{ variables: [{ label: 'θ1', unit: 'rad', joint: 0 }, { label: 'd2', unit: 'length', joint: 1 }] }] };
  const document = { length_unit: 'm', chains: [{ joints: [{ limits: [{ min: -90, max: 90 }] }, { limits: [{ max: 1.3 }] }] }] };
  assert.deepEqual(atLimits(document, report, [Math.PI / 2, 1]).map(({ text }) => text), ['θ1 of chain 1 is at its largest value, 90°.']);
  assert.deepEqual(atLimits(document, report, [0, 1.3]).map(({ text }) => text), ['d2 of chain 1 is at its largest value, 1.3 m.']);
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

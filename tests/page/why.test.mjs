// Why not closer, and the iterations, in words.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { groups } from '../../www/panels/algorithm/matrix-picture.js';
import { contraction, iterateInWords } from '../../www/panels/algorithm/algorithm-words.js';
import { postureOf } from '../../www/panels/algorithm/posture-of.js';
import { direction, freedomInWords } from '../../www/core/freedom-words.js';
import { certificateNumbers } from '../../www/panels/info/status.js';
import { Vector3 } from 'three';
import { wrenchAt } from '../../www/view3d/hand/screws.js';
import { percentages } from '../../www/core/percentages.js';
import { atLimits, certificate, mostHolding, twistInWords } from '../../www/panels/info/why-words.js';

test('shares are whole percent that sum to 100', () => {
  assert.deepEqual(percentages([1 / 3, 1 / 3, 1 / 3]), [34, 33, 33]);
  assert.deepEqual(percentages([0.005, 0.995]).reduce((a, b) => a + b), 100);
  assert.deepEqual(percentages([0, 0]), [0, 0]);
});

test('motions are told as shifts, turns and screws, which of them is what Rust says', () => {
  assert.equal(direction([0.1, 0, -0.2]), '(0.5, 0, −1)');
  assert.equal(twistInWords([0, 0, 0, 0, 0, 0], 'm'), 'nothing');
  assert.equal(twistInWords([0, 0, 0.1, 0.1, 0, 0], 'm'), 'a shift of 0.1 m along (0, 0, 1) and a turn of 5.73° about (1, 0, 0)');
  assert.equal(twistInWords([0, 0, 1e-7, 0, 0, 0], 'm'), 'a shift of 1.0e−7 m along (0, 0, 1)', 'not rounded to nothing');
  assert.equal(twistInWords([0, 0, 1e-7, 0, 0, 0], ''), 'a shift of 1.0e−7 along (0, 0, 1)', 'no unit, no space for it');
  const screw = { twist: [], point: [1, 0, 0], direction: [0, 0, 1] };
  assert.deepEqual(freedomInWords({ ...screw, pitch: null }), { short: 'shift', whole: 'shift along (0, 0, 1)' });
  assert.deepEqual(freedomInWords({ ...screw, pitch: 0 }), { short: 'turn', whole: 'turn about the axis through (1, 0, 0) along (0, 0, 1)' });
  assert.match(freedomInWords({ ...screw, pitch: -1 }, 'm').whole, /^screw .* 6.2832 m a turn, left-handed$/);
  // A small pitch is one: in kilometres, or of a slender thread.
  assert.deepEqual(freedomInWords({ ...screw, pitch: 2e-7 }, 'km').short, 'screw');
  assert.match(freedomInWords({ ...screw, pitch: 2e-7 }, 'km').whole, /1\.3e−6 km a turn$/);
});

const bounds = { closure: 1e-10, misfit: 1e-6 };
const closed = { closure: 1e-14, misfit: 0 };

test('a certificate says what is certain as Rust’s status does, and by Rust’s bounds why not', () => {
  const insight = { projected_gradient: 1e-12, stationary: 2.5e-10, least_curvature: 0.1, flat: 1e-9 };
  const says = (change, status, end = closed) => certificate({ ...insight, ...change }, status, end, bounds);
  assert.match(says({}, 'closest'), /^Certified closest: no small motion/);
  assert.match(says({ least_curvature: null }, 'closest'), /no direction is free/);
  assert.match(says({ least_curvature: -0.1 }, 'stalled'), /^Not certified: .* downwards/);
  assert.match(says({ projected_gradient: 1e-3 }, 'stalled'), /^Not certified: the distance still falls/);
  // The same numbers against other bounds.
  assert.match(says({ stationary: 1e-13 }, 'stalled'), /^Not certified: the distance still falls/);
  assert.match(says({ least_curvature: -4e-10 }, 'stalled'), /^Not certified by the planner, though/, 'a status that is none is not talked up');
  assert.match(says({ least_curvature: -4e-10, flat: 1e-10 }, 'stalled'), /downwards/);
  assert.match(says({}, 'stalled', { closure: 1e-3, misfit: 0 }), /the loops are open by 1\.0e−3, and closed up to 1\.0e−10/);
  assert.match(says({}, 'stalled', { closure: 0, misfit: 2e-6 }), /contradict each other/);
  assert.match(says({ projected_gradient: 5e-8 }, 'closest'), /gradient method’s bound.* 5\.0e−8, and it stops at 2\.5e−10\.$/);
});

test('values and bounds of the certificate stand side by side, and are Rust’s', () => {
  const motion = { report: { bounds: { ...bounds, projected_gradient: 1e-7 } } };
  const why = { projected_gradient: 3.1e-12, stationary: 2.5e-10, least_curvature: -4e-10, flat: 1e-9 };
  const end = { projected_gradient: 5e-8, closure: 1e-11, misfit: 0 };
  const of = (posture, known = why) => certificateNumbers({ result: { motion }, view: { posture }, why: known }, end);
  assert.deepEqual(of(null), {
    gradient: 5e-8,
    curvature: -4e-10,
    out: [],
    bounds: { closure: 'at most 1.0e−10', misfit: 'at most 1.0e−6', gradient: 'at most 1.0e−7', curvature: 'at least −1.0e−9' },
  });
  assert.deepEqual(of({}).out, ['gradient'], 'and its bound is not kept');
  assert.deepEqual(of(null, { ...why, flat: 1e-10 }).out, ['curvature']);
  const open = { ...end, closure: 2e-10, misfit: 2e-6 };
  assert.deepEqual(certificateNumbers({ result: { motion }, view: { posture: null }, why }, open).out, ['closure', 'misfit']);
  assert.deepEqual(certificateNumbers({ result: { motion }, view: { posture: { value: 1 } }, why }, open).out, ['closure', 'misfit'], 'a joint that is driven by hand has no goal');
  assert.equal(of({}).bounds.gradient, 'at most 2.5e−10', 'by hand it is Newton’s method that answers');
  // An iterate of the gradient method: ‖a‖ is another measure than that of the bound.
  end.projected_gradient = NaN;
  assert.equal(of({ note: 'Iterate 3.' }).gradient, 3.1e-12);
  assert.equal(of({ note: 'Iterate 3.' }, null).gradient, undefined);
});

test('an iterate reached the goal by the bound of its motion', () => {
  const course = { iteration: Uint32Array.of(4), last: 4, converged: true, ...Object.fromEntries(['joints', 'closure', 'misfit', 'projected_gradient', 'sigma_min'].map((name) => [name, Float64Array.of(0)])) };
  const pose = Float64Array.of(0, 0, 0, 0, 0, 0, 1);
  const trace = { goal: pose, newton: { ...course, pose, rows: pose, metric: Float64Array.of(1e-18) } };
  assert.equal(postureOf(trace, 'newton', 0, { reached: 1e-17 }).status, 'reached');
  assert.equal(postureOf(trace, 'newton', 0, { reached: 1e-19 }).status, 'closest');
  assert.equal(postureOf(trace, 'newton', 0, { reached: 1e-17 }).projected_gradient, 0);
  assert.ok(Number.isNaN(postureOf({ ...trace, gradient: trace.newton }, 'gradient', 0, { reached: 1e-17 }).projected_gradient), '‖a‖ is no posture’s projected gradient');
});

test('the chain that holds most is named with what it forbids', () => {
  const chain = (share, wrench) => ({ share, wrench });
  const doc = { chains: [{}, { name: 'left leg' }], planner: {} };
  const insight = { chains: [chain(0.36, [1, 0, 0, 0, 0, 0]), chain(0.64, [0, 0, 2, 0, 0, 0])] };
  assert.equal(mostHolding(insight, doc, 1), 'Left leg holds it back most (64 %): it allows no shift along (0, 0, 1).');
  assert.equal(mostHolding({ chains: [chain(0, [0, 0, 0, 0, 0, 0])] }, doc, 1), '');
});

test('a joint that Rust says is held at a limit is named, in degrees or lengths', () => {
  const report = { chains: [{ variables: [{ label: 'θ1', unit: 'rad' }] }, { variables: [{ label: 'd1', unit: 'length' }] }] };
  const doc = { length_unit: 'm', chains: [{}, { name: 'left leg' }] };
  assert.deepEqual(atLimits([], doc, report, [Math.PI / 2, 1.3]), []);
  assert.deepEqual(atLimits([{ variable: 0, largest: true }], doc, report, [Math.PI / 2, 1.3]), ['θ1 of chain 1 is at its largest value, 90°.']);
  assert.deepEqual(atLimits([{ variable: 1, largest: false }], doc, report, [0, 1.3]), ['d1 of left leg is at its smallest value, 1.3 m.']);
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

test('the blocks of [A] have the chains’ names', () => {
  const at = groups({ freedoms: [3, 2], rows: 14, columns: 13 }, ['crank', 'chain 2']);
  assert.deepEqual(at.columns.map(({ name }) => name), ['crank', 'chain 2', 'q']);
  assert.deepEqual(at.rows.map(({ name }) => name), ['crank', 'chain 2', '|q| = 1']);
});

test('a wrench is drawn on its axis: a force along z through (13, 0, 0), which gives it a moment of 0.5 a unit about itself', () => {
  // Force (0, 0, 2). About (10, 0, 0) its moment is (3, 0, 0) × (0, 0, 2) = (0, −6, 0), and 1 along the axis.
  for (const [unit, away] of [[1, 0], [1000, 0], [1, 1e6]]) {
    const place = (x, y, z) => new Vector3(unit * x + away, unit * y, unit * z);
    const wrench = [0, 0, 2, 0, -6 * unit, unit];
    const { at, force, moment, onAxis } = wrenchAt(wrench, place(10, 0, 0), place(13, 4, 5), 10 * unit, unit);
    assert.ok(onAxis && at.distanceTo(place(13, 0, 5)) < 1e-9 * (unit + away), `${at.toArray()} is the foot of the chain’s end`);
    assert.deepEqual([force.toArray(), moment.toArray().map((value) => value / unit)], [[0, 0, 2], [0, 0, 1]]);
    // An axis that is far away: at the chain's end, with the moment about that, (13 − 13, 0 − 4, 0) × (0, 0, 2) + (0, 0, 1).
    const apart = wrenchAt(wrench, place(10, 0, 0), place(13, 4, 5), 3 * unit, unit);
    assert.ok(!apart.onAxis && apart.at.equals(place(13, 4, 5)));
    assert.deepEqual(apart.moment.toArray().map((value) => value / unit), [-8, 0, 1]);
  }
  const pure = wrenchAt([0, 0, 0, 0, 3, 0], new Vector3(), new Vector3(1, 2, 3), 10, 1);
  assert.deepEqual([pure.force, pure.moment.toArray(), pure.at.toArray()], [null, [0, 3, 0], [1, 2, 3]]);
  const plain = wrenchAt([0, 0, 2, 0, -6, 0.001], new Vector3(10, 0, 0), new Vector3(13, 0, 0), 10, 1);
  assert.equal(plain.moment, null, 'what is too little to be told is not drawn');
});

// What the charts are made of.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { stripGaps } from '../../www/bar/strip.js';
import { chartsOf, GROUPS, isOffered, summary, tableFrames, withUnit } from '../../www/panels/charts/chart-list.js';
import { logTicks, tickText } from '../../www/panels/charts/ticks.js';

const variable = (label, unit) => ({ label, unit, joint: 0, row: 0 });
const motion = {
  frames: 2,
  joints: Float64Array.from([Math.PI / 2, 0.5, -Math.PI, Math.PI / 4, 0.25, Math.PI]),
  translation_gap: Float64Array.from([0, 0.125]),
  rotation_gap: Float64Array.from([0, Math.PI / 180]),
  metric: Float64Array.from([0, 0.01]),
  sigma_min: Float64Array.from([0.5, 0]),
  closure: Float64Array.from([1e-12, 1e-11]),
  misfit: Float64Array.from([0, 2e-5]),
  iterations: Uint32Array.from([0, 3]),
  status: Uint8Array.from([0, 1]),
  report: {
    statuses: ['reached', 'closest'],
    bounds: { reached: 5e-17 },
    metric: { length: 1 },
    chains: [
      { name: 'left', variables: [variable('θ1', 'rad'), variable('d2', 'length')] },
      { name: '', variables: [variable('θ1', 'rad')] },
    ],
  },
};

test('a chart for each number, and for the angles and the lengths of each chain, in the page’s units', () => {
  const charts = chartsOf(motion, 'mm');
  assert.deepEqual(new Set(charts.map(({ group }) => group)), new Set(Object.keys(GROUPS).filter((group) => isOffered(group, motion))));
  const joints = charts.filter(({ group }) => group === 'joints');
  assert.deepEqual(joints.map(({ title, unit, series }) => [title, unit, series.map(({ name }) => name)]), [
    ['left, angles', '°', ['θ₁']],
    ['left, lengths', 'mm', ['d₂']],
    ['chain 2, angles', '°', ['θ₁']],
  ]);
  assert.deepEqual(joints.map(({ series }) => [...series[0].values].map(Math.round)), [[90, 45], [1, 0], [-180, 180]]);
  assert.deepEqual([...charts.find(({ id }) => id === 'rotation').series[0].values].map(Math.round), [0, 1]);
});

test('a chart in words', () => {
  const words = (id, unit) => summary(chartsOf(motion, unit).find((chart) => chart.id === id));
  assert.equal(words('translation', 'm'), 'Translation gap: 0 to 0.125 m, largest at frame 2.');
  assert.equal(words('translation', ''), 'Translation gap: 0 to 0.125 length, largest at frame 2.');
  assert.equal(words('joints 1 angles', 'm'), 'chain 2, angles: −180 to 180°, largest at frame 2.');
  assert.equal(words('misfit', 'm'), 'Misfit of rounded dimensions: 0 to 2.0e−5, largest at frame 2.');
  const flat = { ...chartsOf(motion, 'm')[0], series: [{ name: 'a', values: [2, 2] }] };
  assert.equal(summary(flat), 'Translation gap: 2 m at every frame.');
  assert.equal(withUnit(flat, -1.5), '−1.5 m');
});

test('a long table is thinned, and keeps its last frame', () => {
  assert.equal(tableFrames(129).shown.length, 129);
  const { every, shown } = tableFrames(2000);
  assert.equal(every, 4);
  assert.deepEqual([shown[1], shown.at(-1)], [4, 1999]);
});

test('where the goal counts as reached charts and strip show zero, not rounding', () => {
  const noise = { ...motion, translation_gap: Float64Array.of(3e-13, 0.125), rotation_gap: Float64Array.of(2e-8, 0.02), metric: Float64Array.of(4e-17, 0.01) };
  for (const id of ['translation', 'rotation', 'metric']) {
    const [first, second] = chartsOf(noise, 'm').find((chart) => chart.id === id).series[0].values;
    assert.equal(first, 0, id);
    assert.ok(second > 0, id);
  }
  assert.deepEqual([...stripGaps(noise)], [0, 0.1]);
  const all = { ...noise, status: Uint8Array.of(0, 0) };
  assert.deepEqual([...stripGaps(all)], [0, 0]);
  assert.equal(summary(chartsOf(all, 'm')[0]), 'Translation gap: 0 m at every frame.');
});

test('the smallest extent of a gap’s scale follows the report: the metric’s length and what counts as reached', () => {
  const span = (length, reached, id) => chartsOf({ ...motion, report: { ...motion.report, metric: { length }, bounds: { reached } } }, 'mm').find((chart) => chart.id === id).span;
  const near = (a, b) => assert.ok(Math.abs(a / b - 1) < 1e-12, `${a} is not ${b}`);
  near(span(1000, 5e-17, 'translation'), 1000 * span(1, 5e-17, 'translation'));
  near(span(1, 5e-15, 'rotation'), 10 * span(1, 5e-17, 'rotation'));
  assert.ok(span(1, 5e-17, 'translation') > 10 * 2e-8);
});

test('labels of a logarithmic scale have room', () => {
  const splits = (low, high) => {
    const all = [];
    for (let power = low; power < high; power++) for (let i = 1; i <= 9; i++) all.push(i * 10 ** power);
    return [...all, 10 ** high];
  };
  for (const [low, high, height] of [[-1, 0, 90], [-2, 0, 90], [-3, 0, 90], [-3, 0, 20], [-17, 1, 90], [-1, 0, 900]]) {
    const said = logTicks(splits(low, high), high - low, height).filter((value) => value !== null);
    const places = said.map((value) => (height * (Math.log10(value) - low)) / (high - low));
    assert.ok(said.length >= 1, `${low} to ${high}`);
    for (let i = 1; i < places.length; i++) assert.ok(places[i] - places[i - 1] >= 15.9, `${said[i - 1]} and ${said[i]} in ${height} pixels`);
  }
  assert.deepEqual(logTicks(splits(-1, 0), 1, 90).filter(Boolean).map((value) => value.toFixed(1)), ['0.1', '0.2', '0.5', '1.0']);
});

test('labels of a linear scale are told from their neighbours', () => {
  assert.deepEqual([0, 0.00005, 0.0001].map((value) => tickText(value, 5e-5)), ['0', '5.0e−5', '1.0e−4']);
  assert.deepEqual([0, 0.5, 1].map((value) => tickText(value, 0.5)), ['0', '0.5', '1']);
  assert.deepEqual([-100, 0, 100].map((value) => tickText(value, 100)), ['−100', '0', '100']);
});

// What the charts are made of.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { chartsOf, GROUPS, summary, tableFrames, withUnit } from '../../www/panels/charts/chart-list.js';

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
  report: {
    chains: [
      { name: 'left', variables: [variable('θ1', 'rad'), variable('d2', 'length')] },
      { name: '', variables: [variable('θ1', 'rad')] },
    ],
  },
};

test('a chart for each number, and for the angles and the lengths of each chain, in the page’s units', () => {
  const charts = chartsOf(motion, 'mm');
  assert.deepEqual(new Set(charts.map(({ group }) => group)), new Set(Object.keys(GROUPS)));
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

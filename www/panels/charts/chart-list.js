/**
 * What can be charted of a motion: a list of charts with their series, as plain data. Knows no DOM.
 *
 * @typedef {import('../../core/types.js').Motion} Motion
 * @typedef {{name: string, values: ArrayLike<number>}} ChartSeries in the chart's unit
 *
 * @typedef {object} Chart
 * @property {string} id
 * @property {string} group one of GROUPS; a chain's joints are a chart or two of one group
 * @property {string} title
 * @property {string} unit empty for pure numbers
 * @property {ChartSeries[]} series
 * @property {boolean} [log]
 * @property {number} [floor] of a logarithmic scale: what is below is a zero with rounding
 * @property {boolean} [zero] the scale begins at zero
 * @property {boolean} [steps]
 * @property {number} span smallest extent of the scale: less is rounding
 */
import { chainName } from '../../core/chain-name.js';
import { drivesJoints, told } from '../../core/driven.js';
import { degrees, lengthUnit, scientific, short } from '../../core/format.js';
import { roundingGaps, statusName, worstFrame } from '../../core/status-words.js';

/** What is offered, in this order. @type {Record<string, string>} */
export const GROUPS = {
  translation: 'Translation gap',
  rotation: 'Rotation gap',
  metric: 'Metric ½‖q − g‖²',
  driven: 'Driven joints',
  path: 'Workpiece’s origin',
  joints: 'Joint variables',
  sigma: 'Smallest singular value of [A]',
  closure: 'Closure of the loops',
  misfit: 'Misfit of rounded dimensions',
  iterations: 'Iterations',
};

/** Groups that need a goal, and those that take their place where joints are driven. */
const OF_GOAL = ['translation', 'rotation', 'metric'];
const OF_DRIVERS = ['driven', 'path'];

/** Whether a motion has a group of charts. @param {string} group @param {Motion | null} motion */
export const isOffered = (group, motion) => !(drivesJoints(motion) ? OF_GOAL : OF_DRIVERS).includes(group);

/** How much larger than rounding the smallest extent of a scale is: what is told apart there is no rounding. */
const ABOVE_ROUNDING = 100;

/** A table with more rows than this is thinned. */
const MAX_ROWS = 500;

/** @param {Motion} motion @param {string | undefined} unit of length @returns {Chart[]} */
export function chartsOf(motion, unit) {
  const length = lengthUnit(unit);
  return (drivesJoints(motion) ? drivenCharts(motion, length) : goalCharts(motion, length)).concat(otherCharts(motion, length));
}

/** @param {string} group @param {ArrayLike<number>} values @param {string} of unit @param {Partial<Chart>} more @returns {Chart} */
const single = (group, values, of, more) => ({
  id: group,
  group,
  title: GROUPS[group],
  unit: of,
  series: [{ name: GROUPS[group], values }],
  zero: true,
  span: 0,
  ...more,
});

/** How far each frame is from its goal. @param {Motion} motion @param {string} length @returns {Chart[]} */
function goalCharts(motion, length) {
  const rounding = roundingGaps(motion);
  // What a goal that is met leaves is rounding: which frames those are is Rust's word.
  const met = Uint8Array.from({ length: motion.frames }, (_, frame) => Number(statusName(motion, frame) === 'reached'));
  const gap = (/** @type {Float64Array} */ values) => values.map((value, frame) => (met[frame] ? 0 : value));
  return [
    single('translation', gap(motion.translation_gap), length, { span: ABOVE_ROUNDING * rounding.shift }),
    single('rotation', gap(motion.rotation_gap).map(degrees), '°', { span: degrees(ABOVE_ROUNDING * rounding.turn) }),
    single('metric', gap(motion.metric), '', { span: ABOVE_ROUNDING ** 2 * motion.report.bounds.reached }),
  ];
}

/** The driven joints, and the way of the workpiece. @param {Motion} motion @param {string} length @returns {Chart[]} */
function drivenCharts(motion, length) {
  const charts = byKind(told.words.drivenSeries(motion), length).map(({ kind, ...rest }) => ({
    id: `driven ${kind}`, group: 'driven', title: rest.series.length === 1 ? `Driven joint, ${rest.series[0].name}` : `${GROUPS.driven}, ${kind}`, ...rest,
  }));
  return [...charts, { id: 'path', group: 'path', title: GROUPS.path, unit: length, span: LENGTH_SPAN, series: told.words.pathSeries(motion) }];
}

/** @param {Motion} motion @param {string} length @returns {Chart[]} */
function otherCharts(motion, length) {
  return [
    ...jointCharts(motion, length),
    single('sigma', motion.sigma_min, '', { log: true, zero: false, floor: 1e-12 }),
    single('closure', motion.closure, '', { log: true, zero: false }),
    single('misfit', motion.misfit, '', { log: true, zero: false }),
    single('iterations', motion.iterations, '', { steps: true, span: 4 }),
  ];
}

/** A chain's angles and lengths, each with a scale of its own. @param {Motion} motion @param {string} length @returns {Chart[]} */
function jointCharts(motion, length) {
  const width = motion.joints.length / motion.frames;
  let first = 0;
  return motion.report.chains.flatMap(({ name, variables }, chain) => {
    const at = first;
    first += variables.length;
    const series = variables.map(({ label, unit }, i) => ({
      name: subscript(label),
      unit,
      values: Float64Array.from({ length: motion.frames }, (_, frame) => inUnit(motion.joints[frame * width + at + i], unit)),
    }));
    return byKind(series, length).map(({ kind, ...rest }) => ({ id: `joints ${chain} ${kind}`, group: 'joints', title: `${chainName({ name }, chain)}, ${kind}`, ...rest }));
  });
}

const subscript = (/** @type {string} */ label) => label.replace(/\d/g, (digit) => '₀₁₂₃₄₅₆₇₈₉'[Number(digit)]);

/** @param {number} value @param {'rad' | 'length'} unit */
const inUnit = (value, unit) => (unit === 'rad' ? degrees(value) : value);

/** Smallest extent of a scale of lengths. */
const LENGTH_SPAN = 1e-3;

/** Angles and lengths apart. @param {(ChartSeries & {unit: 'rad' | 'length'})[]} series @param {string} length */
const byKind = (series, length) =>
  [
    { kind: 'angles', unit: '°', span: 1, series: series.filter((one) => one.unit === 'rad') },
    { kind: 'lengths', unit: length, span: LENGTH_SPAN, series: series.filter((one) => one.unit === 'length') },
  ].filter((one) => one.series.length > 0);

/** A value with the digits that its chart is read with, without the unit. @param {Chart} chart @param {number} value */
export function writeValue(chart, value) {
  if (chart.unit === '°') return short(value, 2);
  return chart.unit === '' ? scientific(value) : short(value);
}

/** @param {Chart} chart @param {number} value */
export const withUnit = (chart, value) => `${writeValue(chart, value)}${chart.unit === '°' || chart.unit === '' ? '' : ' '}${chart.unit}`;

/** A chart in words: "Translation gap: 0 to 0.1852 m, largest at frame 65." @param {Chart} chart */
export function summary(chart) {
  const spans = chart.series.map(({ name, values }) => {
    const worst = worstFrame(values);
    let least = worst;
    for (let frame = 0; frame < values.length; frame++) if (values[frame] < values[least]) least = frame;
    const [low, high] = [writeValue(chart, values[least]), withUnit(chart, values[worst])];
    const told = withUnit(chart, values[least]) === high ? `${high} at every frame` : `${low} to ${high}, largest at frame ${worst + 1}`;
    return chart.series.length > 1 ? `${name} ${told}` : told;
  });
  return `${chart.title}: ${spans.join('; ')}.`;
}

/** The frames that a table shows: all, or every n-th and the last. @param {number} frames */
export function tableFrames(frames) {
  const every = Math.ceil(frames / MAX_ROWS);
  const shown = [];
  for (let frame = 0; frame < frames; frame += every) shown.push(frame);
  if (shown.at(-1) !== frames - 1) shown.push(frames - 1);
  return { every, shown };
}

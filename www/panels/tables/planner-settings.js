/**
 * The planner's settings as fields: how it searches and how it measures.
 *
 * @typedef {import('../../core/store.js').Store} Store
 * @typedef {import('../../core/types.js').Defaults} Defaults
 */
import { length, lengthUnit } from '../../core/format.js';
import { html } from '../../ui/render.js';
import { pointCells, setting } from './settings.js';
import { METRICS, LENGTH_SOURCES } from '../../core/status-words.js';

/** What a motion in a metric is like, for someone who chooses one. @type {Record<string, string>} */
const MEANINGS = {
  pose: 'Shifts are measured from the goal’s own origin. The choice of the fixed frame changes nothing.',
  'dual-quaternion': 'The paper’s: shifts are measured from one fixed point, so that far from it turns are traded for shifts.',
};

/**
 * @param {Store} store
 * @param {ReturnType<typeof import('./cells.js').createCells>} cells
 * @param {Defaults} defaults
 */
export function plannerSettings(store, cells, defaults) {
  const { length_unit: unit, planner } = store.doc;
  const metric = planner?.metric ?? 'pose';
  const lengths = lengthUnit(unit);

  /** The metric's length of the shown motion, where it was planned in the metric that the document names. */
  const used = () => {
    const { motion, doc } = store.result;
    return motion && doc === store.doc ? motion.report.metric : null;
  };

  function lengthInWords() {
    const now = used();
    const weighs = 'A shift by this length weighs as much as a turn by 1 rad (57°).';
    return now ? `${weighs} In use: ${length(now.length, unit)}, ${LENGTH_SOURCES[now.length_source]}.` : weighs;
  }

  return html`<div class="settings">
    ${setting({
      label: 'Method',
      title: 'How the closest pose is searched for',
      control: cells.select({
        path: 'planner.method',
        label: 'planning method',
        options: [
          ['newton', 'Newton on the constraint wrenches'],
          ['gradient', "projected gradient (the paper's)"],
        ],
      }),
    })}
    ${setting({
      label: 'Metric',
      title: 'How the distance between the workpiece and its goal is measured',
      note: MEANINGS[metric],
      control: cells.select({
        path: 'planner.metric',
        label: 'metric, how the distance from the goal is measured',
        options: Object.entries(METRICS),
      }),
    })}
    ${setting({
      label: 'Metric length',
      title: 'How shifts are weighed against turns; empty: a length of the mechanism',
      note: lengthInWords(),
      control: cells.input({
        path: 'planner.metric_length',
        label: `characteristic length of the metric in ${lengths}, empty for a length of the mechanism`,
        optional: true,
        fallback: () => used()?.length,
      }),
    })}
    ${setting({
      label: 'Metric origin',
      title: 'The point, x y z in the fixed frame, from which the metric “dual quaternion” measures shifts',
      note: `${lengths}; empty: the origin of the fixed frame`,
      group: true,
      hidden: metric !== 'dual-quaternion',
      control: pointCells(cells, { path: 'planner.metric_origin', label: `point about which the metric measures, in ${lengths}`, fallback: () => [0, 0, 0] }),
    })}
    ${setting({
      label: 'Dimension tolerance',
      title: 'How far rounded dimensions of a linkage with more constraints than it needs may contradict each other',
      note: 'share of the mechanism’s size, and rad; 0: exact dimensions only',
      control: cells.input({
        path: 'planner.dimension_tolerance',
        label: 'tolerance of rounded dimensions, as a share of the mechanism’s size and in rad',
        optional: true,
        decimals: 8,
        fallback: () => Number(defaults.planner.dimension_tolerance),
      }),
    })}
    ${setting({
      label: 'Iterations',
      title: 'How many iterations a frame may take; empty: as many as the method allows',
      note: 'at most, each frame',
      control: cells.input({ path: 'planner.max_iterations', label: 'largest number of iterations', optional: true }),
    })}
  </div>`;
}

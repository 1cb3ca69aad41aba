/**
 * An iterate as a posture, so that the view shows it in place of the frame.
 *
 * @typedef {import('../../core/types.js').Trace} Trace
 */

/**
 * @param {Trace} trace @param {import('./algorithm-words.js').Method} method @param {number} at
 * @param {{reached: number}} bounds of the motion: `reached` is that of the metric at a goal that is met
 * @returns {import('../../core/types.js').Posture & {note: string}}
 */
export function postureOf(trace, method, at, { reached }) {
  const history = trace[method];
  const count = history.iteration.length;
  const group = (/** @type {Float64Array} */ column) => {
    const width = column.length / count;
    return column.subarray(at * width, (at + 1) * width);
  };
  const pose = group(history.pose);
  const { goal } = trace;
  const turn = Math.abs(pose[3] * goal[3] + pose[4] * goal[4] + pose[5] * goal[5] + pose[6] * goal[6]);
  const arrived = at === count - 1 && history.converged;
  const metric = history.metric[at];
  return {
    note: at === 0 ? 'Start of the iterations.' : `Iterate ${history.iteration[at]} of ${history.last}, ${method}.`,
    joints: group(history.joints),
    pose,
    rows: group(history.rows),
    goal,
    // Only the last iterate is an answer.
    status: !arrived ? 'stalled' : metric <= reached ? 'reached' : 'closest',
    metric,
    translation_gap: Math.hypot(pose[0] - goal[0], pose[1] - goal[1], pose[2] - goal[2]),
    rotation_gap: 2 * Math.acos(Math.min(1, turn)),
    closure: history.closure[at],
    misfit: history.misfit[at],
    // ‖a‖ of the gradient method is another measure than a posture's.
    projected_gradient: method === 'newton' ? history.projected_gradient[at] : NaN,
    iterations: history.iteration[at],
    sigma_min: history.sigma_min[at],
  };
}

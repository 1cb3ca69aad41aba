/**
 * What new parts of a document are made of: the format's defaults, which the planner has too. They stand here because the
 * tables need them before anybody asks for anything.
 *
 * @typedef {import('./types.js').Defaults} Defaults
 */
const row = { alpha: 0, a: 0, theta: 0, d: 0 };
const across = { ...row, alpha: 90 };
const frame = { x: 0, y: 0, z: 0, longitude: 0, latitude: 0, roll: 0 };
const key_frame = { name: '', ...frame };

/** @type {Defaults['joints']} */
const joints = {
  R: { type: 'R', rows: [row] },
  P: { type: 'P', rows: [row] },
  C: { type: 'C', rows: [row] },
  T: { type: 'T', rows: [row, across] },
  S: { type: 'S', rows: [row, across, { ...row, alpha: -90 }] },
  E: { type: 'E', rows: [row, { ...across, theta: 90 }, across] },
};

/** @type {Defaults} */
export const DEFAULTS = {
  joints,
  frame,
  key_frame,
  chain: { name: '', base: frame, joints: [joints.R, { type: 'P', rows: [across] }, joints.S], gripper: frame },
  motion: {
    key_frames: [
      { ...key_frame, x: 1 },
      { ...key_frame, y: 1, z: 0.5, roll: 90 },
    ],
    interpolation: 'bezier',
    frames: 33,
    reference: null,
    radius: null,
  },
  planner: { method: 'newton', metric: 'pose', metric_length: null, metric_origin: null, dimension_tolerance: 0.0003, max_iterations: null },
};

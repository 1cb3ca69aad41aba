/**
 * Types of what the planner's searches give: the best motion, and the ways to assemble.
 *
 * @typedef {import('./types.js').Motion} Motion
 *
 * @typedef {{mean: number, largest: number, largest_step: number}} MotionCost
 * @typedef {{first: number, metric: Float64Array}} Branch
 * @typedef {{frame: number, time: number, from: number, to: number, length: number, largest: number, points: number}} Switch
 * @typedef {{price: number, mean: number, largest: number, largest_step: number}} CalmPoint
 * @typedef {{motion: Motion, mean: number, largest: number, largest_step: number}} CalmMotion
 * @typedef {{points: number, frame: Int32Array, time: Float64Array, metric: Float64Array, closure: Float64Array,
 *   joints: Float64Array, pose: Float64Array, rows: Float64Array}} BestPath
 * @typedef {{progress: number, starts: number, followed: MotionCost, best: MotionCost, lower_bound: number, unseen: number,
 *   unseen_bound: number, branches: Branch[], lane: Int32Array, switches: Switch[], curve: CalmPoint[], found_where_lost: number[]}} Best
 * @typedef {{index: number, joints: Float64Array, rows: Float64Array, pose: Float64Array, metric: number, reached: boolean,
 *   starts: number, is_start: boolean, mean?: number, largest?: number, certified?: number}} Mode
 * @typedef {{key: number, progress: number, starts: number, unseen: number, unseen_bound: number, found: Mode[]}} Modes
 */
export {};

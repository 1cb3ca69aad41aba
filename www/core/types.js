/**
 * The page's types. What Rust returns is typed by the built package; what a person may have typed is here.
 *
 * @typedef {import('../pkg/synthetica.js').Motion} Motion
 * @typedef {import('../pkg/synthetica.js').Progress} Progress
 * @typedef {import('../pkg/synthetica.js').MakeRequest} MakeRequest
 * @typedef {import('../pkg/synthetica.js').ExportOptions} ExportOptions
 * @typedef {'csv' | 'json' | 'mjcf'} ExportFormat what a motion is written as; mjcf is a model for MuJoCo
 * @typedef {import('../pkg/synthetica.js').PoseTableRequest} PoseTableRequest
 * @typedef {import('../pkg/synthetica.js').PoseTable} PoseTable
 * @typedef {import('../pkg/synthetica.js').Maker} Maker
 * @typedef {import('../pkg/synthetica.js').Report} Report
 * @typedef {import('../pkg/synthetica.js').Fault} Fault
 * @typedef {import('../pkg/synthetica.js').Posture} Posture
 * @typedef {import('../pkg/synthetica.js').Insight} Insight
 * @typedef {import('../pkg/synthetica.js').Trace} Trace
 * @typedef {import('../pkg/synthetica.js').History} History
 * @typedef {import('../pkg/synthetica.js').Matrix} Matrix
 * @typedef {import('../pkg/synthetica.js').MetricGaps} MetricGaps
 * @typedef {import('../pkg/synthetica.js').Enumeration} Enumeration
 * @typedef {import('../pkg/synthetica.js').Best} Best
 * @typedef {import('../pkg/synthetica.js').BestPath} BestPath
 * @typedef {import('../pkg/synthetica.js').CalmMotion} CalmMotion
 * @typedef {import('../pkg/synthetica.js').CalmPoint} CalmPoint
 * @typedef {import('../pkg/synthetica.js').MotionCost} MotionCost
 * @typedef {import('../pkg/synthetica.js').Branch} Branch
 * @typedef {import('../pkg/synthetica.js').Switch} Switch
 * @typedef {import('../pkg/synthetica.js').Modes} Modes
 * @typedef {import('../pkg/synthetica.js').Mode} Mode
 *
 * A number as typed: text that is no number stays text, so that Rust can refuse it by name and
 * the person can mend it.
 * @typedef {number | string} Entry
 *
 * @typedef {'R' | 'P' | 'C' | 'T' | 'S' | 'E'} JointType
 * @typedef {{alpha?: Entry, a?: Entry, theta?: Entry, d?: Entry}} Row  degrees, length
 * @typedef {{min?: Entry | null, max?: Entry | null}} Limit
 * @typedef {{type: JointType, rows?: Row[], limits?: (Limit | null)[] | null, point?: Entry[], axis?: Entry[], second?: Entry[]}} Joint
 *   by its rows, or by a point and the directions of its axes at the home position
 * @typedef {{x?: Entry, y?: Entry, z?: Entry, longitude?: Entry, latitude?: Entry, roll?: Entry} & Turn} Frame
 * @typedef {{quaternion_wxyz?: Entry[], quaternion_xyzw?: Entry[], matrix?: Entry[][], roll_pitch_yaw?: Entry[], order?: string}} Turn
 *   one of them in place of the three angles
 * @typedef {{name?: string, base?: Frame, joints: Joint[], gripper?: Frame, start?: Entry[] | null, convention?: string}} Chain
 * @typedef {Frame & {name?: string, time?: Entry | null}} KeyFrame
 * @typedef {{key_frames?: KeyFrame[], drivers?: Driver[], interpolation?: string, frames?: Entry, reference?: Entry[] | null, radius?: Entry | null}} MotionSpec
 * @typedef {{chain: Entry, joint: Entry, freedom?: Entry, values: {time: Entry, value: Entry}[], ramp?: string}} Driver counted from 1
 * @typedef {{method?: string, metric?: string, metric_length?: Entry | null, metric_origin?: Entry[] | null,
 *   dimension_tolerance?: Entry, max_iterations?: Entry | null}} PlannerSpec
 * @typedef {{$schema?: string, version: number, name?: string, about?: string, length_unit?: string, angles?: string,
 *   parameters?: Record<string, Entry>, home?: Frame, chains: Chain[],
 *   motion: MotionSpec, planner?: PlannerSpec}} MechanismDocument
 *
 * What new things start from.
 * @typedef {{joints: Record<JointType, Joint>, frame: Frame, key_frame: KeyFrame, chain: Chain,
 *   motion: Partial<MotionSpec>, planner: PlannerSpec}} Defaults
 *
 * The last good motion with the document that it belongs to, and the plain document that this stands for (the same, where
 * it has no expressions, axes or other conventions); the fault, if the present document has one;
 * `trouble`, if the planner itself failed; `again`, if somebody waits for that to end, to ask once more.
 * @typedef {{motion: Motion | null, doc: MechanismDocument | null, plain: MechanismDocument | null, fault: Fault | null, trouble: string, again: boolean}} Result
 *
 * A plan that takes long: how far it is; `stop` ends it with what there is so far.
 * @typedef {Progress & {stop: () => void}} Planning
 *
 * Where a document came from, shared by all its edits: what its file is called, the file itself where the browser
 * gives access to it, and the document as it stands there; null where only this browser has it.
 * @typedef {{title: string, handle: FileSystemFileHandle | null, saved: MechanismDocument | null}} Origin
 *
 * Why the workpiece rests where it is shown: Rust's answer, with the columns and the index that it was asked for.
 * @typedef {Insight & {of: {doc: MechanismDocument, joints: Float64Array, goal: Float64Array, index: number}}} Why
 *
 * What is looked at. `posture` is shown in place of the frame while the linkage is moved by hand (pulled or taught) or
 * by an algorithm, which then has a `note` that says so;
 * playing, scrubbing or an edit ends it. `selected` and `hovered` are places of the document, such as `chains[1]`,
 * `chains[1].joints[0]` or `motion.key_frames[2]`, or `workpiece`; empty for nothing. `charts` are groups of charts
 * (panels/charts/chart-list.js); `speed` is a factor; `loop` is what the player does at the end; `side` is the standard
 * view that is looked from, until it is turned by hand; `moving` is the place of
 * what a hand moves, until it rests or lets go; `ghosts`
 * are the frames at which the workpiece is drawn too: at the key frames, spread evenly, or these.
 * @typedef {{frame: number, playing: boolean, moving: string, posture: (Posture & {note?: string}) | null, selected: string, hovered: string,
 *   speed: number, loop: 'once' | 'loop' | 'bounce',
 *   side: keyof typeof import('./standard-views.js').STANDARD_VIEWS | '', charts: string[],
 *   projection: 'perspective' | 'orthographic', show: Shown, ghosts: 'none' | 'keys' | 'spread' | number[],
 *   only: boolean}} View
 *
 * What the 3D view draws beside the linkage.
 * @typedef {{goal: boolean, closest: boolean, gaps: boolean, names: boolean, axes: boolean, ground: boolean,
 *   holds: boolean, freedoms: boolean}} Shown
 */
export {};

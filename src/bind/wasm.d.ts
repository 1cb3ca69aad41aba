/** A fault of a document: a person can mend it. */
export interface Fault {
  code: string;
  /** A sentence: where, what, and what would be accepted. */
  message: string;
  /** The first part of the sentence, where and what, without a stop at the end. */
  what: string;
  /** JSON path such as chains[1].joints[0].rows[0].alpha; empty for the whole document. */
  where: string;
  /** What would be accepted there, without a stop at the end. */
  accepted: string;
  /** Null, an empty cell of the page, would be accepted too. */
  optional?: true;
  line?: number;
  column?: number;
}

/** What an expression of a document is. */
export interface ExpressionValue {
  /** Such as `chains[0].base.x`. */
  path: string;
  /** An angle is in the document's unit of angles. */
  value: number;
}

/** A number with a name. */
export interface Parameter {
  name: string;
  /** A length, an angle in the document's unit of angles, or a share. */
  value: number;
  /** It is given as a number, and not as an expression. */
  input: boolean;
}

/** A planned motion. Numbers are copies; groups of several numbers a frame lie frame by frame. Lengths are in the
 * document's unit where nothing else is said. Where joints are driven (report.drivers) there is no goal: goal, metric,
 * translation_gap, rotation_gap and projected_gradient are NaN in all frames. */
export interface Motion {
  frames: number;
  /** Planning was stopped before the last frame: the columns end where it was. */
  partial: boolean;
  /** Frames of the whole motion: more than `frames` in a partial one. */
  goal_frames: number;
  report: Report;
  /** Of a document with expressions, axes or other conventions: the plain document that it stands for. */
  plain?: any;
  /** Of the same: its parameters. */
  parameters?: Parameter[];
  /** The value of each expression in the document as it was typed, but for those of its parameters; likewise. */
  expressions?: ExpressionValue[];
  /** What planning took, without the copying of the result. */
  milliseconds: number;
  /** Time of each frame. */
  time: Float64Array;
  /** How the frame ended: index into report.statuses. */
  status: Uint8Array;
  /** Reached pose. Seven numbers: x y z, then the rotation's quaternion x y z w. */
  pose: Float64Array;
  /** Goal. Seven numbers: x y z, then the rotation's quaternion x y z w. */
  goal: Float64Array;
  /** Joint values, chain by chain. In rad or lengths. */
  joints: Float64Array;
  /** Distance from the goal: ½‖q − g‖² in the metric of the report. */
  metric: Float64Array;
  /** Distance from goal to reached origin. */
  translation_gap: Float64Array;
  /** Angle from goal to reached rotation. In rad. */
  rotation_gap: Float64Array;
  /** How far the loops are open: lengths as shares of the mechanism's size, or rad; see report.bounds. */
  closure: Float64Array;
  /** By how much rounded dimensions contradict each other, as closure; 0 where they agree. */
  misfit: Float64Array;
  /** Smallest singular value of [A] that is not 0 because of surplus constraints: lengths as shares of the size, about the workpiece's origin. */
  sigma_min: Float64Array;
  /** A bound of the projected gradient's norm: lengths as shares of the size, or of the metric's length with the gradient planner; see report.bounds. */
  projected_gradient: Float64Array;
  /** Linear systems solved. */
  iterations: Uint32Array;
  /** For drawing: every table row's frame before its joint and behind it, in the fixed frame. 14 numbers a row: two poses. */
  rows: Float64Array;
}

/** How far a plan is. */
export interface Progress {
  /** Frames planned so far; falls where frames are planned again because of a leap. */
  done: number;
  /** Frames in all. */
  frames: number;
}

export interface Report {
  statuses: ["reached", "closest", "at_limit", "stalled", "closure_lost", "passing"];
  chains: ChainReport[];
  /** The driven joint variables, counted from 0 through all chains: none, or not there, where the motion has goals. */
  drivers?: number[];
  /** Eq. 10. */
  mobility_count: number;
  /** n − rank [A] at the start. */
  mobility_rank: number;
  metric: MetricReport;
  bounds: BoundsReport;
  /** Largest misfit of rounded dimensions in any frame. */
  misfit: number;
  /** Frames count from 0. */
  warnings: { code: string; message: string; first?: number; last?: number }[];
  /** Joint values planned from, degrees or lengths, chain by chain. */
  start: number[][];
}

/** How distances from the goal were measured. */
export interface MetricReport {
  kind: "pose" | "dual-quaternion";
  /** The characteristic length: a translation by it weighs as much as a rotation by 1 rad. */
  length: number;
  /** Where it comes from: the document; the mechanism's size; the extent of the motion of a mechanism without lengths; or
   * neither has any, and it is 1. */
  length_source: "given" | "mechanism" | "motion" | "none";
  /** The point about which dual-quaternion measures, in the fixed frame. */
  origin?: [number, number, number];
}

/** The bounds by which frames were judged: lengths as shares of the mechanism's size, angles in rad. */
export interface BoundsReport {
  /** Of closure. */
  closure: number;
  /** Of misfit: the document's dimension_tolerance. */
  misfit: number;
  /** Of projected_gradient, in certified frames. */
  projected_gradient: number;
  /** The least curvature of ½‖q − g‖² in certified frames is not below this number's negative. */
  curvature: number;
  /** Of metric, in frames that reached their goal. */
  reached: number;
}

export interface ChainReport {
  name: string;
  type: string;
  freedoms: number;
  constraints: number;
  category: "I" | "II" | "III" | "IV" | "V";
  variables: { label: string; unit: "rad" | "length"; joint: number; row: number }[];
  rows: { kind: JointType; joint: number }[];
}

export type JointType = "R" | "P" | "C" | "T" | "S" | "E";

/** One position of the linkage, outside any motion: pulled or driven by hand. Columns as in Motion, of one frame; the goal
 * is the pose pulled at, or the reached pose itself where a joint was driven. */
export interface Posture {
  /** Reached pose. Seven numbers: x y z, then the rotation's quaternion x y z w. */
  pose: Float64Array;
  /** Goal. Seven numbers: x y z, then the rotation's quaternion x y z w. */
  goal: Float64Array;
  /** Joint values, chain by chain. In rad or lengths. */
  joints: Float64Array;
  /** Distance from the goal: ½‖q − g‖² in the metric of the report. */
  metric: number;
  /** Distance from goal to reached origin. */
  translation_gap: number;
  /** Angle from goal to reached rotation. In rad. */
  rotation_gap: number;
  /** How far the loops are open: lengths as shares of the mechanism's size, or rad; see report.bounds. */
  closure: number;
  /** By how much rounded dimensions contradict each other, as closure; 0 where they agree. */
  misfit: number;
  /** Smallest singular value of [A] that is not 0 because of surplus constraints: lengths as shares of the size, about the workpiece's origin. */
  sigma_min: number;
  /** A bound of the projected gradient's norm: lengths as shares of the size, or of the metric's length with the gradient planner; see report.bounds. */
  projected_gradient: number;
  /** Linear systems solved. */
  iterations: number;
  /** Name of the status, one of Report.statuses. */
  status: Report["statuses"][number];
  /** For drawing: every table row's frame before its joint and behind it. 14 numbers a row: two poses. */
  rows: Float64Array;
  /** Of a driven joint: the value that it got, rad or length; less than asked where the linkage cannot follow. */
  value?: number;
  /** Of a driven joint that did not get its value: why, as a sentence. */
  obstacle?: string;
}

/** A screw: its axis passes through `point` along `direction` (unit, fixed frame); pitch in length per rad. */
export interface Screw {
  /** (v, ω) of the workpiece's origin, in the fixed frame; ω or, for a shift, v has unit length. */
  twist: number[];
  /** The axis's point nearest to the workpiece's origin; for a shift the origin itself. */
  point: number[];
  direction: number[];
  /** null for a pure shift along `direction`; 0 for a pure turn. */
  pitch: number | null;
}

/** What holds the workpiece at a posture, and what leaves it free. */
export interface Insight {
  /** A basis of the instantaneous freedoms of the workpiece here, joint limits aside: shifts, then the principal
   * screws of the rest by growing pitch. */
  freedoms: Screw[];
  /** Singular values of [A] here, largest first: lengths as shares of the mechanism's size, about the workpiece's origin. */
  singular_values: number[];
  /** n − rank [A] here: inner freedoms of the chains included, so it may be more than freedoms.length. */
  mobility_rank: number;
  /** The certificate, lengths as shares of the size: the norm of the projected gradient, which is at most `stationary`
   * where a pose is called closest. Joints that the goal's pull presses against a limit count as held here and below. */
  projected_gradient: number;
  stationary: number;
  /** The least curvature in the free directions (null: none is free), which is at least −`flat` at a closest pose. */
  least_curvature: number | null;
  flat: number;
  /** The remaining gap as a twist (v, ω) from reached pose to goal. */
  gap: number[];
  /** The free twist that would bring the pose nearest to the goal in the metric, to first order: it vanishes with the
   * projected gradient. */
  free_part: number[];
  /** gap − free_part. */
  blocked_part: number[];
  /** Which chain holds the workpiece back: the wrench (force, moment about the workpiece's origin) with which it
   * balances the goal's pull −∂f/∂ξ, limits included, and its share of the sum of all (0 to 1; all 0 where nothing is
   * held back). An overconstrained linkage can split the load in many ways: the one with the least sum of squares. */
  chains: { wrench: number[]; share: number }[];
  /** The joint variables that the goal's pull presses against a limit, counted from 0 through all chains: at their
   * largest value, or at their smallest. */
  held: { variable: number; largest: boolean }[];
}

/** The iterates of one method at one frame: those of the first 60 iterations, later ones ever further apart, the last. */
export interface History {
  /** Number of each iterate that is kept; 0 is where the method starts. */
  iteration: Uint32Array;
  /** Columns as in Motion, one group an iterate. */
  joints: Float64Array;
  pose: Float64Array;
  rows: Float64Array;
  /** f = ½‖q − g‖². */
  metric: Float64Array;
  /** |a| of Eq. 31. */
  projected_gradient: Float64Array;
  /** How far the loops are open: lengths as shares of the mechanism's size, or rad. */
  closure: Float64Array;
  misfit: Float64Array;
  sigma_min: Float64Array;
  /** Of the gradient, how the iterate was reached: the share of the null-space step that was taken, */
  share: Float64Array;
  /** the largest entry of E behind it, */
  opening: Float64Array;
  /** the number of corrections by Eq. 28, */
  corrections: Float64Array;
  /** and their length together. */
  correction: Float64Array;
  /** Of Newton: 1 where a guarded step led here, 0 where loops are closed and the goal approached at once. */
  guarded: Uint8Array;
  /** Number of the last iterate. */
  last: number;
  converged: boolean;
}

/** Both planners at one frame, from the same position. */
export interface Trace {
  /** 7 numbers. */
  goal: Float64Array;
  /** f at the certified minimum; undefined if there is none. */
  minimum?: number;
  gradient: History;
  newton: History;
}

/** [A] of Eq. 21 at one position: lengths in units of the metric's, about the point about which the metric measures. */
export interface Matrix {
  /** Row by row. */
  values: number[];
  rows: number;
  columns: number;
  /** Joint variables of each chain: the first columns; 8 of q follow. The rows are 6 a chain, and 2 conditions on q. */
  freedoms: number[];
  /** Largest first. */
  singular_values: number[];
  /** Below it a singular value counts as zero. */
  threshold: number;
  rank: number;
}

/** The largest gaps of a motion that was planned with one metric. */
export interface MetricGaps {
  metric: MetricReport["kind"];
  /** The metric's characteristic length. */
  length: number;
  /** NaN, as `rotation_gap`, where joints are driven: there is no goal. */
  translation_gap: number;
  /** In rad. */
  rotation_gap: number;
}

/** Parts of documents with their defaults; `document` is the text of a whole one. */
export interface Defaults {
  document: string;
  joints: Record<JointType, object>;
  frame: object;
  key_frame: object;
  chain: object;
  motion: object;
  planner: object;
}

/** How a motion is written. */
export interface ExportOptions {
  /** Of CSV: units behind the names, as x[mm], none, or in a row of their own below the names; "units" without. */
  headings?: 'units' | 'plain' | 'two-rows';
  /** Of a MuJoCo model: gravity along −z, in the document's unit of length; none without. */
  gravity?: boolean;
}

/** What is known of a table of poses, for `read_poses`; all of it is optional. */
export interface PoseTableRequest {
  convention?: 'positions' | 'longitude_latitude_roll' | 'quaternion_wxyz' | 'quaternion_xyzw' | 'matrix' | 'roll_pitch_yaw';
  /** Of three angles: lower case about fixed axes, upper case about moving ones; "xyz" without. */
  order?: string;
  /** Degrees without, where no heading says otherwise. */
  angles?: 'degrees' | 'radians';
  /** Whether the table has times; without headings in its first column with numbers. */
  time?: boolean;
  /** Factor of lengths, from the table's unit to the document's. */
  scale?: number;
}

/** A table of poses as it was read. */
export interface PoseTable {
  /** As a document has them, angles in degrees. */
  key_frames: { name: string; x: number; y: number; z: number; longitude: number; latitude: number; roll: number; time?: number }[];
  understood: {
    separator: 'tab' | 'semicolon' | 'comma' | 'blanks';
    header: boolean;
    convention: NonNullable<PoseTableRequest['convention']>;
    order: string | null;
    angles: 'degrees' | 'radians';
    time: boolean;
    scale: number;
    /** From left to right; `role` such as x, qw, time or name, empty where a column is not read. */
    columns: { heading: string; role: string }[];
    /** What could have been understood otherwise, in sentences. */
    assumed: string[];
  };
  /** The first 100 rows that cannot be taken over, by their line, from 1. */
  skipped: { row: number; what: string; accepted: string }[];
  skipped_count: number;
}

/** What `make` makes a linkage from: a type, and either no size or all of them, in the unit that is named. */
export interface MakeRequest {
  /** Such as 3-PRS or RPS + 2TS. */
  type: string;
  /** Radius of the circle on which the legs stand. */
  base_radius?: number;
  /** Radius of the circle on which they hold the workpiece. */
  platform_radius?: number;
  /** Height of the workpiece above the base at the start; in place of leg_length. */
  height?: number;
  /** From the joint at the base of a leg to the joint at its end, at the start; of a leg that begins with a slider, from
   * the joint on the slider. */
  leg_length?: number;
  /** Label of the unit of length; m where it is not given. */
  length_unit?: string;
}

/** A mechanism that is made from the few numbers of its paper. */
export interface Maker {
  name: string;
  /** Other names. */
  also: string[];
  title: string;
  group: string;
  /** Where the default numbers are from. */
  source: string;
  about: string;
  /** The unit of the default lengths. */
  unit: string;
  /** By rank, at the home position. */
  mobility: number;
  inputs: MakerInput[];
  /** Expressions whose values must be above 0, and what is wrong where they are not. */
  requires: { positive: string; else: string }[];
}

/** A number that a maker asks for, or several with commas between them. */
export interface MakerInput {
  name: string;
  /** The names of the numbers where there are several. */
  parts: string[];
  /** The default: one number, one for each part, or the entries of a list. */
  value: number[];
  is: "length" | "angle" | "number" | "count" | "list";
  /** Whether a length may be 0 or negative. */
  signed: boolean;
  range: [number, number] | null;
  meaning: string;
}

/** Tables 2 and 3. */
export interface Enumeration {
  classes: { category: "I" | "II" | "III" | "IV"; constraints: number; name: string; count: number; chains: string[] }[];
  assemblies: { constraints: number; total: number; categories: { name: string; count: number }[] }[];
}

/** The search for the best motion so far. Frames count from 0. */
export interface Best {
  /** 0 to 1; 1 when complete. */
  progress: number;
  /** Starts made so far. */
  starts: number;
  /** The motion that the planner follows. */
  followed: MotionCost;
  /** The best motion found so far: the followed one until branches are known. It may be farther where the followed one leaps
   * as no linkage can. */
  best: MotionCost;
  /** Mean over the frames of the least distance seen at each: no motion over the branches known is closer. */
  lower_bound: number;
  /** Good and Turing's estimate of the share of starts that lead to a branch not known yet. */
  unseen: number;
  /** That share is at most this, with a confidence of 95 %. */
  unseen_bound: number;
  /** Runs of frames; the first is the followed motion. */
  branches: Branch[];
  /** The branch of each frame of the best motion; -1 where there is none. */
  lane: Int32Array;
  /** Where the best motion changes its branch. */
  switches: Switch[];
  /** From closer to calmer: prices rise. Empty until the search is complete. */
  curve: CalmPoint[];
  /** Frames in which the followed motion has no certified pose, and the best motion has one. */
  found_where_lost: number[];
}

/** How close a motion comes to its goals. */
export interface MotionCost {
  /** Mean of ½‖q − g‖² over the frames. */
  mean: number;
  /** The largest of any frame. */
  largest: number;
  /** Largest joint motion from frame to frame, in rad or sizes of the mechanism. */
  largest_step: number;
}

/** A run of frames on one branch. */
export interface Branch {
  /** Its first frame. */
  first: number;
  /** ½‖q − g‖², frame by frame; above 512 frames linear between those that are searched. */
  metric: Float64Array;
}

/** A change of branch: a closed walk while the goal stands. */
export interface Switch {
  /** It comes before this frame; before frame 0 it comes after the start. */
  frame: number;
  time: number;
  /** The branches before it and behind it. */
  from: number;
  to: number;
  /** Joint motion on the way: root of squares, in rad and sizes of the mechanism. */
  length: number;
  /** Largest ½‖q − g‖² on the way. */
  largest: number;
  /** Points on the way, the frame's own included. */
  points: number;
}

/** The calm form at a price of joint motion. */
export interface CalmPoint extends MotionCost {
  price: number;
}

/** The calm form at a price of joint motion, frame by frame. */
export interface CalmMotion extends MotionCost {
  motion: Motion;
}

/** All points of the best motion, in order. */
export interface BestPath {
  points: number;
  /** The frame whose own point it is; -1 between frames. */
  frame: Int32Array;
  time: Float64Array;
  metric: Float64Array;
  closure: Float64Array;
  joints: Float64Array;
  /** As in Motion. */
  pose: Float64Array;
  rows: Float64Array;
}

/** All ways to assemble at a key frame, as far as they are found. */
export interface Modes {
  /** The key frame, and the frame at its time. */
  key: number;
  frame: number;
  /** 0 to 1; the search is the first half, planning from each way the second. */
  progress: number;
  starts: number;
  /** Good and Turing's estimate of the share of starts that lead to a way not known yet, and its bound with a confidence of 95 %. */
  unseen: number;
  unseen_bound: number;
  /** Nearest first; when all are planned those with most certified frames, and of these the closest on average, first. */
  found: Mode[];
}

/** A way to assemble. */
export interface Mode {
  index: number;
  /** Rad or lengths, chain by chain. */
  joints: Float64Array;
  /** The same as a document has them: degrees or lengths. */
  start: number[][];
  /** As in Motion, of one frame. */
  rows: Float64Array;
  pose: Float64Array;
  /** ½‖q − g‖² at the key frame. */
  metric: number;
  reached: boolean;
  /** Starts that led to it. */
  starts: number;
  /** It is the assembly of the document's start. */
  is_start: boolean;
  /** Of the motion planned from it; not there before: mean and largest ½‖q − g‖², certified frames. */
  mean?: number;
  largest?: number;
  certified?: number;
}

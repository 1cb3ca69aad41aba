//! The result of a plan as columns: one entry, or one fixed-length group, a frame.

use crate::math::metric::Metric;
use crate::math::pose::Pose;
use serde::{Deserialize, Serialize};
use std::borrow::Cow;

/// How a frame ended. Only frames of the first three are answers to the question asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Status {
    /// The goal is met.
    Reached,
    /// The closest reachable pose: a certified local minimum of the distance.
    Closest,
    /// The same, and a joint limit holds the linkage back.
    AtLimit,
    /// Closed loops, but not certified as closest.
    Stalled,
    /// No closed position was found; the frame repeats the last closed one.
    ClosureLost,
    /// Closed loops on the way of a motion that gives up closeness for calm, or changes its branch: not the closest pose by
    /// itself.
    Passing,
}

impl Status {
    /// All, in the order of their codes.
    pub const ALL: [Self; 6] = [
        Self::Reached,
        Self::Closest,
        Self::AtLimit,
        Self::Stalled,
        Self::ClosureLost,
        Self::Passing,
    ];

    /// The name in reports.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Reached => "reached",
            Self::Closest => "closest",
            Self::AtLimit => "at_limit",
            Self::Stalled => "stalled",
            Self::ClosureLost => "closure_lost",
            Self::Passing => "passing",
        }
    }

    /// Is the frame a certified optimum?
    pub const fn is_certified(self) -> bool {
        matches!(self, Self::Reached | Self::Closest | Self::AtLimit)
    }
}

/// Two key frames that follow each other.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Neighbours {
    /// The later of the two, from 0.
    pub key: usize,
    /// Their names, which may be empty.
    pub names: [String; 2],
}

/// Something that worked, but deserves a look. Joint variables count from 0 through all chains, frames from 0.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[expect(missing_docs, reason = "the fields are what the variants speak of")]
pub enum Warning {
    /// The start's loops were open, and were closed by moving a joint variable by `moved` (rad or a length).
    StartMoved { moved: f64, variable: usize },
    /// A given start value (rad or a length) was beyond this limit of the joint variable, and was moved to it.
    StartOutsideLimits {
        variable: usize,
        value: f64,
        limit: f64,
    },
    /// The start's loops could not be closed; `error` is how far they are open, lengths as shares of the size.
    StartOpen { error: f64 },
    /// The start is nearly closed, open by `error`, and no closed position is near; the nearest that was found is a joint
    /// motion of `leap` (rad or sizes) away. With these dimensions the linkage is rigid, or does not fit together.
    StartRigid { error: f64, leap: Option<f64> },
    /// The dimensions of an overconstrained linkage contradict each other by up to `misfit` (rad or shares of the size);
    /// where it is more than `tolerance`, frames are not certified.
    RoundedDimensions {
        misfit: f64,
        tolerance: f64,
        suspect: Option<Suspect>,
    },
    /// The axis of a joint, counted from 0 in its chain, is parallel to the one before but for `angle` (rad), and was made
    /// parallel.
    #[cfg(feature = "study")]
    NearlyParallel {
        chain: usize,
        joint: usize,
        angle: f64,
    },
    /// Read as standard tables (Z·X) the rows close the loops and meet the first key frame at the given start; as they
    /// are read they do not.
    #[cfg(feature = "study")]
    StandardTable,
    /// The gradient planner takes rounded dimensions as they are, and finds no closed position.
    RoundedUnknown,
    /// The linkage leaps at `time`, between frames `first` and `first + 1`: the joint variable `variable` moves by
    /// `moved` (rad or a length) at once.
    BranchJump {
        first: usize,
        time: f64,
        moved: f64,
        variable: usize,
    },
    /// Frames `first` to `last` are close to a singular position: the smallest singular value falls
    /// to `smallest`.
    NearSingular {
        first: usize,
        last: usize,
        smallest: f64,
        /// Below which a position is called close to a singular one.
        bound: f64,
    },
    /// In frames `first` to `last` the distance to the goal keeps falling while a slider without limits runs away.
    /// At `searched` of them other positions, which closed walks join to this one, were tried.
    /// `elsewhere`: at one of them another assembly, to which no motion was found, comes closer at a finite place.
    Runaway {
        first: usize,
        last: usize,
        searched: usize,
        elsewhere: bool,
    },
    /// The gradient planner does not keep joint limits; frames beyond one are not certified.
    LimitsUnknown,
    /// The mobility by rank differs from the count of Eq. 10.
    MobilityDiffers { count: isize, rank: usize },
    /// The metric's length is far off the linkage's lengths, or its motion's extent where it has none.
    MetricLength { given: f64, proposed: f64 },
    /// Two key frames are half a turn apart, so that both ways are equally long; the workpiece turns
    /// about `axis`, a unit vector in the fixed frame, by the right-hand rule.
    HalfTurn {
        neighbours: Neighbours,
        axis: [f64; 3],
    },
    /// Two key frames have the same rotation although `angle` (longitude, latitude or roll) differs by
    /// `typed` rad, a full turn or more: nothing turns between them, and nothing moves unless the
    /// workpiece `slides`.
    FullTurn {
        neighbours: Neighbours,
        angle: Cow<'static, str>,
        typed: f64,
        slides: bool,
    },
    /// `angle` (longitude, latitude or roll) of two key frames differs by `typed` rad, more than half a
    /// turn; the workpiece turns the short way, by `turn` rad.
    ShortWay {
        neighbours: Neighbours,
        angle: Cow<'static, str>,
        typed: f64,
        turn: f64,
    },
    /// `count` more of the last three are left out.
    MoreNotes { count: usize },
    /// In frames `first` to `last` driven joints stop short of their values: at `time`, with these values of the driven
    /// variables (rad or lengths).
    #[cfg(feature = "study")]
    DriveEnds {
        first: usize,
        last: usize,
        time: f64,
        why: DriveEnd,
        driven: Vec<(usize, f64)>,
    },
    /// A driven variable that the drivers before it leave no freedom: it is not driven, and its values are met only where
    /// the others lead to them.
    #[cfg(feature = "study")]
    DriverDependent { variable: usize },
    /// So many freedoms of the linkage are not driven.
    #[cfg(feature = "study")]
    UndrivenFreedoms { count: usize },
    /// Before frame `frame`, at these values of the driven variables, the linkage can go on in several ways; the one with
    /// the least motion of the joints was taken.
    #[cfg(feature = "study")]
    BranchChosen {
        frame: usize,
        driven: Vec<(usize, f64)>,
    },
}

/// Why driven joints stop short of their values. Joint variables count from 0 through all chains.
#[cfg(feature = "study")]
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum DriveEnd {
    /// Limits of driven joints themselves.
    OwnLimit(Vec<usize>),
    /// Other joints at their limits, or sliders without limits that have run as far as they may.
    Limits(Vec<usize>),
    /// The loops do not close any further.
    DeadPoint,
    /// Nothing of the linkage moves.
    Immobile,
    /// The way is longer than is followed in one frame.
    TooFar,
}

/// The row of a table whose number, changed by the least, would take the most of a misfit away.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Suspect {
    /// The chain, from 0.
    pub chain: usize,
    /// The row in its table, from 0.
    pub row: usize,
    /// Which number of the row.
    pub dimension: Dimension,
    /// The change, rad or a length.
    pub change: f64,
}

/// A number of a Denavit–Hartenberg row.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Dimension {
    /// α, the twist of the link.
    Twist,
    /// a, its length.
    Length,
    /// The constant part of θ.
    Angle,
    /// The constant part of d.
    Offset,
}

/// The bounds by which the frames of a motion were judged. Lengths as shares of the mechanism's size, angles in rad.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Bounds {
    /// Of `closure`.
    pub closure: f64,
    /// Of `misfit`: the tolerance of the dimensions.
    pub misfit: f64,
    /// Of `projected_gradient`, in certified frames; in its units.
    pub projected_gradient: f64,
    /// The least curvature of f in certified frames, with the opposite sign: what counts as flat.
    pub curvature: f64,
    /// Of `metric`, where the goal counts as reached.
    pub reached: f64,
}

/// Where a metric's length comes from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum LengthSource {
    /// The document.
    Given,
    /// The mechanism's size.
    Mechanism,
    /// The extent of the goal motion, where the mechanism has no lengths.
    Motion,
    /// Neither has any: 1.
    #[default]
    None,
}

impl LengthSource {
    /// The name in reports.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Given => "given",
            Self::Mechanism => "mechanism",
            Self::Motion => "motion",
            Self::None => "none",
        }
    }
}

/// A planned motion.
///
/// ```
/// use synthetica::{Session, Warning};
///
/// let motion = Session::open(include_str!("../../www/mechanisms/3rps.json"))?.plan();
/// for frame in 0..motion.frames() {
///     // Rad or lengths, chain by chain.
///     assert_eq!(motion.joints_at(frame).len(), motion.variables);
///     if motion.status[frame].is_certified() {
///         assert!(motion.closure[frame] <= motion.bounds.closure);
///         assert!(motion.projected_gradient[frame] <= motion.bounds.projected_gradient);
///     }
/// }
/// assert!(!motion.warnings.iter().any(|warning| matches!(warning, Warning::BranchJump { .. })));
/// # Ok::<(), synthetica::Fault>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct Trajectory {
    /// Joint variables a frame: the length of the groups in `joints`.
    pub variables: usize,
    /// The driven joint variables, from 0 through all chains; none where the motion has goals.
    #[cfg(feature = "study")]
    pub drivers: Vec<usize>,
    /// Time of each frame, in the key frames' unit.
    pub time: Vec<f64>,
    /// Goal of each frame; of a driven motion it is no number, and so are the metric, the gaps and the gradient.
    pub goals: Vec<Pose>,
    /// Reached pose of each frame.
    pub poses: Vec<Pose>,
    /// Joint values, rad or lengths, chain by chain, frame by frame.
    pub joints: Vec<f64>,
    /// ½‖q − g‖² (Eq. 29).
    pub metric: Vec<f64>,
    /// Distance from goal to reached origin.
    pub translation_gap: Vec<f64>,
    /// Angle from goal to reached rotation, rad.
    pub rotation_gap: Vec<f64>,
    /// How far the loops are open, lengths as shares of the mechanism's size or rad. Of an overconstrained linkage with
    /// rounded dimensions: of the part of the loop equations that agrees.
    pub closure: Vec<f64>,
    /// By how much the rest of them contradicts that; 0 where nothing does.
    pub misfit: Vec<f64>,
    /// Smallest singular value of \[A\] that is not 0 because of surplus constraints, lengths as shares of the size,
    /// measured about the workpiece's origin.
    pub sigma_min: Vec<f64>,
    /// The measure of convergence, a bound of the projected gradient's norm, which is met where the frame's last linear
    /// system was made at its answer: lengths as shares of the size, or of the metric's length with the gradient planner.
    pub projected_gradient: Vec<f64>,
    /// Linear systems solved.
    pub iterations: Vec<u32>,
    /// How each frame ended.
    pub status: Vec<Status>,
    /// Mobility by Eq. 10.
    pub mobility_count: isize,
    /// n − rank \[A\] at the start: independent motions, inner freedoms of the chains included.
    pub mobility_rank: usize,
    /// The joint values from which the motion was planned.
    pub start: Vec<f64>,
    /// The bounds that were used.
    pub bounds: Bounds,
    /// The metric that was used, in the mechanism's unit.
    pub metric_used: Metric,
    /// Where its length comes from.
    pub length_source: LengthSource,
    /// What deserves a look.
    pub warnings: Vec<Warning>,
}

impl Trajectory {
    /// Number of frames.
    pub fn frames(&self) -> usize {
        self.status.len()
    }

    /// Joint values of a frame.
    ///
    /// # Panics
    /// When there is no such frame.
    pub fn joints_at(&self, frame: usize) -> &[f64] {
        &self.joints[frame * self.variables..(frame + 1) * self.variables]
    }

    /// Leaves out all frames from this one on.
    pub fn truncate(&mut self, frames: usize) {
        self.time.truncate(frames);
        self.goals.truncate(frames);
        self.poses.truncate(frames);
        self.joints.truncate(frames * self.variables);
        for column in [
            &mut self.metric,
            &mut self.translation_gap,
            &mut self.rotation_gap,
            &mut self.closure,
            &mut self.misfit,
            &mut self.sigma_min,
            &mut self.projected_gradient,
        ] {
            column.truncate(frames);
        }
        self.iterations.truncate(frames);
        self.status.truncate(frames);
    }
}

//! The result of a plan as columns: one entry, or one fixed-length group, a frame.

use crate::math::pose::Pose;

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
}

impl Status {
    /// All, in the order of their codes.
    pub const ALL: [Self; 5] = [
        Self::Reached,
        Self::Closest,
        Self::AtLimit,
        Self::Stalled,
        Self::ClosureLost,
    ];

    /// The name in reports.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Reached => "reached",
            Self::Closest => "closest",
            Self::AtLimit => "at_limit",
            Self::Stalled => "stalled",
            Self::ClosureLost => "closure_lost",
        }
    }

    /// Is the frame a certified optimum?
    pub const fn is_certified(self) -> bool {
        matches!(self, Self::Reached | Self::Closest | Self::AtLimit)
    }
}

/// Two key frames that follow each other.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Neighbours {
    /// The later of the two, from 0.
    pub key: usize,
    /// Their names, which may be empty.
    pub names: [String; 2],
}

/// Something that worked, but deserves a look.
#[derive(Clone, Debug, PartialEq)]
#[expect(missing_docs, reason = "the fields are what the variants speak of")]
pub enum Warning {
    /// The start's loops were open, and were closed by moving a joint by up to `moved` (rad or
    /// lengths).
    StartMoved { moved: f64 },
    /// The start's loops could not be closed; `opening` is what is left.
    StartOpen { opening: f64 },
    /// The linkage jumped between frames `first` and `first + 1`: a joint moved by `moved`.
    BranchJump { first: usize, moved: f64 },
    /// Frames `first` to `last` are close to a singular position: the smallest singular value falls
    /// to `smallest`.
    NearSingular {
        first: usize,
        last: usize,
        smallest: f64,
    },
    /// At this frame the distance to the goal keeps falling while a slider without limits runs away.
    Runaway { frame: usize },
    /// The paper's gradient planner knows no joint limits; frames beyond one are not certified.
    LimitsUnknown,
    /// The mobility by rank differs from the count of Eq. 10.
    MobilityDiffers { count: isize, rank: usize },
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
        angle: &'static str,
        typed: f64,
        slides: bool,
    },
    /// `angle` (longitude, latitude or roll) of two key frames differs by `typed` rad, more than half a
    /// turn; the workpiece turns the short way, by `turn` rad.
    ShortWay {
        neighbours: Neighbours,
        angle: &'static str,
        typed: f64,
        turn: f64,
    },
}

/// A planned motion.
#[derive(Clone, Debug, Default)]
pub struct Trajectory {
    /// Joint variables a frame: the length of the groups in `joints`.
    pub variables: usize,
    /// Time of each frame, in the key frames' unit.
    pub time: Vec<f64>,
    /// Goal of each frame.
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
    /// Largest opening of a loop (lengths and rad).
    pub closure: Vec<f64>,
    /// Smallest singular value of \[A\] that is not zero by dependent equations.
    pub sigma_min: Vec<f64>,
    /// Norm of the projected gradient, the measure of convergence.
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
}

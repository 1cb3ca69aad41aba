//! The solver's data: the linkage in its unit, the metric, the stops, and its buffers; and how a frame ends.

use crate::math::metric::{Metric, Target};
use crate::math::pose::Pose;
use crate::model::scaled::{Scaled, Tolerances};
use crate::solve::close::Closer;
use crate::solve::limits::Holding;
use crate::solve::trust_region::TrustRegion;

/// How the search for one frame ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// A certified local minimum: stationary, and no direction of negative curvature.
    Minimum,
    /// The same with a joint at a limit that holds the linkage back.
    MinimumAtLimit,
    /// Closed, but not certified.
    Stalled,
    /// The objective kept falling while a slider without limits ran away; the joints are left where
    /// they were.
    Runaway,
    /// The loops could not be closed.
    Open,
}

impl End {
    /// Whether it is a certified minimum.
    pub fn is_minimum(self) -> bool {
        matches!(self, Self::Minimum | Self::MinimumAtLimit)
    }
}

/// What is known of one solved frame.
#[derive(Clone, Copy, Debug)]
pub struct Solved {
    /// How it ended.
    pub end: End,
    /// The goal is met to within the tolerance of the metric.
    pub reached: bool,
    /// f; of a runaway at the last position before it was given up, not at the joint values that are left.
    pub value: f64,
    /// A bound of the norm of the objective's gradient along orthonormal free directions, which is met where they were found
    /// at the answer itself: lengths as shares of the size, or of the metric's length with the gradient planner.
    pub projected_gradient: f64,
    /// Linear systems solved.
    pub iterations: usize,
}

impl Solved {
    /// Nothing was found.
    pub const OPEN: Self = Self {
        end: End::Open,
        reached: false,
        value: f64::INFINITY,
        projected_gradient: f64::INFINITY,
        iterations: 0,
    };
}

/// An iterate, for an observer.
#[derive(Clone, Copy, Debug)]
pub struct Iterate<'a> {
    /// Joint values, rad or shares of the size. In the direct method they need not close the loops.
    pub theta: &'a [f64],
    /// Norm of the objective's gradient along the free directions.
    pub projected_gradient: f64,
    /// The largest closure error; 0 in the guarded method, whose iterates are closed.
    pub closure_error: f64,
    /// Found by the guarded method.
    pub guarded: bool,
}

/// Called with every iterate.
pub type Observer<'a> = dyn FnMut(&Iterate<'_>) + 'a;

/// The solver of one mechanism; its buffers serve all frames.
#[derive(Clone, Debug)]
pub struct Solver {
    pub(super) scaled: Scaled,
    pub(super) metric: Metric,
    pub(super) tolerances: Tolerances,
    pub(super) holding: Holding,
    pub(super) closer: Closer,
    pub(super) max_iterations: usize,
    pub(super) theta: Vec<f64>,
    pub(super) step: Vec<f64>,
    pub(super) correction: Vec<f64>,
    pub(super) slope: Vec<f64>,
    pub(super) curvature: Vec<f64>,
    pub(super) torques: Vec<f64>,
    pub(super) region: TrustRegion,
    pub(super) trial: Vec<f64>,
    /// Where the guarded method began.
    pub(super) origin: Vec<f64>,
}

impl Solver {
    /// A solver for a metric, given in the mechanism's own unit and frame; a frame takes at most `max_iterations`.
    pub fn new(scaled: Scaled, metric: &Metric, max_iterations: usize) -> Self {
        let n = scaled.variables();
        let metric = metric.within(scaled.unit(), scaled.origin());
        let tolerances = Tolerances::new(metric.length);
        Self {
            holding: Holding::new(scaled.limits()),
            closer: Closer::new(&scaled),
            metric,
            tolerances,
            max_iterations,
            theta: vec![0.0; n],
            step: vec![0.0; n],
            correction: Vec::new(),
            slope: Vec::new(),
            curvature: Vec::new(),
            torques: vec![0.0; n],
            region: TrustRegion::new(tolerances.flat),
            trial: vec![0.0; n],
            origin: vec![0.0; n],
            scaled,
        }
    }

    /// The mechanism as the solver sees it.
    pub fn scaled(&self) -> &Scaled {
        &self.scaled
    }

    /// The bounds by which a minimum is certified.
    pub fn tolerances(&self) -> &Tolerances {
        &self.tolerances
    }

    /// The metric in the solver's unit.
    pub fn metric(&self) -> &Metric {
        &self.metric
    }

    /// Closes the loops, and gives closure errors, mobility and singular values.
    pub fn closer(&mut self) -> &mut Closer {
        &mut self.closer
    }

    /// The joints that are held at limits.
    pub fn holding(&self) -> &Holding {
        &self.holding
    }

    /// Sets the stops: those from before a step that is not taken.
    pub fn set_holding(&mut self, holding: Holding) {
        self.holding = holding;
    }

    /// Clears all stops, before a position that is not a continuation of the last.
    pub fn clear_holding(&mut self) {
        self.holding.clear();
    }

    /// The linkage and what closes it, for walks over closed positions.
    pub fn parts(&mut self) -> (&Scaled, &mut Closer, &Holding) {
        (&self.scaled, &mut self.closer, &self.holding)
    }

    /// Number of independent motions at the closed position `joints`, inner freedoms included: n − rank \[A\]; and of
    /// surplus constraints.
    pub fn mobility(&mut self, joints: &[f64]) -> (usize, usize) {
        let theta = self.scaled.entered(joints);
        self.closer.mobility(&self.scaled, &theta)
    }

    /// f of the position `joints` against a goal, of which the nearer rotation is taken.
    pub fn value(&self, goal: &Pose, joints: &[f64]) -> f64 {
        let pose = self.scaled.chains()[0].pose(&self.scaled.entered(joints));
        self.metric.value(&pose, &self.scaled.enter_pose(goal))
    }

    /// The goal as the metric measures towards it from a position before.
    pub(super) fn target(&self, goal: &Pose, theta: &[f64]) -> Target {
        let before = self.closer.pose_at(&self.scaled, theta).rotation;
        self.metric.target(&self.scaled.enter_pose(goal), &before)
    }
}

/// What a minimum is called with the present stops.
pub(super) fn minimum(holding: &Holding) -> End {
    if holding.is_free() {
        End::Minimum
    } else {
        End::MinimumAtLimit
    }
}

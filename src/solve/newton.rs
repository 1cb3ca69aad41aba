//! The default planner's solver: the closest closed pose to a goal, by Newton's method on the
//! linkage's own freedoms.
//!
//! Two ways lead to the same minimum. The *direct* way takes full Newton steps that close the loops
//! and descend at once; near the last frame's answer two or three do. Anything out of the ordinary
//! (a long step, slow progress, a limit, a curvature that is not positive) sends the frame the
//! *guarded* way: a trust-region method whose iterates are all closed and whose objective only
//! falls, from the last answer, so that the branch is followed without a leap.

use crate::math::linalg;
use crate::math::metric::{Metric, Target};
use crate::math::pose::Pose;
use crate::model::scaled::{SOLVED, Scaled, Tolerances};
use crate::solve::close::{Closer, longest};
use crate::solve::close_start::{Start, close_start};
use crate::solve::guarded::Guarded;
use crate::solve::limits::Holding;
use crate::motion::trajectory::Suspect;
use crate::solve::objective::objective;
use crate::solve::suspect::suspect;
use crate::solve::trust_region::TrustRegion;

/// Steps of the direct way; from an extrapolation of the frames before, two or three suffice.
const DIRECT_STEPS: usize = 8;
/// Largest joint motion of a first direct step, rad or sizes: further off, the prediction is not trusted.
const DIRECT_STEP: f64 = 0.15;
/// A step that is not below this fraction of the last one is not Newton's convergence.
const CONTRACTION: f64 = 0.5;

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
    /// Is it a certified minimum?
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
    /// f.
    pub value: f64,
    /// Norm of the objective's gradient along orthonormal free directions, lengths as shares of the size.
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
    /// Joint values, rad or shares of the size. On the direct way they need not close the loops.
    pub theta: &'a [f64],
    /// Norm of the objective's gradient along the free directions.
    pub projected_gradient: f64,
    /// The largest closure error; 0 on the guarded way, whose iterates are closed.
    pub closure_error: f64,
    /// Found on the guarded way.
    pub guarded: bool,
}

/// Called with every iterate.
pub type Observer<'a> = dyn FnMut(&Iterate<'_>) + 'a;

/// The solver of one mechanism; its buffers serve all frames.
#[derive(Clone, Debug)]
pub struct Solver {
    pub(super) scaled: Scaled,
    metric: Metric,
    pub(super) tolerances: Tolerances,
    pub(super) holding: Holding,
    pub(super) closer: Closer,
    pub(super) max_iterations: usize,
    theta: Vec<f64>,
    pub(super) step: Vec<f64>,
    correction: Vec<f64>,
    pub(super) slope: Vec<f64>,
    pub(super) curvature: Vec<f64>,
    pub(super) mixed: Vec<f64>,
    pub(super) region: TrustRegion,
    pub(super) guarded: Guarded,
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
            mixed: Vec::new(),
            region: TrustRegion::new(tolerances.flat),
            guarded: Guarded::new(n),
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

    /// The number that explains the misfit of rounded dimensions best; see [`suspect`].
    pub fn suspect(&mut self, joints: &[f64]) -> Option<Suspect> {
        let theta = self.scaled.entered(joints);
        suspect(&self.scaled, &mut self.closer, &theta)
    }

    /// The linkage and what closes it, for walks over closed positions.
    pub fn parts(&mut self) -> (&Scaled, &mut Closer, &Holding) {
        (&self.scaled, &mut self.closer, &self.holding)
    }

    /// Closes the loops near `joints` without regard to a goal; see [`close_start`]. To be called once before
    /// [`Solver::solve`].
    pub fn close_start(&mut self, joints: &mut [f64], tolerance: f64) -> Start {
        let mut theta = self.scaled.entered(joints);
        let start = close_start(&mut self.closer, &self.scaled, &mut self.holding, tolerance, &mut theta);
        if !matches!(start, Start::Open { .. }) {
            self.scaled.leave(&theta, joints);
        }
        start
    }

    /// Number of independent motions at the closed position `joints`, inner freedoms included: n − rank \[A\]; and of
    /// surplus constraints.
    pub fn mobility(&mut self, joints: &[f64]) -> (usize, usize) {
        let theta = self.scaled.entered(joints);
        self.closer.mobility(&self.scaled, &theta)
    }

    /// The closed position nearest to `goal`, on the branch of `joints` (the last answer, or any
    /// closed position). `predicted` is where the answer is expected; it need not be closed.
    /// `joints` receives the answer; when the loops cannot be closed it is left alone.
    pub fn solve(&mut self, goal: &Pose, joints: &mut [f64], predicted: &[f64]) -> Solved {
        self.solve_watched(goal, joints, predicted, &mut |_| {})
    }

    /// The same, and shows every iterate.
    pub fn solve_watched(
        &mut self,
        goal: &Pose,
        joints: &mut [f64],
        predicted: &[f64],
        observe: &mut Observer<'_>,
    ) -> Solved {
        let mut theta = std::mem::take(&mut self.theta);
        self.scaled.enter(joints, &mut theta);
        let target = self.target(goal, &theta);
        self.scaled.enter(predicted, &mut theta);
        // The prediction does not keep limits, and no step moves a held joint to its limit.
        self.holding.apply(&mut theta);
        let mut iterations = 0;
        let direct = self.direct(&target, &mut theta, &mut iterations, observe);
        let solved = direct.unwrap_or_else(|| {
            self.scaled.enter(joints, &mut theta);
            self.solve_guarded(&target, &mut theta, &mut iterations, observe)
        });
        if solved.end != End::Open {
            self.scaled.leave(&theta, joints);
        }
        self.theta = theta;
        solved
    }

    /// f of the position `joints` against a goal, of which the nearer rotation is taken.
    pub fn value(&self, goal: &Pose, joints: &[f64]) -> f64 {
        let pose = self.scaled.chains()[0].pose(&self.scaled.entered(joints));
        self.metric.value(&pose, &self.scaled.enter_pose(goal))
    }

    /// The goal as the metric measures towards it from a position before.
    fn target(&self, goal: &Pose, theta: &[f64]) -> Target {
        let before = self.scaled.chains()[0].pose(theta).rotation;
        self.metric.target(&self.scaled.enter_pose(goal), &before)
    }

    /// Whether the closed position `joints`, found in another way from the position `before`, is a minimum: the
    /// quadratic model there falls by at most `fall` and curves nowhere downwards. Joints held at limits are not
    /// looked for, but a position beyond a limit is not certified.
    pub fn certify(&mut self, goal: &Pose, before: &[f64], joints: &[f64], fall: f64) -> Solved {
        /// Radius of the model that is trusted, rad or sizes.
        const RADIUS: f64 = 0.3;
        let target = self.target(goal, &self.scaled.entered(before));
        let theta = self.scaled.entered(joints);
        self.holding.clear();
        let dependence = self.closer.dependence_anywhere();
        let tangent = self.closer.tangent();
        tangent.evaluate(self.scaled.chains(), &theta);
        let free = tangent.factor(self.holding.stops(), dependence).free();
        let model = objective(free.pose(), &target);
        let projected_gradient = free.project(&model.gradient, &mut self.slope);
        let held = free.hold(&model.gradient);
        held.reduced_hessian(&model.hessian, None, &mut self.curvature, &mut self.mixed);
        self.region.prepare(held.free(), &self.curvature, &self.slope);
        let rest = self.region.step(RADIUS, &mut self.step);
        let minimum = rest <= fall && self.region.least() >= -self.tolerances.flat && self.holding.contains(&theta);
        Solved {
            end: if minimum { End::Minimum } else { End::Stalled },
            reached: model.value <= self.tolerances.reached,
            value: model.value,
            projected_gradient,
            iterations: 0,
        }
    }

    /// Newton steps that close and descend at once; `None` as soon as one of them is not as near an answer.
    fn direct(
        &mut self,
        target: &Target,
        theta: &mut [f64],
        iterations: &mut usize,
        observe: &mut Observer<'_>,
    ) -> Option<Solved> {
        let mut last = DIRECT_STEP;
        let dependence = self.closer.dependence();
        let Tolerances { stationary, flat, reached } = self.tolerances;
        for _ in 0..DIRECT_STEPS {
            let tangent = self.closer.tangent();
            tangent.evaluate(self.scaled.chains(), theta);
            let mut factored = tangent.factor(self.holding.stops(), dependence);
            let (open, _) = factored.closure();
            factored.close(&mut self.correction, &mut self.step);
            let free = factored.free();
            let model = objective(free.pose(), target);
            let gradient = free.project(&model.gradient, &mut self.slope);
            observe(&Iterate { theta, projected_gradient: gradient, closure_error: open, guarded: false });
            let held = free.hold(&model.gradient);
            let closing = Some((&self.correction[..], &self.step[..]));
            held.reduced_hessian(&model.hessian, closing, &mut self.curvature, &mut self.mixed);
            let n = self.slope.len();
            if !linalg::cholesky(&mut self.curvature, n, n, flat) {
                return None;
            }
            if open <= SOLVED && gradient <= stationary {
                let released = self.holding.releasable(stationary, |joint| held.torque(joint));
                let certified = released.is_none() && self.holding.contains(theta);
                let end = minimum(&self.holding);
                return certified.then_some(Solved {
                    end,
                    reached: model.value <= reached,
                    value: model.value,
                    projected_gradient: gradient,
                    iterations: *iterations,
                });
            }
            *iterations += 1;
            for (m, s) in self.mixed.iter_mut().zip(&self.slope) {
                *m = -*m - s;
            }
            linalg::solve_lower(&self.curvature, n, n, &mut self.mixed);
            linalg::solve_lower_transposed(&self.curvature, n, n, &mut self.mixed);
            for (i, &a) in self.mixed.iter().enumerate() {
                for (s, r) in self.step.iter_mut().zip(held.free().rates(i)) {
                    *s += a * r;
                }
            }
            let length = longest(&self.step);
            if !(length <= last) || self.holding.share(theta, &self.step, 0.0, None).0 < 1.0 {
                return None;
            }
            // A step of rounding size may be followed by another.
            last = (CONTRACTION * length).max(1e-7);
            for (t, s) in theta.iter_mut().zip(&self.step) {
                *t += s;
            }
        }
        None
    }
}

/// What a minimum is called with the present stops.
pub(super) fn minimum(holding: &Holding) -> End {
    if holding.is_free() { End::Minimum } else { End::MinimumAtLimit }
}

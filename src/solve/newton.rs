//! The default planner's solver: the closest closed pose to a goal, by Newton's method on the
//! linkage's own freedoms.
//!
//! Two ways lead to the same minimum. The *direct* way takes full Newton steps that close the loops
//! and descend at once; near the last frame's answer two or three do. Anything out of the ordinary
//! (a long step, slow progress, a limit, a curvature that is not positive) sends the frame the
//! *guarded* way: a trust-region method whose iterates are all closed and whose objective only
//! falls, from the last answer, so that the branch is followed and not jumped from.

use crate::math::linalg;
use crate::math::pose::Pose;
use crate::model::chain::Chain;
use crate::model::joint::{Limits, Stop};
use crate::model::mechanism::Mechanism;
use crate::solve::objective::{Objective, objective};
use crate::solve::tangent::Tangent;
use crate::solve::trust_region::TrustRegion;

/// Projected gradient below which a pose is stationary: f is then within about 1e-17 of its minimum.
const STATIONARY: f64 = 1e-9;
/// Curvature below which a direction counts as flat: second derivative of f per squared joint
/// motion, above the rounding of a direction that does not matter at all (an inner freedom).
const FLAT: f64 = 1e-8;
/// ‖q − g‖ at which the goal counts as reached: what a projected gradient of 1e-9 leaves, and room.
const REACHED: f64 = 1e-8;
/// Steps of the direct way; a warm start takes two or three.
const DIRECT_STEPS: usize = 8;
/// Largest rotation of a guarded step, rad, and its first radius: 0.3 still resembles the quadratic
/// model.
const STEP: f64 = 0.3;
/// How far a slider may run in one frame, in units of the size. Without limits the objective can
/// keep falling, ever more slowly, as a slider runs away; that is no answer.
const FARTHEST: f64 = 100.0;
/// Largest motion of a first direct step: further off, the prediction is not to be trusted.
const DIRECT_STEP: f64 = 0.15;
/// A step that is not below this fraction of the last one is not Newton's convergence.
const CONTRACTION: f64 = 0.5;
/// How far beyond a limit a joint may stand by rounding of the closing corrections.
const LIMIT: f64 = 1e-10;
/// Trust radius at which the guarded way gives up.
const SMALLEST_STEP: f64 = 1e-11;
/// Corrections after a guarded step: quadratic convergence needs three or four.
const CORRECTIONS: usize = 12;

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

/// What is known of one solved frame.
#[derive(Clone, Copy, Debug)]
pub struct Solved {
    /// How it ended.
    pub end: End,
    /// The goal is met to within 1e-8 in the metric.
    pub reached: bool,
    /// Norm of the objective's gradient along orthonormal free directions.
    pub projected_gradient: f64,
    /// Linear systems solved.
    pub iterations: usize,
}

/// An iterate, for whoever watches.
#[derive(Clone, Debug)]
pub struct Iterate {
    /// Joint values, rad or lengths. On the direct way they need not close the loops.
    pub joints: Vec<f64>,
    /// Norm of the objective's gradient along the free directions.
    pub projected_gradient: f64,
    /// Largest opening of a loop, lengths in units of the size.
    pub opening: f64,
    /// Found on the guarded way.
    pub guarded: bool,
}

/// The solver of one mechanism; its buffers serve all frames.
///
/// It works in units of the mechanism's size, so that one tolerance serves lengths and angles.
#[derive(Clone, Debug)]
pub struct Solver {
    chains: Vec<Chain>,
    size: f64,
    /// The metric's characteristic length in units of the size.
    length: f64,
    /// The objective is divided by its curvature in translations where that is above 1 (a mechanism
    /// large against the metric's length), so that one tolerance serves; and the tolerances fall
    /// with it where it is below 1, so that translations still converge.
    weight: f64,
    stationary: f64,
    flat: f64,
    limits: Vec<Limits>,
    /// Joints held at a limit.
    stops: Vec<Stop>,
    /// Opening at which the loops count as closed.
    closed: f64,
    /// Constraints implied by the others at closed, non-singular positions.
    redundant: usize,
    max_iterations: usize,
    tangent: Tangent,
    theta: Vec<f64>,
    trial: Vec<f64>,
    at: Vec<f64>,
    /// Where the guarded way began.
    origin: Vec<f64>,
    step: Vec<f64>,
    correction: Vec<f64>,
    slope: Vec<f64>,
    curvature: Vec<f64>,
    mixed: Vec<f64>,
    region: TrustRegion,
    trail: Option<Vec<Iterate>>,
}

impl Solver {
    /// A solver for a metric with characteristic length `length`; a frame takes at most
    /// `max_iterations`.
    pub fn new(mechanism: &Mechanism, length: f64, max_iterations: usize) -> Self {
        let size = mechanism.size();
        let chains = mechanism.scaled(1.0 / size).chains().to_vec();
        let limits: Vec<_> = chains.iter().flat_map(Chain::limits).collect();
        let n = limits.len();
        // ∂²f/∂v² in units of the size; below 1e-4 rounding would stop the convergence.
        let curvature = 0.25 * (size / length) * (size / length);
        let tolerance = curvature.clamp(1e-4, 1.0);
        Self {
            weight: curvature.max(1.0),
            stationary: STATIONARY * tolerance,
            flat: FLAT * tolerance,
            tangent: Tangent::new(&chains),
            chains,
            size,
            length: length / size,
            limits,
            stops: vec![Stop::None; n],
            // Ten times closer than what is published, and not closer than rounding allows.
            closed: (1e-11 / size).clamp(1e-13, 1e-12),
            redundant: 0,
            max_iterations,
            theta: vec![0.0; n],
            trial: vec![0.0; n],
            at: vec![0.0; n],
            origin: vec![0.0; n],
            step: vec![0.0; n],
            correction: Vec::new(),
            slope: Vec::new(),
            curvature: Vec::new(),
            mixed: Vec::new(),
            region: TrustRegion::new(FLAT * tolerance),
            trail: None,
        }
    }

    /// [`Solver::solve`] from `joints`, which receive the answer, with every iterate on the way.
    pub fn watch(&mut self, goal: &Pose, joints: &mut [f64]) -> (Solved, Vec<Iterate>) {
        self.trail = Some(Vec::new());
        let from = joints.to_vec();
        let solved = self.solve(goal, joints, &from);
        (solved, self.trail.take().unwrap_or_default())
    }

    /// Leaves an iterate on the trail, if anybody watches.
    fn mark(&mut self, theta: &[f64], opening: f64, projected_gradient: f64, guarded: bool) {
        let Some(mut trail) = self.trail.take() else {
            return;
        };
        let mut joints = vec![0.0; theta.len()];
        self.store(theta, &mut joints);
        trail.push(Iterate {
            joints,
            projected_gradient: projected_gradient * self.weight,
            opening,
            guarded,
        });
        self.trail = Some(trail);
    }

    /// Lengths of `joints` divided by the size.
    fn load(&self, joints: &[f64], theta: &mut [f64]) {
        let turns = self.chains.iter().flat_map(Chain::turns);
        for ((t, &x), turns) in theta.iter_mut().zip(joints).zip(turns) {
            *t = if turns { x } else { x / self.size };
        }
    }

    fn store(&self, theta: &[f64], joints: &mut [f64]) {
        let turns = self.chains.iter().flat_map(Chain::turns);
        for ((x, &t), turns) in joints.iter_mut().zip(theta).zip(turns) {
            *x = if turns { t } else { t * self.size };
        }
    }

    /// Closes the loops near `joints` without regard to a goal, within the limits; false if they
    /// stay open. Also learns how many constraints imply each other. To be called once before
    /// [`Solver::solve`].
    pub fn assemble(&mut self, joints: &mut [f64]) -> bool {
        let mut theta = std::mem::take(&mut self.trial);
        // Joints that meet a limit are held there; if that does not close, they may come back.
        let closed = [true, false].into_iter().any(|hold| {
            self.load(joints, &mut theta);
            self.stops.fill(Stop::None);
            self.assemble_holding(hold, &mut theta)
        });
        self.stops.fill(Stop::None);
        self.store(&theta, joints);
        self.trial = theta;
        closed
    }

    fn assemble_holding(&mut self, hold: bool, theta: &mut [f64]) -> bool {
        /// Gauss–Newton from a random start takes about a dozen steps.
        const STEPS: usize = 100;
        /// While the loops are open by e, dependent constraints look independent by about e.
        const BLUR: f64 = 0.1;
        for _ in 0..STEPS {
            for (j, l) in self.limits.iter().enumerate() {
                let within = theta[j].clamp(l.min, l.max);
                if hold && (theta[j] - within).abs() > LIMIT {
                    let low = theta[j] < within;
                    self.stops[j] = if low { Stop::Min } else { Stop::Max };
                }
                theta[j] = within;
            }
            let open = self.tangent.evaluate(&self.chains, theta);
            if open <= self.closed {
                self.stops.fill(Stop::None);
                self.tangent.factor(&self.stops, None, 0);
                self.redundant = self.tangent.redundant();
                return true;
            }
            let blur = (open > self.closed).then_some(BLUR * open.min(0.1));
            self.tangent.factor(&self.stops, blur, 0);
            self.tangent.close(&mut self.correction, &mut self.step);
            let longest = longest(&self.step);
            if !longest.is_finite() {
                return false;
            }
            let scale = (1.0 / longest).min(1.0);
            for (t, s) in theta.iter_mut().zip(&self.step) {
                *t += scale * s;
            }
        }
        false
    }

    /// Number of constraints at the closed position `joints` that the others imply.
    pub fn redundancy(&mut self, joints: &[f64]) -> usize {
        self.mobility(joints);
        self.tangent.redundant()
    }

    /// Number of independent motions at the closed position `joints`, inner freedoms included:
    /// n − rank \[A\].
    pub fn mobility(&mut self, joints: &[f64]) -> usize {
        let mut theta = std::mem::take(&mut self.trial);
        self.load(joints, &mut theta);
        self.tangent.evaluate(&self.chains, &theta);
        self.stops.fill(Stop::None);
        self.tangent.factor(&self.stops, None, 0);
        self.trial = theta;
        self.tangent.freedoms()
    }

    /// The closed position nearest to `goal`, on the branch of `joints` (the last answer, or any
    /// closed position). `predicted` is where the answer is expected; it need not be closed.
    /// `joints` receives the answer; when the loops cannot be closed it is left alone.
    pub fn solve(&mut self, goal: &Pose, joints: &mut [f64], predicted: &[f64]) -> Solved {
        let mut goal = *goal;
        goal.translation.vector /= self.size;
        let mut theta = std::mem::take(&mut self.theta);
        self.load(predicted, &mut theta);
        for ((t, stop), limits) in theta.iter_mut().zip(&self.stops).zip(&self.limits) {
            // The prediction knows nothing of limits, and a held joint stays where it is put.
            if *stop != Stop::None {
                *t = stop.bound(limits);
            }
        }
        let mut iterations = 0;
        let direct = self.direct(&goal, &mut theta, &mut iterations);
        let solved = direct.unwrap_or_else(|| {
            self.load(joints, &mut theta);
            self.guarded(&goal, &mut theta, &mut iterations)
        });
        if solved.end != End::Open {
            self.store(&theta, joints);
        }
        self.theta = theta;
        solved
    }

    /// Whether the closed position `joints`, found in another way, is a minimum: the quadratic model
    /// there falls by at most `fall` and curves nowhere downwards. Joints held at limits are not
    /// looked for, but a position beyond a limit is not certified.
    pub fn certify(&mut self, goal: &Pose, joints: &[f64], fall: f64) -> Solved {
        let mut goal = *goal;
        goal.translation.vector /= self.size;
        let mut theta = std::mem::take(&mut self.theta);
        self.load(joints, &mut theta);
        self.stops.fill(Stop::None);
        self.tangent.evaluate(&self.chains, &theta);
        self.tangent.factor(&self.stops, None, 0);
        self.tangent.span();
        let model = self.model(&goal);
        let gradient = self.project(&model);
        self.tangent
            .reduced_hessian(&model.hessian, None, &mut self.curvature, &mut self.mixed);
        self.region
            .prepare(&self.tangent, &self.curvature, &self.slope);
        let rest = self.region.step(STEP, &mut self.step) * self.weight;
        let minimum =
            rest <= fall && self.region.least() >= -self.flat && self.within_limits(&theta);
        let end = if minimum { End::Minimum } else { End::Stalled };
        let reached = self.is_reached(&model);
        self.theta = theta;
        self.solved(end, reached, gradient, 0)
    }

    /// Newton steps that close and descend at once; `None` at the first sign of trouble.
    fn direct(&mut self, goal: &Pose, theta: &mut [f64], iterations: &mut usize) -> Option<Solved> {
        let mut last = DIRECT_STEP;
        for _ in 0..DIRECT_STEPS {
            let open = self.tangent.evaluate(&self.chains, theta);
            self.tangent.factor(&self.stops, None, self.redundant);
            self.tangent.span();
            self.tangent.close(&mut self.correction, &mut self.step);
            let model = self.model(goal);
            let gradient = self.project(&model);
            self.mark(theta, open, gradient, false);
            self.tangent.reduced_hessian(
                &model.hessian,
                Some((&self.correction, &self.step)),
                &mut self.curvature,
                &mut self.mixed,
            );
            let n = self.tangent.freedoms();
            if !linalg::cholesky(&mut self.curvature, n, n, self.flat) {
                return None;
            }
            if open <= self.closed && gradient <= self.stationary {
                let certified = self.releasable().is_none() && self.within_limits(theta);
                let solved = self.solved(
                    self.minimum(),
                    self.is_reached(&model),
                    gradient,
                    *iterations,
                );
                return certified.then_some(solved);
            }
            *iterations += 1;
            for (m, s) in self.mixed.iter_mut().zip(&self.slope) {
                *m = -*m - s;
            }
            linalg::solve_lower(&self.curvature, n, n, &mut self.mixed);
            linalg::solve_lower_transposed(&self.curvature, n, n, &mut self.mixed);
            for (i, &a) in self.mixed.iter().enumerate() {
                for (s, r) in self.step.iter_mut().zip(self.tangent.rates(i)) {
                    *s += a * r;
                }
            }
            let length = longest(&self.step);
            if !(length <= last) || self.share_within_limits(theta).0 < 1.0 {
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

    /// Closed iterates, falling objective, trust region in the norm of the joint motions.
    fn guarded(&mut self, goal: &Pose, theta: &mut [f64], iterations: &mut usize) -> Solved {
        let mut radius = STEP;
        if !self.close(theta, iterations) {
            return self.solved(End::Open, false, f64::INFINITY, *iterations);
        }
        self.origin.copy_from_slice(theta);
        loop {
            self.tangent.factor(&self.stops, None, 0);
            // Fewer than thought: the start was in a singular position.
            self.redundant = self.redundant.min(self.tangent.redundant());
            self.tangent.span();
            let model = self.model(goal);
            let gradient = self.project(&model);
            let reached = self.is_reached(&model);
            self.mark(theta, 0.0, gradient, true);
            if gradient <= self.stationary
                && let Some(joint) = self.releasable()
            {
                self.stops[joint] = Stop::None;
                *iterations += 1;
                if *iterations >= self.max_iterations {
                    return self.solved(End::Stalled, reached, gradient, *iterations);
                }
                continue;
            }
            self.tangent.reduced_hessian(
                &model.hessian,
                None,
                &mut self.curvature,
                &mut self.mixed,
            );
            self.region
                .prepare(&self.tangent, &self.curvature, &self.slope);
            if gradient <= self.stationary && self.region.least() >= -self.flat {
                return self.solved(self.minimum(), reached, gradient, *iterations);
            }
            let stuck = !self.descend(goal, theta, &model, &mut radius, iterations);
            let run = theta
                .iter()
                .zip(&self.origin)
                .map(|(t, o)| (t - o).abs())
                .fold(0.0, f64::max);
            if run > FARTHEST {
                theta.copy_from_slice(&self.origin);
                self.stops.fill(Stop::None);
                return self.solved(End::Runaway, reached, gradient, *iterations);
            }
            if stuck {
                return self.solved(End::Stalled, reached, gradient, *iterations);
            }
        }
    }

    /// Shrinks the radius until a step from `theta` closes, keeps the limits and descends, and takes
    /// it; false if none does.
    fn descend(
        &mut self,
        goal: &Pose,
        theta: &mut [f64],
        model: &Objective,
        radius: &mut f64,
        iterations: &mut usize,
    ) -> bool {
        let mut trial = std::mem::take(&mut self.trial);
        let mut taken = false;
        while !taken && *radius >= SMALLEST_STEP && *iterations < self.max_iterations {
            *iterations += 1;
            let mut predicted = self.region.step(*radius, &mut self.step);
            let turn = self.largest_turn();
            if turn > STEP {
                *radius = self.region.length() * STEP / turn;
                predicted = self.region.step(*radius, &mut self.step);
            }
            let (share, hit) = self.share_within_limits(theta);
            for ((t, x), s) in trial.iter_mut().zip(&*theta).zip(&self.step) {
                *t = x + share * s;
            }
            let before = hit.map(|(joint, stop)| {
                trial[joint] = stop.bound(&self.limits[joint]);
                (joint, std::mem::replace(&mut self.stops[joint], stop))
            });
            taken = self.close(&mut trial, iterations) && self.within_limits(&trial) && {
                let value = self.model(goal).value;
                let gain = model.value - value;
                // f is known to within rounding, and the pull's work on what the loops are open.
                let noise = 1e-15 * (1.0 + model.value) + self.closed * model.gradient.norm();
                // At rounding level the gain says nothing; the model is trusted there.
                let trusted = predicted <= 10.0 * noise || gain >= 0.7 * predicted;
                if trusted && self.region.length() >= 0.9 * *radius {
                    *radius = (2.0 * *radius).min(FARTHEST);
                } else if gain < 0.25 * share * predicted - noise {
                    *radius *= 0.5;
                }
                gain >= 1e-4 * share * predicted - noise
            };
            if taken {
                theta.copy_from_slice(&trial);
            } else {
                if let Some((joint, stop)) = before {
                    self.stops[joint] = stop;
                }
                *radius = 0.25 * radius.min(self.region.length());
            }
        }
        self.trial = trial;
        taken
    }

    /// Corrects `theta` until the loops are closed; false, and `theta` as it was, if they do not
    /// close nearby.
    fn close(&mut self, theta: &mut [f64], iterations: &mut usize) -> bool {
        // In a singular position more constraints look redundant than are.
        let counts = if self.redundant > 0 {
            &[self.redundant, 0][..]
        } else {
            &[0][..]
        };
        for &redundant in counts {
            self.at.copy_from_slice(theta);
            let mut last = f64::INFINITY;
            for _ in 0..CORRECTIONS {
                let open = self.tangent.evaluate(&self.chains, &self.at);
                if open <= self.closed {
                    theta.copy_from_slice(&self.at);
                    return true;
                }
                if !(open < last) {
                    break;
                }
                last = open;
                *iterations += 1;
                self.tangent.factor(&self.stops, None, redundant);
                self.tangent.close(&mut self.correction, &mut self.step);
                if !(longest(&self.step) <= STEP) {
                    break;
                }
                for (t, s) in self.at.iter_mut().zip(&self.step) {
                    *t += s;
                }
            }
        }
        false
    }

    /// Balances the goal's pull, projects the gradient on the free directions; its norm.
    #[inline]
    fn project(&mut self, model: &Objective) -> f64 {
        self.tangent.balance(&model.gradient);
        self.slope.clear();
        let n = self.tangent.freedoms();
        self.slope
            .extend((0..n).map(|i| self.tangent.twist(i).dot(&model.gradient)));
        self.slope.iter().map(|x| x * x).sum::<f64>().sqrt()
    }

    /// The objective at the last evaluation, in the solver's units.
    #[inline]
    fn model(&self, goal: &Pose) -> Objective {
        let mut model = objective(self.tangent.pose(), goal, self.length);
        model.value /= self.weight;
        model.gradient /= self.weight;
        model.hessian /= self.weight;
        model
    }

    fn is_reached(&self, model: &Objective) -> bool {
        model.value <= 0.5 * REACHED * REACHED
    }

    fn solved(
        &self,
        end: End,
        reached: bool,
        projected_gradient: f64,
        iterations: usize,
    ) -> Solved {
        let projected_gradient = projected_gradient * self.weight;
        Solved {
            end,
            reached,
            projected_gradient,
            iterations,
        }
    }

    /// What a minimum is called with the present stops.
    fn minimum(&self) -> End {
        if self.stops.iter().all(|s| *s == Stop::None) {
            End::Minimum
        } else {
            End::MinimumAtLimit
        }
    }

    /// The held joint that would lower the objective most by leaving its limit.
    fn releasable(&self) -> Option<usize> {
        let mut best = (self.stationary, None);
        for (joint, stop) in self.stops.iter().enumerate() {
            let inward = match stop {
                Stop::None => continue,
                Stop::Min => -self.tangent.torque(joint),
                Stop::Max => self.tangent.torque(joint),
            };
            if inward > best.0 && self.limits[joint].max > self.limits[joint].min {
                best = (inward, Some(joint));
            }
        }
        best.1
    }

    /// The largest share of the step that keeps free joints within their limits, and the joint that
    /// stops it.
    fn share_within_limits(&self, theta: &[f64]) -> (f64, Option<(usize, Stop)>) {
        let mut first = (1.0, None);
        for (joint, l) in self.limits.iter().enumerate() {
            let s = self.step[joint];
            let (room, stop) = if s > 0.0 {
                (l.max - theta[joint], Stop::Max)
            } else {
                (theta[joint] - l.min, Stop::Min)
            };
            if room < s.abs() * first.0 {
                first = ((room / s.abs()).max(0.0), Some((joint, stop)));
            }
        }
        first
    }

    /// The largest rotation in the step.
    fn largest_turn(&self) -> f64 {
        let turns = self.chains.iter().flat_map(Chain::turns);
        self.step
            .iter()
            .zip(turns)
            .map(|(s, turns)| if turns { s.abs() } else { 0.0 })
            .fold(0.0, f64::max)
    }

    fn within_limits(&self, theta: &[f64]) -> bool {
        theta
            .iter()
            .zip(&self.limits)
            .all(|(t, l)| *t >= l.min - LIMIT && *t <= l.max + LIMIT)
    }
}

/// The largest entry; NaN if there is one.
fn longest(step: &[f64]) -> f64 {
    step.iter()
        .fold(0.0, |m: f64, s| if s.abs() <= m { m } else { s.abs() })
}

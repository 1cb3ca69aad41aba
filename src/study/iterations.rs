//! The planner's own iterations at one frame, one by one: the paper's projected gradient (Fig. 3) and
//! Newton's method from the same position towards the same goal.

use crate::math::pose::{self, Pose};
use crate::model::mechanism::Mechanism;
use crate::plan::follow::{GRADIENT_ITERATIONS, Method, NEWTON_ITERATIONS, Settings};
use crate::solve::gradient::{self, Arrival};
use crate::solve::newton::{End, Solver};
use crate::solve::paper_matrix::{self, SingularValues};

/// Iterates that are kept one by one; of the later ones only those this much further on.
const KEPT: usize = 60;
const THINNED: f64 = 1.03;

/// The iterates of one method, as columns.
#[derive(Clone, Debug, Default)]
pub struct History {
    /// Number of each kept iterate: 0 is the position that the method starts from.
    pub iteration: Vec<u32>,
    /// Joint values, rad or lengths.
    pub joints: Vec<Vec<f64>>,
    /// The workpiece.
    pub poses: Vec<Pose>,
    /// f = ½‖q − g‖².
    pub metric: Vec<f64>,
    /// |a| of Eq. 31; of Newton the norm of the gradient along the free directions.
    pub projected_gradient: Vec<f64>,
    /// How far the loops are open, lengths and rad.
    pub closure_error: Vec<f64>,
    /// Smallest singular value of \[A\] that is not zero by dependent equations.
    pub sigma_min: Vec<f64>,
    /// Of the gradient: the step that led here and its corrections by Eq. 28.
    pub arrivals: Vec<Arrival>,
    /// Of Newton: found by guarded steps.
    pub guarded: Vec<bool>,
    /// Number of the last iterate.
    pub last: usize,
    /// The method stopped because it had arrived, not because it gave up.
    pub converged: bool,
}

/// Both methods at one frame.
#[derive(Clone, Debug)]
pub struct Trace {
    /// The goal.
    pub goal: Pose,
    /// The paper's method.
    pub gradient: History,
    /// The default one.
    pub newton: History,
    /// f at the minimum that Newton's method certifies; `None` if it does not.
    pub minimum: Option<f64>,
}

/// Follows both methods towards `goal` from the joint values `from`, rad or lengths: those of the
/// frame before, or a start. Empty histories where the loops cannot be closed.
///
/// # Panics
/// When `from` does not have one value a joint variable.
pub fn trace(mechanism: &Mechanism, settings: &Settings, goal: &Pose, from: &[f64]) -> Trace {
    let mut from = from.to_vec();
    // A limit in the settings is meant for the method that they name.
    let most = |method, own| match settings.max_iterations {
        Some(most) if settings.method == method => most,
        Some(_) | None => own,
    };
    let length = settings.metric_length;
    let newton_most = most(Method::Newton, NEWTON_ITERATIONS);
    let mut solver = Solver::new(mechanism, length, newton_most);
    let mut trace = Trace {
        goal: *goal,
        gradient: History::default(),
        newton: History::default(),
        minimum: None,
    };
    if !solver.assemble(&mut from) {
        return trace;
    }

    let redundant = solver.redundancy(&from);
    let reference = mechanism.scaled(1.0 / length);
    let mut near = *goal;
    near.translation.vector /= length;
    let mut scaled = mechanism.in_unit(&from, length);
    let mut history = Kept::new(mechanism, goal, length, &reference, redundant);
    let most = most(Method::Gradient, GRADIENT_ITERATIONS);
    let descent = gradient::descend(&reference, &near, &mut scaled, most, &mut |at| {
        let joints = mechanism.in_unit(at.joints, 1.0 / length);
        history.see(&joints, at.projected_gradient, at.arrival, false);
    });
    trace.gradient = history.end(descent.converged);

    let mut history = Kept::new(mechanism, goal, length, &reference, redundant);
    let (solved, iterates) = solver.watch(goal, &mut from);
    for at in &iterates {
        history.see(
            &at.joints,
            at.projected_gradient,
            Arrival::default(),
            at.guarded,
        );
    }
    let certified = matches!(solved.end, End::Minimum | End::MinimumAtLimit);
    trace.newton = history.end(certified);
    trace.minimum = trace.newton.metric.last().copied().filter(|_| certified);
    trace
}

/// Collects a history: the last iterate is kept whatever its number.
struct Kept<'a> {
    mechanism: &'a Mechanism,
    goal: &'a Pose,
    /// The metric's characteristic length.
    length: f64,
    /// The mechanism in units of the metric's length, and its dependent equations.
    reference: &'a Mechanism,
    redundant: usize,
    singular_values: SingularValues,
    history: History,
    seen: usize,
    /// The last one, if it was left out.
    pending: Option<(Vec<f64>, f64, Arrival, bool)>,
}

impl<'a> Kept<'a> {
    fn new(
        mechanism: &'a Mechanism,
        goal: &'a Pose,
        length: f64,
        reference: &'a Mechanism,
        redundant: usize,
    ) -> Self {
        Self {
            mechanism,
            goal,
            length,
            reference,
            redundant,
            singular_values: SingularValues::default(),
            history: History::default(),
            seen: 0,
            pending: None,
        }
    }

    fn see(&mut self, joints: &[f64], gradient: f64, arrival: Arrival, guarded: bool) {
        let last = self.history.iteration.last().copied().unwrap_or(0);
        let far = self.seen as f64 >= THINNED * f64::from(last);
        if self.seen < KEPT || far {
            self.pending = None;
            self.keep(self.seen, joints, gradient, arrival, guarded);
        } else {
            self.pending = Some((joints.to_vec(), gradient, arrival, guarded));
        }
        self.seen += 1;
    }

    fn keep(
        &mut self,
        number: usize,
        joints: &[f64],
        gradient: f64,
        arrival: Arrival,
        guarded: bool,
    ) {
        let (mechanism, length) = (self.mechanism, self.length);
        let pose = mechanism.chains()[0].pose(joints);
        let history = &mut self.history;
        history
            .iteration
            .push(u32::try_from(number).unwrap_or(u32::MAX));
        history.metric.push(pose::metric(&pose, self.goal, length));
        history
            .closure_error
            .push(paper_matrix::opening(mechanism, joints, &pose));
        history.poses.push(pose);
        let scaled = mechanism.in_unit(joints, length);
        let chains = self.reference.chains();
        let least = self
            .singular_values
            .smallest(chains, &scaled, self.redundant);
        history.sigma_min.push(least);
        history.joints.push(joints.to_vec());
        history.projected_gradient.push(gradient);
        history.arrivals.push(arrival);
        history.guarded.push(guarded);
    }

    fn end(mut self, converged: bool) -> History {
        let last = self.seen.saturating_sub(1);
        if let Some((joints, gradient, arrival, guarded)) = self.pending.take() {
            self.keep(last, &joints, gradient, arrival, guarded);
        }
        History {
            last,
            converged,
            ..self.history
        }
    }
}

//! The planner's own iterations at one frame, one by one: the paper's projected gradient (Fig. 3) and
//! Newton's method from the same position towards the same goal.

use crate::math::metric::Target;
use crate::math::pose::Pose;
use crate::model::mechanism::Mechanism;
use crate::model::scaled::Scaled;
use crate::plan::settings::{Method, Settings};
use crate::solve::close::Closer;
use crate::solve::gradient::{self, Arrival};
use crate::solve::singular_values::SingularValues;

/// Iterates that are kept one by one; of the later ones only those this much further on, so that 30,000 iterations leave
/// about 270, as many as a chart has pixels for.
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
    /// How far the loops are open, lengths as shares of the size or rad.
    pub closure_error: Vec<f64>,
    /// By how much rounded dimensions contradict each other, in the same measure.
    pub misfit: Vec<f64>,
    /// Smallest singular value of \[A\] that is not 0 because of surplus constraints.
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
/// frame before, or a start; for a motion of this extent. Empty histories where the loops cannot be closed.
///
/// # Panics
/// When `from` does not have one value a joint variable.
pub fn trace(
    mechanism: &Mechanism,
    settings: &Settings,
    extent: f64,
    goal: &Pose,
    from: &[f64],
) -> Trace {
    let mut from = from.to_vec();
    // A limit in the settings is meant for the method that they name.
    let most = |method| {
        let own = Settings {
            method,
            max_iterations: None,
            ..*settings
        };
        if settings.method == method {
            settings.iterations()
        } else {
            own.iterations()
        }
    };
    let newton = Settings {
        method: Method::Newton,
        max_iterations: Some(most(Method::Newton)),
        ..*settings
    };
    let mut solver = newton.solver(mechanism, extent);
    let mut trace = Trace {
        goal: *goal,
        gradient: History::default(),
        newton: History::default(),
        minimum: None,
    };
    if !solver
        .close_start(&mut from, settings.dimension_tolerance)
        .is_closed()
    {
        return trace;
    }
    let scaled = solver.scaled().clone();
    let mut closer = solver.closer().clone();
    let rotation = mechanism.chains()[0].pose(&from).rotation;
    let target = settings
        .metric_for(mechanism, extent)
        .target(goal, &rotation);
    let surplus = closer.mobility(&scaled, &scaled.entered(&from)).1;

    let mut kept = Kept::new(mechanism, &target, &scaled, closer.clone(), surplus);
    let mut joints = from.clone();
    let descent = gradient::descend(
        mechanism,
        &target,
        &mut joints,
        most(Method::Gradient),
        &mut |at| {
            kept.see(
                &at.scaled.left(at.theta),
                at.projected_gradient,
                at.arrival,
                false,
            );
        },
    );
    trace.gradient = kept.end(descent.converged);

    let mut kept = Kept::new(mechanism, &target, &scaled, closer, surplus);
    let predicted = from.clone();
    let solved = solver.solve_watched(goal, &mut from, &predicted, &mut |at| {
        let joints = scaled.left(at.theta);
        kept.see(
            &joints,
            at.projected_gradient,
            Arrival::default(),
            at.guarded,
        );
    });
    let certified = solved.end.is_minimum();
    trace.newton = kept.end(certified);
    trace.minimum = trace.newton.metric.last().copied().filter(|_| certified);
    trace
}

/// Collects a history: the last iterate is kept whatever its number.
struct Kept<'a> {
    mechanism: &'a Mechanism,
    target: &'a Target,
    scaled: &'a Scaled,
    closer: Closer,
    /// Constraints that are surplus.
    surplus: usize,
    singular_values: SingularValues,
    history: History,
    seen: usize,
    /// The last one, if it was left out.
    pending: Option<(Vec<f64>, f64, Arrival, bool)>,
}

impl<'a> Kept<'a> {
    fn new(
        mechanism: &'a Mechanism,
        target: &'a Target,
        scaled: &'a Scaled,
        closer: Closer,
        surplus: usize,
    ) -> Self {
        Self {
            mechanism,
            target,
            scaled,
            closer,
            surplus,
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
        let pose = self.mechanism.chains()[0].pose(joints);
        let theta = self.scaled.entered(joints);
        let history = &mut self.history;
        history
            .iteration
            .push(u32::try_from(number).unwrap_or(u32::MAX));
        history.metric.push(self.target.value(&pose));
        let (closure_error, misfit) = self.closer.closure(self.scaled, &theta);
        history.closure_error.push(closure_error);
        history.misfit.push(misfit);
        history.poses.push(pose);
        let values = &mut self.singular_values;
        let least =
            self.closer
                .smallest_singular_value(self.scaled, &theta, self.surplus, values, &[]);
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

//! The planner's own iterations at one frame, one by one: the paper's projected gradient (Fig. 3) and
//! Newton's method from the same position towards the same goal, and the matrix \[A\] at any of them.

use crate::document::bounds::{out_of_range, wrong_count};
use crate::document::fault::{Fault, Place};
use crate::document::problem::Problem;
use crate::math::linalg::svd;
use crate::math::pose::{self, Pose};
use crate::model::chain::Chain;
use crate::model::mechanism::Mechanism;
use crate::plan::follow::{GRADIENT_ITERATIONS, Method, NEWTON_ITERATIONS};
use crate::solve::gradient::{self, Arrival};
use crate::solve::newton::{End, Solver};
use crate::solve::paper_matrix::{self, SingularValues, linearise};
use serde::Serialize;

/// Iterates that are kept one by one; of the later ones only those this much further on.
const KEPT: usize = 60;
const THINNED: f64 = 1.03;
/// Share of the largest singular value below which one counts as zero: the rule of the default
/// planner, with lengths in units of the metric's.
const ZERO: f64 = 1e-9;

/// The iterates of one method, as columns.
#[derive(Clone, Debug, Default)]
pub struct Course {
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
    pub opening: Vec<f64>,
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
    pub gradient: Course,
    /// The default one.
    pub newton: Course,
    /// f at the minimum that Newton's method certifies; `None` if it does not.
    pub minimum: Option<f64>,
}

/// Follows both methods towards the goal of `frame` from the closed position `joints`, the answer of
/// the frame before; from the document's start if `joints` is empty. Empty courses where the loops
/// cannot be closed.
///
/// # Errors
/// When there is no such frame, or not one value a joint variable.
pub fn trace(problem: &Problem, frame: usize, joints: &[f64]) -> Result<Trace, Fault> {
    let Some(goal) = problem.goals.get(frame) else {
        let accepted = format!("0 to {}", problem.goals.len() - 1);
        let place = Place::WHOLE.field("motion");
        return Err(out_of_range(&place.field("frames"), frame, &accepted));
    };
    let goal = goal.pose;
    let (mechanism, settings) = (&problem.mechanism, &problem.settings);
    let mut from = if joints.is_empty() {
        problem.find_start()
    } else {
        check_joints(problem, joints)?;
        joints.to_vec()
    };
    // A document's own limit is meant for its own method.
    let most = |method, own| match settings.max_iterations {
        Some(most) if settings.method == method => most,
        Some(_) | None => own,
    };
    let length = settings.metric_length;
    let newton_most = most(Method::Newton, NEWTON_ITERATIONS);
    let mut solver = Solver::new(mechanism, length, newton_most);
    let mut trace = Trace {
        goal,
        gradient: Course::default(),
        newton: Course::default(),
        minimum: None,
    };
    if !solver.assemble(&mut from) {
        return Ok(trace);
    }

    let redundant = solver.redundancy(&from);
    let reference = mechanism.scaled(1.0 / length);
    let mut near = goal;
    near.translation.vector /= length;
    let mut scaled = mechanism.in_unit(&from, length);
    let mut course = Kept::new(problem, goal, &reference, redundant);
    let most = most(Method::Gradient, GRADIENT_ITERATIONS);
    let descent = gradient::descend(&reference, &near, &mut scaled, most, &mut |at| {
        let joints = mechanism.in_unit(at.joints, 1.0 / length);
        course.see(&joints, at.projected_gradient, at.arrival, false);
    });
    trace.gradient = course.end(descent.converged);

    let mut course = Kept::new(problem, goal, &reference, redundant);
    let (solved, iterates) = solver.watch(&goal, &mut from);
    for at in &iterates {
        course.see(
            &at.joints,
            at.projected_gradient,
            Arrival::default(),
            at.guarded,
        );
    }
    let certified = matches!(solved.end, End::Minimum | End::MinimumAtLimit);
    trace.newton = course.end(certified);
    trace.minimum = trace.newton.metric.last().copied().filter(|_| certified);
    Ok(trace)
}

fn check_joints(problem: &Problem, joints: &[f64]) -> Result<(), Fault> {
    let wanted = problem.mechanism.variables();
    if joints.len() == wanted {
        return Ok(());
    }
    let accepted = format!("{wanted} joint values");
    let place = Place::WHOLE.field("chains");
    Err(wrong_count(&place, joints.len(), &accepted))
}

/// Collects a course: the last iterate is kept whatever its number.
struct Kept<'a> {
    problem: &'a Problem,
    goal: Pose,
    /// The mechanism in units of the metric's length, and its dependent equations.
    reference: &'a Mechanism,
    redundant: usize,
    singular_values: SingularValues,
    course: Course,
    seen: usize,
    /// The last one, if it was left out.
    pending: Option<(Vec<f64>, f64, Arrival, bool)>,
}

impl<'a> Kept<'a> {
    fn new(problem: &'a Problem, goal: Pose, reference: &'a Mechanism, redundant: usize) -> Self {
        Self {
            problem,
            goal,
            reference,
            redundant,
            singular_values: SingularValues::default(),
            course: Course::default(),
            seen: 0,
            pending: None,
        }
    }

    fn see(&mut self, joints: &[f64], gradient: f64, arrival: Arrival, guarded: bool) {
        let last = self.course.iteration.last().copied().unwrap_or(0);
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
        let mechanism = &self.problem.mechanism;
        let pose = mechanism.chains()[0].pose(joints);
        let length = self.problem.settings.metric_length;
        let course = &mut self.course;
        course
            .iteration
            .push(u32::try_from(number).unwrap_or(u32::MAX));
        course.metric.push(pose::metric(&pose, &self.goal, length));
        course
            .opening
            .push(paper_matrix::opening(mechanism, joints, &pose));
        course.poses.push(pose);
        let scaled = mechanism.in_unit(joints, length);
        let chains = self.reference.chains();
        let least = self
            .singular_values
            .smallest(chains, &scaled, self.redundant);
        course.sigma_min.push(least);
        course.joints.push(joints.to_vec());
        course.projected_gradient.push(gradient);
        course.arrivals.push(arrival);
        course.guarded.push(guarded);
    }

    fn end(mut self, converged: bool) -> Course {
        let last = self.seen.saturating_sub(1);
        if let Some((joints, gradient, arrival, guarded)) = self.pending.take() {
            self.keep(last, &joints, gradient, arrival, guarded);
        }
        Course {
            last,
            converged,
            ..self.course
        }
    }
}

/// \[A\] of Eq. 21 at one position, in units of the metric's length.
#[derive(Clone, Debug, Serialize)]
pub struct Matrix {
    /// Row by row.
    pub values: Vec<f64>,
    /// 6 a chain and the 2 conditions of a unit dual quaternion.
    pub rows: usize,
    /// The joint variables and the 8 components of q.
    pub columns: usize,
    /// Joint variables of each chain.
    pub freedoms: Vec<usize>,
    /// Singular values, largest first (Eq. 27).
    pub singular_values: Vec<f64>,
    /// Below it a singular value counts as zero.
    pub threshold: f64,
    /// Singular values above it.
    pub rank: usize,
}

/// \[A\] at these joint values, the workpiece where the first chain puts it.
///
/// # Errors
/// When there is not one value a joint variable.
pub fn matrix(problem: &Problem, joints: &[f64]) -> Result<Matrix, Fault> {
    check_joints(problem, joints)?;
    let length = problem.settings.metric_length;
    let reference = problem.mechanism.scaled(1.0 / length);
    let scaled = problem.mechanism.in_unit(joints, length);
    let q = pose::dual_quaternion(&reference.chains()[0].pose(&scaled), 1.0);
    let rows = linearise(&reference, &scaled, &q).rows;
    let (m, n) = (rows.len(), rows[0].len());
    let values = rows.concat();
    let mut singular_values = svd(rows).sigma;
    // More equations than unknowns: the surplus ones are no singular values.
    singular_values.truncate(m.min(n));
    let threshold = ZERO * singular_values[0];
    Ok(Matrix {
        values,
        rows: m,
        columns: n,
        freedoms: reference.chains().iter().map(Chain::freedoms).collect(),
        rank: singular_values.iter().filter(|s| **s > threshold).count(),
        singular_values,
        threshold,
    })
}

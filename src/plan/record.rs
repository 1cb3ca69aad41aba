//! What is published of a frame, and what only the whole motion shows.

use crate::math::pose::{self, Pose};
use crate::model::mechanism::Mechanism;
use crate::model::scaled::{CLOSED, Scaled};
use crate::motion::goal::Goal;
use crate::motion::trajectory::{Bounds, LengthSource, Status, Trajectory, Warning};
use crate::plan::settings::{Settings, characteristic_length};
use crate::solve::gradient;
use crate::solve::singular_values::SingularValues;
use crate::solve::solver::{End, Solved, Solver};

/// Smallest singular value below which a position is reported as nearly singular: some joint rate is then a hundred
/// times the workpiece's, lengths as shares of the size.
const NEAR_SINGULAR: f64 = 1e-2;

/// An empty motion that says by what it will be judged; warns of a metric length that is far off.
pub fn begin(
    mechanism: &Mechanism,
    solver: &Solver,
    extent: f64,
    settings: &Settings,
) -> Trajectory {
    /// With a length so many times longer or shorter than the linkage's, translations or rotations hardly count; mostly
    /// it is a length of 1 that was meant in another unit.
    const FAR_OFF: f64 = 30.0;
    let tolerances = solver.tolerances();
    let metric = settings.metric_for(mechanism, extent);
    let (proposed, source) = characteristic_length(mechanism, extent);
    let projected_gradient = if settings.is_gradient() {
        gradient::CERTIFIED
    } else {
        tolerances.stationary
    };
    let mut t = Trajectory {
        variables: mechanism.variables(),
        mobility_count: mechanism.mobility_count(),
        bounds: Bounds {
            closure: CLOSED,
            misfit: settings.dimension_tolerance,
            projected_gradient,
            curvature: tolerances.flat,
            reached: tolerances.reached,
        },
        metric_used: metric,
        length_source: settings
            .metric_length
            .map_or(source, |_| LengthSource::Given),
        ..Trajectory::default()
    };
    let given = metric.length;
    if settings.metric_length.is_some()
        && source != LengthSource::None
        && !(given < FAR_OFF * proposed && proposed < FAR_OFF * given)
    {
        t.warnings.push(Warning::MetricLength { given, proposed });
    }
    t
}

/// Appends a frame. How far the loops are open is measured from the joint values that are published: anew, unless the
/// last evaluation was at the very same. `before` are the joint values of the frame before.
pub fn record(
    t: &mut Trajectory,
    solver: &mut Solver,
    goal: &Goal,
    before: &[f64],
    joints: &[f64],
    solved: &Solved,
) {
    let (theta, metric) = (solver.scaled().entered(joints), *solver.metric());
    let (scaled, closer, _) = solver.parts();
    let (closure, misfit) = closer.closure(scaled, &theta);
    let near = closer.pose_at(scaled, &theta);
    let (translation, rotation) = gaps(scaled, &near, &goal.pose);
    t.time.push(goal.time);
    t.goals.push(goal.pose);
    t.poses.push(scaled.leave_pose(&near));
    t.joints.extend_from_slice(joints);
    // The solver's value, where it has one: it has followed the sides of the quaternions.
    let value = Some(solved.value).filter(|f| f.is_finite() && solved.end != End::Runaway);
    t.metric.push(value.unwrap_or_else(|| {
        let before = scaled.chains()[0].pose(&scaled.entered(before)).rotation;
        let target = metric.target(&scaled.enter_pose(&goal.pose), &before);
        target.value(&near)
    }));
    t.translation_gap.push(translation);
    t.rotation_gap.push(rotation);
    t.closure.push(closure);
    t.misfit.push(misfit);
    t.projected_gradient.push(solved.projected_gradient);
    t.iterations
        .push(u32::try_from(solved.iterations).unwrap_or(u32::MAX));
    t.status
        .push(status(solved, closure, misfit, t.bounds.misfit));
}

/// What a frame is called. Only loops that are closed as published make it an answer.
fn status(solved: &Solved, closure: f64, misfit: f64, tolerance: f64) -> Status {
    // Written so that NaN is open.
    if !(closure <= CLOSED && misfit <= tolerance) {
        return Status::ClosureLost;
    }
    match solved.end {
        End::Open => Status::ClosureLost,
        End::Stalled | End::Runaway => Status::Stalled,
        End::Minimum | End::MinimumAtLimit if solved.reached => Status::Reached,
        End::Minimum => Status::Closest,
        End::MinimumAtLimit => Status::AtLimit,
    }
}

/// Distance of the origins in the mechanism's unit, and angle (rad), from a pose in the solver's unit to a goal.
fn gaps(scaled: &Scaled, near: &Pose, goal: &Pose) -> (f64, f64) {
    let (translation, rotation) = pose::gaps(near, &scaled.enter_pose(goal));
    (translation * scaled.unit(), rotation)
}

/// The smallest singular values of a motion's frames, computed along with the plan, so that its end takes no longer than
/// any frame. Those that are 0 because of constraints that are surplus in all frames do not count.
#[derive(Clone, Debug, Default)]
pub struct Singularity {
    /// Constraints that are surplus at the start and in all frames up to each, the start's first.
    surplus: Vec<usize>,
    /// As many were left out of the values that the motion has now.
    left_out: usize,
    values: SingularValues,
    theta: Vec<f64>,
}

impl Singularity {
    /// Computes the next value; true where there are more to compute. A frame with fewer surplus constraints than those
    /// before it makes their values wrong: they are computed again.
    pub fn advance(&mut self, t: &mut Trajectory, solver: &mut Solver) -> bool {
        let (scaled, closer, _) = solver.parts();
        // Frames may have been taken back.
        self.surplus.truncate(t.frames() + 1);
        while self.surplus.len() <= t.frames() {
            let joints = match self.surplus.len() {
                0 => &t.start,
                frame => t.joints_at(frame - 1),
            };
            // In a singular start there are more of them.
            let most = self.surplus.last().copied().unwrap_or(usize::MAX);
            self.surplus.push(match most {
                0 => 0,
                _ => closer.mobility(scaled, &scaled.entered(joints)).1.min(most),
            });
        }
        let surplus = self.surplus[t.frames()];
        if surplus != self.left_out {
            self.left_out = surplus;
            t.sigma_min.clear();
        }
        let frame = t.sigma_min.len();
        if frame < t.frames() {
            self.theta.resize(t.variables, 0.0);
            scaled.enter(t.joints_at(frame), &mut self.theta);
            let value = closer.smallest_singular_value(
                scaled,
                &self.theta,
                surplus,
                &mut self.values,
                &t.sigma_min,
            );
            t.sigma_min.push(value);
        }
        t.sigma_min.len() < t.frames()
    }

    /// Computes all that are left, and warns of the runs of frames that are nearly singular.
    pub fn finish(mut self, t: &mut Trajectory, solver: &mut Solver) {
        while self.advance(t, solver) {}
        warn_of_singular(t);
    }
}

/// Frames at which a misfit is looked into: one alone may be explained by a number that has nothing to do with it.
const LOOKED_AT: usize = 9;

/// Warns of dimensions that contradict each other, and names the number that may be at fault.
pub fn warn_of_rounded(t: &mut Trajectory, solver: &mut Solver) {
    let misfit = t.misfit.iter().copied().fold(0.0, f64::max);
    if misfit > CLOSED {
        let step = t.frames().div_ceil(LOOKED_AT);
        let frames = (0..t.frames()).step_by(step);
        let positions: Vec<&[f64]> = frames.map(|frame| t.joints_at(frame)).collect();
        let suspect = solver.suspect(&positions);
        t.warnings.push(Warning::RoundedDimensions {
            misfit,
            tolerance: t.bounds.misfit,
            suspect,
        });
    }
}

fn warn_of_singular(t: &mut Trajectory) {
    // At a position whose loops are open it says nothing.
    let is_near = |frame: &usize| {
        t.sigma_min[*frame] < NEAR_SINGULAR && t.status[*frame] != Status::ClosureLost
    };
    let mut frame = 0;
    while frame < t.frames() {
        let run = (frame..t.frames()).take_while(is_near).count();
        if run > 0 {
            let (first, last) = (frame, frame + run - 1);
            let smallest = t.sigma_min[first..=last]
                .iter()
                .copied()
                .fold(f64::INFINITY, f64::min);
            t.warnings.push(Warning::NearSingular {
                first,
                last,
                smallest,
                bound: NEAR_SINGULAR,
            });
        }
        frame += run + 1;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::problem::Problem;
    use crate::document::text;

    fn solved(end: End) -> Solved {
        Solved {
            end,
            reached: false,
            value: 0.1,
            projected_gradient: 0.0,
            iterations: 1,
        }
    }

    /// Its loops have surplus constraints.
    fn four_bar() -> Problem {
        let document = text::parse(include_str!("../../www/mechanisms/four-bar.json"));
        Problem::new(&document.expect("a sample")).expect("a problem")
    }

    /// Whatever the solver says, open loops are not published as an answer.
    #[test]
    fn open_loops_are_lost() {
        let minimum = solved(End::Minimum);
        assert_eq!(status(&minimum, 1e-11, 0.0, 0.0), Status::Closest);
        for closure in [1.1e-10, 1e-8, 1e-6, f64::NAN, f64::INFINITY] {
            assert_eq!(
                status(&minimum, closure, 0.0, 1e-4),
                Status::ClosureLost,
                "{closure}"
            );
        }
    }

    /// Rounded dimensions are published up to the tolerance.
    #[test]
    fn a_misfit_beyond_the_tolerance_is_lost() {
        let minimum = solved(End::Minimum);
        assert_eq!(status(&minimum, 0.0, 9e-5, 1e-4), Status::Closest);
        assert_eq!(status(&minimum, 0.0, 1.1e-4, 1e-4), Status::ClosureLost);
        assert_eq!(status(&minimum, 0.0, f64::NAN, 1e-4), Status::ClosureLost);
    }

    /// Values computed along with the plan are those that are computed at its end, also where the surplus constraints get
    /// fewer on the way, and the last step is no longer than another.
    #[test]
    fn singular_values_come_along() {
        let problem = four_bar();
        let mut planning = problem.planning(&problem.find_start());
        let mut steps = 1;
        while planning.advance() {
            steps += 1;
        }
        assert_eq!(steps, planning.frames());
        let mut t = planning.so_far();
        let along = std::mem::take(&mut t.sigma_min);
        let mut solver = problem.settings.solver(&problem.mechanism, 1.0);
        // Computed where more constraints were surplus, as in a singular start.
        t.sigma_min = vec![0.5; 3];
        let mut more = Singularity {
            surplus: vec![usize::MAX; 4],
            left_out: usize::MAX,
            ..Singularity::default()
        };
        while more.advance(&mut t, &mut solver) {}
        assert_eq!(t.sigma_min, along);
        t.truncate(20);
        while more.advance(&mut t, &mut solver) {}
        assert_eq!(t.sigma_min, along[..20]);
    }

    /// The loops are looked at once more before a frame is published, whatever the solver says of it.
    #[test]
    fn the_closure_is_measured_anew() {
        let problem = four_bar();
        let (mechanism, settings) = (&problem.mechanism, &problem.settings);
        let mut solver = settings.solver(mechanism, 1.0);
        let mut joints = problem.find_start();
        assert!(solver.close_start(&mut joints, 0.0).is_closed());
        let before = joints.clone();
        joints[0] += 1e-6;
        let mut t = begin(mechanism, &solver, 1.0, settings);
        record(
            &mut t,
            &mut solver,
            &problem.goals[0],
            &before,
            &joints,
            &solved(End::Minimum),
        );
        assert_eq!(t.status, [Status::ClosureLost]);
        assert!(t.closure[0] > 1e-8, "{:e}", t.closure[0]);
    }
}

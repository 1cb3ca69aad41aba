//! One configuration outside any motion: the closest reachable pose to a goal, or one joint driven to a value.

use crate::math::pose::Pose;
use crate::model::mechanism::Mechanism;
use crate::motion::goal::Goal;
use crate::motion::trajectory::Trajectory;
use crate::plan::given::close_start;
use crate::plan::record::{Singularity, begin, record};
use crate::plan::settings::Settings;
use crate::solve::drive::{self, Obstacle};
use crate::solve::solver::{End, Solved, Solver};

/// A configuration as a motion of one frame.
#[derive(Clone, Debug)]
pub struct Configuration {
    /// The one frame.
    pub frame: Trajectory,
    /// What kept a driven joint from its value.
    pub obstacle: Option<Obstacle>,
}

/// The closest reachable pose to `goal`, from the closed position `from` along its branch, by Newton's
/// method; certified as the frames of a plan are. `extent` is that of the motion; see [`Settings::metric_for`].
///
/// # Panics
/// When `from` does not have one value a joint variable.
pub fn pull(
    mechanism: &Mechanism,
    from: &[f64],
    goal: &Pose,
    extent: f64,
    settings: &Settings,
) -> Configuration {
    move_from(mechanism, from, extent, settings, |solver, joints| {
        let predicted = joints.to_vec();
        let solved = solver.solve(goal, joints, &predicted);
        (solved, Some(*goal), None)
    })
}

/// Drives one joint variable to `value`, from the closed position `from`; see [`drive::drive`].
///
/// # Panics
/// When `from` does not have one value a joint variable, or there is no such variable.
pub fn drive_joint(
    mechanism: &Mechanism,
    from: &[f64],
    variable: usize,
    value: f64,
    extent: f64,
    settings: &Settings,
) -> Configuration {
    move_from(mechanism, from, extent, settings, |solver, joints| {
        let (scaled, closer, _) = solver.parts();
        let driven = drive::drive(scaled, closer, joints, variable, value);
        let solved = Solved {
            end: End::Minimum,
            // The pose is its own goal.
            reached: true,
            value: 0.0,
            projected_gradient: 0.0,
            iterations: driven.iterations,
        };
        (solved, None, driven.obstacle)
    })
}

/// Closes the loops where `from` leaves them open, moves, and records where that led.
fn move_from(
    mechanism: &Mechanism,
    from: &[f64],
    extent: f64,
    settings: &Settings,
    go: impl FnOnce(&mut Solver, &mut [f64]) -> (Solved, Option<Pose>, Option<Obstacle>),
) -> Configuration {
    let newton = settings.by_newton();
    let mut solver = newton.solver(mechanism, extent);
    let mut t = begin(mechanism, &solver, extent, &newton);
    let mut joints = from.to_vec();
    let closed = close_start(&mut solver, &mut joints, settings, &mut t.warnings);
    t.start.clone_from(&joints);
    let (solved, goal, obstacle) = if closed {
        go(&mut solver, &mut joints)
    } else {
        (Solved::OPEN, None, Some(Obstacle::Open))
    };
    // Of a driven joint the reached pose, computed as it is published.
    let pose = goal.unwrap_or_else(|| {
        let scaled = solver.scaled();
        scaled.leave_pose(&scaled.chains()[0].pose(&scaled.entered(&joints)))
    });
    let goal = Goal { time: 0.0, pose };
    let start = t.start.clone();
    record(&mut t, &mut solver, &goal, &start, &joints, &solved);
    Singularity::default().finish(&mut t, &mut solver);
    Configuration { frame: t, obstacle }
}

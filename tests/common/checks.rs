//! What every planned motion must keep, and short ways to a linkage and its goals.

use synthetica::math::pose::{FrameCoordinates, Pose};
use synthetica::model::chain::Chain;
use synthetica::model::mechanism::Mechanism;
use synthetica::model::scaled::CLOSED;
use synthetica::model::scaled::Scaled;
use synthetica::motion::goal::Goal;
use synthetica::motion::trajectory::{Status, Trajectory, Warning};
use synthetica::plan::follow::plan;
use synthetica::plan::settings::{Method, Settings};

pub const NEWTON: Settings = Settings::PAPER;
pub const GRADIENT: Settings = Settings {
    method: Method::Gradient,
    ..NEWTON
};

/// How far the loops are open, as it is published.
pub fn open(mechanism: &Mechanism, joints: &[f64]) -> f64 {
    let scaled = Scaled::new(mechanism, 1.0);
    scaled.closure_error(&scaled.entered(joints))
}

/// The chains' linkage.
pub fn mechanism(chains: Vec<Chain>) -> Mechanism {
    Mechanism::new(chains).expect("a mechanism")
}

/// A frame at a point, turned by longitude, latitude and roll (rad).
pub fn at(x: f64, y: f64, z: f64, longitude: f64, latitude: f64, roll: f64) -> Pose {
    FrameCoordinates {
        x,
        y,
        z,
        longitude,
        latitude,
        roll,
    }
    .pose()
}

/// `frames` goals from one pose to another, the first step's end first.
pub fn between(from: &Pose, to: &Pose, frames: usize) -> Vec<Goal> {
    let goal = |i: usize| {
        let s = i as f64 / frames as f64;
        let rotation = from.rotation.nlerp(&to.rotation, s);
        let translation = from.translation.vector.lerp(&to.translation.vector, s);
        Goal {
            time: s,
            pose: Pose::from_parts(translation.into(), rotation),
        }
    };
    (1..=frames).map(goal).collect()
}

/// Poses as goals, a unit of time apart.
pub fn goals(poses: &[Pose]) -> Vec<Goal> {
    poses
        .iter()
        .enumerate()
        .map(|(i, &pose)| Goal {
            time: i as f64,
            pose,
        })
        .collect()
}

/// What holds of any plan whatever its end: columns of equal length, loops closed where the status
/// says so, nothing that is not a number.
pub fn is_honest(name: &str, t: &Trajectory, frames: usize) {
    assert_eq!(t.frames(), frames, "{name}");
    let columns = [
        &t.time,
        &t.metric,
        &t.translation_gap,
        &t.rotation_gap,
        &t.closure,
        &t.misfit,
        &t.sigma_min,
        &t.projected_gradient,
    ];
    assert!(columns.iter().all(|c| c.len() == frames), "{name}");
    assert_eq!(
        (t.joints.len(), t.poses.len()),
        (frames * t.variables, frames),
        "{name}"
    );
    for (i, status) in t.status.iter().enumerate() {
        assert!(
            t.joints_at(i).iter().all(|x| x.is_finite()),
            "{name}, frame {i}: {:?}",
            t.joints_at(i)
        );
        let lost = *status == Status::ClosureLost;
        assert!(
            lost || t.closure[i] <= CLOSED,
            "{name}, frame {i}: {status:?}, open by {:e}",
            t.closure[i]
        );
        let numbers = [
            t.metric[i],
            t.translation_gap[i],
            t.rotation_gap[i],
            t.closure[i],
            t.sigma_min[i],
        ];
        assert!(
            numbers.iter().all(|x| x.is_finite()),
            "{name}, frame {i}: {numbers:?}"
        );
        assert!(
            lost || t.projected_gradient[i].is_finite(),
            "{name}, frame {i}"
        );
        assert!((0.0..=1.0).contains(&t.sigma_min[i]), "{name}, frame {i}");
    }
}

/// Every frame is a certified optimum.
pub fn is_certified(name: &str, t: &Trajectory, frames: usize) {
    is_honest(name, t, frames);
    for (i, status) in t.status.iter().enumerate() {
        assert!(
            status.is_certified(),
            "{name}, frame {i}: {status:?}, projected gradient {:e}, f {}, {} iterations, {:?}, {:?}",
            t.projected_gradient[i],
            t.metric[i],
            t.iterations[i],
            t.joints_at(i),
            t.warnings,
        );
    }
}

/// Every frame meets its goal.
pub fn is_reached(name: &str, t: &Trajectory) {
    is_certified(name, t, t.frames());
    for (i, status) in t.status.iter().enumerate() {
        assert_eq!(
            *status,
            Status::Reached,
            "{name}, frame {i}: f {:e}",
            t.metric[i]
        );
    }
}

/// Plans `goals`, which the linkage need not reach, with both methods, and then the poses it got
/// to: all certified, both agree, and what was reached once is reached again.
pub fn both_ways(name: &str, m: &Mechanism, start: &[f64], goals: &[Goal]) -> Trajectory {
    let newton = plan(m, start, goals, &NEWTON);
    is_certified(name, &newton, goals.len());
    let gradient = plan(m, start, goals, &GRADIENT);
    is_certified(&format!("{name} by gradient"), &gradient, goals.len());
    for i in 0..goals.len() {
        let (n, g) = (newton.metric[i], gradient.metric[i]);
        // The gradient stops at a slope of 1e-7: 1e-14 of f by the curvature, here above 1e-4.
        assert!(
            (n - g).abs() <= 1e-10,
            "{name}, frame {i}: f {n} by newton, {g} by gradient"
        );
    }
    let again = plan(m, start, &self::goals(&newton.poses), &NEWTON);
    is_certified(&format!("{name} along its own motion"), &again, goals.len());
    // Where the pose is on the workspace's boundary f is of fourth order, and a slope of 1e-9 leaves
    // more of it than "reached" allows.
    assert!(
        again.metric.iter().all(|f| *f <= 1e-12),
        "{name} along its own motion: {:?}",
        again.metric
    );
    newton
}

/// Count and rank of a linkage, and the warning where they differ.
pub fn has_mobility(name: &str, t: &Trajectory, count: isize, rank: usize) {
    assert_eq!((t.mobility_count, t.mobility_rank), (count, rank), "{name}");
    let warned = t
        .warnings
        .contains(&Warning::MobilityDiffers { count, rank });
    assert_eq!(
        warned,
        usize::try_from(count) != Ok(rank),
        "{name}: {:?}",
        t.warnings
    );
}

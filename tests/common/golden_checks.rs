//! The golden motions as assertions without files or clocks, for the native tests and for wasm.

use super::golden::{Task, tasks};
use synthetica::motion::trajectory::{Status, Trajectory};
use synthetica::plan::follow::plan;
use synthetica::plan::settings::{Method, Settings};
use synthetica::solve::gradient;

/// Opening of a loop that the reference and the planners must keep.
const CLOSURE: f64 = 1e-10;
/// What a planner's f may be above the reference's.
const METRIC: f64 = 1e-9;

fn planned(task: &Task, method: Method, frames: usize) -> Trajectory {
    plan(
        &task.mechanism,
        &task.start,
        &task.goals[..frames],
        &Settings {
            method,
            ..Settings::PAPER
        },
    )
}

/// Newton closes every frame, is as close to every goal as the reference, and certifies it.
pub fn newton_is_as_close_as_the_reference() {
    for task in tasks() {
        let t = planned(&task, Method::Newton, task.goals.len());
        assert_eq!(t.frames(), task.reference.len());
        assert_eq!(
            usize::try_from(t.mobility_count),
            Ok(t.mobility_rank),
            "{}",
            task.name
        );
        for (i, (_, f)) in task.reference.iter().enumerate() {
            let name = format!("{}, frame {i}: {:?}", task.name, t.status[i]);
            assert!(
                t.closure[i] <= CLOSURE,
                "{name}: open by {:e}",
                t.closure[i]
            );
            assert!(
                t.metric[i] <= f + METRIC,
                "{name}: f is above the reference by {:e}",
                t.metric[i] - f
            );
            assert!(t.status[i].is_certified(), "{name}");
        }
    }
}

/// The paper's gradient descends to the same minima as Newton, over the first `frames` of each task.
///
/// Looser than for Newton, since it stops at a small slope |a| ([`gradient::STATIONARY`]): f is
/// then within |a|² / 2κ of the minimum, κ the curvature along r. The least κ on these motions is
/// 5e-7 (3RPS, frame 27, near gimbal lock): 1e-8.
///
/// The 2TS begins so near to gimbal lock that unit steps would take millions of iterations for frames
/// 1 to 3: they must say that they are stalled, and be no lower than Newton's.
pub fn gradient_finds_the_same_minimum(frames: usize) {
    const CURVATURE: f64 = 5e-7;
    let bound = gradient::STATIONARY * gradient::STATIONARY / (2.0 * CURVATURE);
    for task in tasks() {
        let newton = planned(&task, Method::Newton, frames);
        let t = planned(&task, Method::Gradient, frames);
        for i in 0..frames {
            let name = format!("{}, frame {i}: {:?}", task.name, t.status[i]);
            let above = t.metric[i] - newton.metric[i];
            assert!(
                t.closure[i] <= CLOSURE,
                "{name}: open by {:e}",
                t.closure[i]
            );
            assert!(
                above >= -bound,
                "{name}: f is below Newton's by {:e}",
                -above
            );
            if task.name == "2TS" && (1..=3).contains(&i) {
                assert_eq!(t.status[i], Status::Stalled, "{name}");
            } else {
                assert!(t.status[i].is_certified(), "{name}");
                assert!(above <= bound, "{name}: f is above Newton's by {above:e}");
            }
        }
    }
}

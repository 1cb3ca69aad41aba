//! Motions that an independent program computed, and what its file says of itself.

#[path = "common/dense.rs"]
mod dense;
#[path = "common/golden.rs"]
mod golden;
#[path = "common/golden_checks.rs"]
mod golden_checks;

use golden::tasks;
use nalgebra::{Isometry3, Vector3};
use synthetica::math::metric::Metric;
use synthetica::model::scaled::Scaled;
use synthetica::plan::follow::plan;
use synthetica::plan::settings::Settings;

#[test]
fn newton_is_as_close_as_the_reference() {
    golden_checks::newton_is_as_close_as_the_reference();
}

#[test]
fn gradient_finds_the_same_minimum() {
    golden_checks::gradient_finds_the_same_minimum(33);
}

/// The reference's own joint values close our loops and have the f it says: our conventions (rows,
/// frames, dual quaternions, metric) are the file's.
#[test]
fn reference_closes_and_measures_the_same() {
    for task in tasks() {
        for (i, (joints, f)) in task.reference.iter().enumerate() {
            let pose: Isometry3<f64> = task.mechanism.chains()[0].pose(joints);
            // In the file's unit: lengths and angles as they are.
            let file = Scaled::about(&task.mechanism, 1.0, &Vector3::zeros());
            let open = file.closure_error(joints);
            assert!(open <= 1e-9, "{}, frame {i}: open by {open:e}", task.name);
            let ours = Metric::PAPER.value(&pose, &task.goals[i].pose);
            assert!(
                (ours - f).abs() <= 1e-9,
                "{}, frame {i}: f {ours} for {f}",
                task.name
            );
        }
    }
}

/// The singular values that we report are those of the dense [A] in their unit and about their point; along the
/// reference's branch the paper's, in the file's unit and about the fixed frame's origin, have the file's minimum.
#[test]
fn smallest_singular_value() {
    for task in tasks() {
        let m = &task.mechanism;
        let t = plan(m, &task.start, &task.goals, &Settings::PAPER);
        for i in 0..t.frames() {
            let least = smallest(&dense::singular_values(m, t.joints_at(i)));
            // The dense decomposition errs by about 1e-15 of the largest value, which is below 10.
            assert!(
                (t.sigma_min[i] - least).abs() < 1e-9 * least + 1e-13,
                "{}, frame {i}: {} for {least}",
                task.name,
                t.sigma_min[i]
            );
        }
        let papers = |joints: &[f64]| {
            smallest(&dense::singular_values_about(
                m,
                1.0,
                &Vector3::zeros(),
                joints,
            ))
        };
        let on_branch = task.reference.iter().map(|(joints, _)| papers(joints));
        let least = on_branch.fold(f64::INFINITY, f64::min);
        let told = task.min_sigma.expect("the file has it");
        assert!(
            (least - told).abs() <= 1e-6 * told.max(1e-2),
            "{}: {least} for {told}",
            task.name
        );
        // The planner's branch is the reference's, unless it found a better one.
        let same = task
            .reference
            .iter()
            .enumerate()
            .all(|(i, (_, f))| (t.metric[i] - f).abs() < 1e-9);
        let ours = (0..t.frames())
            .map(|i| papers(t.joints_at(i)))
            .fold(f64::INFINITY, f64::min);
        assert!(
            !same || (ours - told).abs() <= 1e-5 * told.max(1e-2),
            "{}: {ours} for {told}",
            task.name
        );
    }
}

fn smallest(sigma: &[f64]) -> f64 {
    *sigma.last().expect("a matrix")
}

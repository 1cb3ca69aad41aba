//! Motions that an independent program computed, and what its file says of itself.

#[path = "common/golden.rs"]
mod golden;
#[path = "common/golden_checks.rs"]
mod golden_checks;

use golden::tasks;
use nalgebra::Isometry3;
use synthetica::math::metric::Metric;
use synthetica::math::linalg::svd;
use synthetica::math::pose::{dual_quaternion, metric};
use synthetica::plan::follow::{plan};
use synthetica::plan::settings::{Settings};
use synthetica::solve::paper_matrix::{linearise, opening};

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
            let open = opening(&task.mechanism, joints, &pose);
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

/// The singular values that we report along the reference's branch are those of the dense [A], and
/// their minimum is the file's.
#[test]
fn smallest_singular_value() {
    for task in tasks() {
        let t = plan(
            &task.mechanism,
            &task.start,
            &task.goals,
            &Settings::PAPER,
        );
        for i in 0..t.frames() {
            let q = dual_quaternion(&t.poses[i], 1.0);
            let dense = svd(linearise(task.mechanism.chains(), t.joints_at(i), &q).rows).sigma;
            let least = dense.last().expect("a matrix");
            // The root of an eigenvalue: an error of 1e-15 of the largest becomes 1e-15/σ.
            assert!(
                (t.sigma_min[i] - least).abs() < 1e-14 / least + 1e-12,
                "{}, frame {i}",
                task.name
            );
        }
        let on_branch = task.reference.iter().map(|(joints, _)| {
            let q = dual_quaternion(&task.mechanism.chains()[0].pose(joints), 1.0);
            *svd(linearise(task.mechanism.chains(), joints, &q).rows)
                .sigma
                .last()
                .expect("a matrix")
        });
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
        let ours = t.sigma_min.iter().copied().fold(f64::INFINITY, f64::min);
        assert!(
            !same || (ours - told).abs() <= 1e-5 * told.max(1e-2),
            "{}: {ours} for {told}",
            task.name
        );
    }
}

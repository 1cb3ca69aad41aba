//! What a frame costs: `cargo bench`.
//!
//! Every figure is set beside one dense SVD (with U and V) of the same linkage's [A] by nalgebra,
//! measured in turn with it, so that the ratio holds on a noisy machine. A general benchmark harness
//! times one thing after the other and prints no ratio; hence these few lines.

#![expect(
    clippy::disallowed_types,
    reason = "the dense SVD that is compared with"
)]

#[path = "../tests/common/mod.rs"]
mod common;

use nalgebra::DMatrix;
use std::hint::black_box;
use std::time::Instant;
use synthetica::math::pose::{self, DualQuaternion};
use synthetica::model::mechanism::Mechanism;
use synthetica::motion::goal::Goal;
use synthetica::plan::follow::plan;
use synthetica::plan::predict::predict;
use synthetica::plan::settings::{Settings, extent};
use synthetica::solve::paper_matrix::linearise;

/// Rounds of which the median is taken.
const ROUNDS: usize = 41;

fn main() {
    println!("one frame against one dense SVD of the same [A] (median of {ROUNDS} rounds, µs)");
    println!(
        "{:10} {:>9} {:>9} {:>7} {:>12} {:>7}",
        "", "svd", "frame", "ratio", "with report", "ratio"
    );
    for task in common::golden::tasks() {
        row(&task.name, &task.mechanism, &task.start, &task.goals);
    }
    println!("\nrandom linkages of k chains");
    for k in 1..=5 {
        let mut random = common::Random(7);
        let kinds: Vec<_> = (0..k)
            .map(|_| synthetica::types::enumerate::chain(1, 60).expect("in range"))
            .collect();
        let linkage = common::linkage(&kinds, &mut random);
        let goals = common::goals(&linkage, 33, &mut random);
        row(
            &format!("k = {k}"),
            &linkage.mechanism,
            &linkage.home,
            &goals,
        );
    }
    println!("\nmore frames of the same motion (3RPS)");
    let task = common::golden::tasks().swap_remove(1);
    for frames in [33, 330, 3300] {
        let goals: Vec<Goal> = (0..frames)
            .map(|i| between(&task.goals, i as f64 / (frames - 1) as f64))
            .collect();
        row(&format!("{frames}"), &task.mechanism, &task.start, &goals);
    }
    // Those have a bend at each of the 33; this goes through them as the spline of a document does, without any.
    let goals: Vec<Goal> = (0..129)
        .map(|i| smooth(&task.goals, i as f64 / 128.0))
        .collect();
    row("129 smooth", &task.mechanism, &task.start, &goals);
}

fn row(name: &str, mechanism: &Mechanism, start: &[f64], goals: &[Goal]) {
    let settings = Settings::PAPER;
    let motion = plan(mechanism, start, goals, &settings);
    let matrices: Vec<DMatrix<f64>> = (0..motion.frames())
        .step_by(motion.frames() / 33)
        .map(|i| {
            let q = pose::dual_quaternion(&motion.poses[i], 1.0);
            let rows = linearise(mechanism.chains(), motion.joints_at(i), &q).rows;
            DMatrix::from_fn(rows.len(), rows[0].len(), |i, j| rows[i][j])
        })
        .collect();
    let mut times = [vec![], vec![], vec![]];
    for _ in 0..ROUNDS {
        let clock = Instant::now();
        for a in &matrices {
            black_box(a.clone().svd(true, true));
        }
        times[0].push(clock.elapsed().as_secs_f64() / matrices.len() as f64);
        let clock = Instant::now();
        frames_alone(mechanism, &motion.start, goals);
        times[1].push(clock.elapsed().as_secs_f64() / goals.len() as f64);
        let clock = Instant::now();
        black_box(plan(mechanism, start, goals, &settings));
        times[2].push(clock.elapsed().as_secs_f64() / goals.len() as f64);
    }
    let [svd, frame, report] = times.map(|mut t| {
        t.sort_by(f64::total_cmp);
        t[t.len() / 2] * 1e6
    });
    println!(
        "{name:10} {svd:9.2} {frame:9.2} {:7.2} {report:12.2} {:7.2}",
        frame / svd,
        report / svd
    );
}

/// The frames as the planner solves them, without its report.
fn frames_alone(mechanism: &Mechanism, start: &[f64], goals: &[Goal]) {
    let mut solver = Settings::PAPER.solver(mechanism, extent(goals));
    let mut joints = start.to_vec();
    let mut predicted = start.to_vec();
    let mut history: Vec<f64> = Vec::with_capacity(start.len() * goals.len());
    solver.close_start(&mut joints, Settings::PAPER.dimension_tolerance);
    for goal in goals {
        predict(solver.scaled(), &history, &joints, &mut predicted);
        black_box(solver.solve(&goal.pose, &mut joints, &predicted));
        history.extend_from_slice(&joints);
    }
}

fn between(goals: &[Goal], s: f64) -> Goal {
    let place = s * (goals.len() - 1) as f64;
    let i = (0..goals.len() - 1)
        .rev()
        .find(|&i| i as f64 <= place)
        .unwrap_or(0);
    let (a, b) = (&goals[i], &goals[i + 1]);
    let pose = a.pose.lerp_slerp(&b.pose, place - i as f64);
    Goal { time: s, pose }
}

/// The cubic polynomial through the two frames on either side.
fn smooth(goals: &[Goal], s: f64) -> Goal {
    let place = s * (goals.len() - 1) as f64;
    let first = (0..goals.len() - 3)
        .rev()
        .find(|&i| (i + 1) as f64 <= place)
        .unwrap_or(0);
    let mut sum = DualQuaternion::zeros();
    let mut near = pose::dual_quaternion(&goals[first].pose, 1.0);
    for i in first..first + 4 {
        let others = (first..first + 4).filter(|&j| j != i);
        let weight: f64 = others
            .map(|j| (place - j as f64) / (i as f64 - j as f64))
            .product();
        let q = pose::dual_quaternion(&goals[i].pose, 1.0);
        near = if q.dot(&near) < 0.0 { -q } else { q };
        sum += near * weight;
    }
    let pose = pose::from_dual_quaternion(&sum, 1.0);
    Goal { time: s, pose }
}
